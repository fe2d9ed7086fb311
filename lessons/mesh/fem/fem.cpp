// The start, and what the stages do.
#include "fem.h"

#include <pliant/continuum/deformation.h>
#include <pliant/solids/manufactured_solution.h>
#include <pliant/text/format.h>
#include <pliant/text/stored_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::fem {
namespace {

// Passes of an assembly, at most: larger bodies take several elements at once, and so does every round after the first.
constexpr Index most_passes = 48, later_passes = 6;

}  // namespace

FemLesson::FemLesson() {
    declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_lines(), declare_checks();
}

solid_mesh::BodySettings FemLesson::settings() const {
    solid_mesh::BodySettings s = body.settings(shape(), order());
    s.law = law();
    if (is(Setting::own)) s.file = file(), s.file_name = file_name();
    return s;
}

std::string FemLesson::file_name() const { return stored_file(file_number()).name; }

Index FemLesson::file_number() const {
    static constexpr std::array<std::string_view, 1> endings{".msh"};
    return mesh_file.given() ? static_cast<Index>(mesh_file.value()) : store_file("gear_coarse", endings);
}

const std::shared_ptr<const MeshFile>& FemLesson::file() const {
    return file_.of(file_number(), [this] {
        const StoredFile& stored = stored_file(file_number());
        return std::make_shared<const MeshFile>(parse_mesh_file(stored.bytes, stored.name));
    });
}

int FemLesson::dimension_of_file() const {
    try {
        return file()->dimension() == 2 ? 2 : 3;
    } catch (const Refused&) {
        return 3;
    }
}

// A body from a file is made to see that it is one.
void FemLesson::check() const {
    body.check(settings(), in_plane(), has_law());
    if (is(Setting::own)) solid_mesh::make_solid(settings());
}

void FemLesson::reset() {
    solid_ = solid_mesh::make_solid(settings());
    std::vector<Index> held = solid_->fixed_nodes();
    if (is(Setting::twist) && turned == Turned::end)
        held.insert(held.end(), solid_->loaded_nodes().begin(), solid_->loaded_nodes().end());
    if (is(Setting::spin) || is(Setting::drop)) held.clear();
    motion_.reset();
    frequency_.forget();
    solid_->hold(held, !moving());
    done_.setZero(), clock_.setZero();
    solved_pull_.reset();
    pulled_ever_ = false;
    clear();
    position_ = solid_->rest();
    for (MatX* nodal : {&velocity_, &damping_force_, &external_force_, &total_force_})
        nodal->setZero(position_.rows(), position_.cols());
    if (moving()) start_moving();
    for (Field& f : fields)
        if (f.rank != Rank::scalar) f.components = f.rank == Rank::vector ? solid_->dim() : solid_->dim() * solid_->dim();
}

// Every solve begins anew.
void FemLesson::clear() {
    const Index d = solid_->dim(), nodes = solid_->node_count(), elements = solid_->element_count();
    for (MatX* nodal :
         {&displacement_, &load_, &prescribed_, &internal_, &residual_, &newton_step_, &reaction_, &assembled_, &before_})
        nodal->setZero(d, nodes);
    for (MatX* tensors : {&deformation_, &rotation_, &strain_, &stress_, &block_}) tensors->setZero(d * d, elements);
    for (Index k = 0; k < d; ++k) deformation_.row((d + 1) * k).setOnes(), rotation_.row((d + 1) * k).setOnes();
    volume_.setZero(elements), mises_.setZero(elements);
    advancing_ = false, level_ = 0, next_element_ = first_of_pass_ = 0, assembled_once_ = false;
    course_.setZero(4, levels() + 1), course_length_ = 1;
    errors_.reset();
}

// Only what the hand does to a node matters to the solve.
void FemLesson::pull(const std::optional<Pull>& hand) {
    pull_ = hand;
    if (pull_ && (pull_->index < 0 || pull_->index >= solid_->node_count())) pull_.reset();
}

// ------------------------------------------------------------------------------------------------------------- elements

void FemLesson::shape_functions() {
    clear();
    done_.setZero();
    solved_pull_ = pull_;
    volume_ = solid_->volumes();
}

void FemLesson::put(MatX& tensors, Index element, const Small& value) const {
    const int d = solid_->dim();
    for (int i = 0; i < d; ++i)
        for (int j = 0; j < d; ++j) tensors(d * i + j, element) = value(i, j);
}

Small FemLesson::taken(const MatX& tensors, Index element) const {
    const int d = solid_->dim();
    Small value(d, d);
    for (int i = 0; i < d; ++i)
        for (int j = 0; j < d; ++j) value(i, j) = tensors(d * i + j, element);
    return value;
}

void FemLesson::deform() {
    if (moving()) follow_positions();
    for (Index e = 0; e < solid_->element_count(); ++e) put(deformation_, e, solid_->deformation(e, displacement_));
}

void FemLesson::turn() {
    for (Index e = 0; e < solid_->element_count(); ++e) put(rotation_, e, solid_->rotation(taken(deformation_, e)));
}

void FemLesson::measure_strain() {
    for (Index e = 0; e < solid_->element_count(); ++e) put(strain_, e, solid_->strain(taken(deformation_, e)));
}

void FemLesson::evaluate_stress() {
    for (Index e = 0; e < solid_->element_count(); ++e) {
        const Small F = taken(deformation_, e);
        put(stress_, e, solid_->stress(F));
        mises_[e] = solid_->von_mises(F);
    }
}

void FemLesson::internal_forces() { solid_->internal_force(displacement_, internal_); }

// ------------------------------------------------------------------------------------------------------------- assembly

// The stiffness of the linear law stays what it is.
void FemLesson::begin_assembly() {
    if (law() == Law::linear && assembled_once_) return;
    next_element_ = first_of_pass_ = 0;
    assembled_.setZero();
}

void FemLesson::assemble() {
    const Index count = solid_->element_count(), passes = done_[1] == 0 ? most_passes : later_passes,
                batch = (count + passes - 1) / passes, d = solid_->dim();
    first_of_pass_ = next_element_;
    for (; next_element_ < std::min(count, first_of_pass_ + batch); ++next_element_) {
        const MatX K = solid_->element_stiffness(next_element_, displacement_);
        put(block_, next_element_, K.topLeftCorner(d, d));
        for (int a = 0; a < solid_->nodes_of_element(); ++a)
            assembled_.col(solid_->node(next_element_, a)) += K.diagonal().segment(d * a, d);
    }
    assembled_once_ = next_element_ == count;
}

// ---------------------------------------------------------------------------------------------------- load and supports

Small FemLesson::turning(Real part) const {
    Small R = Small::Identity(3, 3);
    const Real angle = twist_angle * one_degree * part;
    R(1, 1) = R(2, 2) = std::cos(angle), R(2, 1) = std::sin(angle), R(1, 2) = -R(2, 1);
    return R;
}

void FemLesson::full_load(MatX& load) const {
    load.setZero(solid_->dim(), solid_->node_count());
    if (is(Setting::manufactured)) {
        const Lame material = solid_->lame();
        load = material.lambda * solid_->plane_load(manufactured::force_of_lambda) +
               material.mu * solid_->plane_load(manufactured::force_of_mu);
    }
    if (!bent()) return;
    const VecX& area = solid_->loaded_area();
    for (int c = 0; c < solid_->dim(); ++c) load.row(c) = force()[c] / area.sum() * area.transpose();
    if (solved_pull_)
        load.col(solved_pull_->index) += (pull_stiffness * (solved_pull_->to - solved_pull_->from)).head(solid_->dim());
}

void FemLesson::raise_level() {
    level_ += 1;
    full_load(load_);
    load_ *= share();
    prescribed_.setZero();
    if (!is(Setting::twist)) return;
    // About the axis of the beam.
    const Vec<3> axis(0, body.height / 2, body.width / 2);
    const Small R = turning(share());
    for (const Index n : turned == Turned::end ? solid_->loaded_nodes() : solid_->fixed_nodes()) {
        const Vec<3> arm = solid_->rest(n) - axis;
        prescribed_.col(n) = R * arm - arm;
        prescribed_(0, n) = 0;
    }
}

// Where the forces balance, the next part of the load is put on; after the last one nothing is left to do.
void FemLesson::apply_load() {
    while (!solid_->running() || level_ == 0) {
        if (level_ > 0) note_course();
        if (level_ == static_cast<Real>(levels())) break;
        raise_level();
        solid_->begin(displacement_, load_, prescribed_);
    }
    advancing_ = solid_->running();
}

void FemLesson::note_course() {
    if (course_length_ > static_cast<Index>(level_)) return;
    course_(0, course_length_) = share();
    for (int c = 0; c < solid_->dim(); ++c) course_(c + 1, course_length_) = tip(c);
    ++course_length_;
}

void FemLesson::support() {
    for (Index n = 0; n < residual_.cols(); ++n)
        residual_.col(n) = solid_->held(n) ? VecX(VecX::Zero(solid_->dim())) : VecX(load_.col(n) - internal_.col(n));
}

void FemLesson::solve() {
    done_[2] = solid_->residual();
    if (!advancing_) return;
    before_ = displacement_;
    solid_->iterate();
    newton_step_ = solid_->newton_step(), displacement_ = solid_->displacement();
    done_[1] += 1;
    if (!solid_->running()) solid_->require_balance();
}

void FemLesson::react() {
    for (Index n = 0; n < reaction_.cols(); ++n)
        if (solid_->held(n)) reaction_.col(n) = internal_.col(n) - load_.col(n);
    done_[0] = 1;
}

// ------------------------------------------------------------------------------------------------------- what goes wrong

std::string FemLesson::blow_up_hint() const {
    if (moving() && implicit()) return "Lower the time step, or the load";
    if (moving())
        return fmt::format("Δt = {} is above the stability limit of {}: lower it, or choose implicit Euler",
                           format_quantity(dt, "s"), format_quantity(stable_time_step(), "s", 3));
    return levels() < 20 ? fmt::format(
                               "Newton's method starts too far from the equilibrium that it looks for: apply the load in more "
                               "than {} steps, or a smaller one",
                               levels())
                         : "the load carries this material beyond an equilibrium that it could reach: take a smaller one";
}

std::optional<Fix> FemLesson::fix(const Failure&) const {
    if (moving() && !implicit()) return Fix{"integrator = implicit_euler", {{"integrator", "implicit_euler"}}};
    if (moving()) return fix_by(dt, rounded_down(dt / 10, 2));
    if (levels() < 20) return fix_by(load_steps, static_cast<Real>(std::max<Index>(10, std::min<Index>(20, 4 * levels()))));
    return Fix{"model = corotational", {{"model", "corotational"}}};
}

std::vector<Fix> FemLesson::other_fixes(const Failure&) const {
    if (moving()) return {};
    if (levels() < 20 && law() != Law::corotational) return {{"model = corotational", {{"model", "corotational"}}}};
    return {};
}

std::vector<std::pair<std::string, std::string>> FemLesson::finer() const {
    const auto twice = [](const Whole& n) { return std::to_string(2 * Index(n)); };
    if (is(Setting::own)) {
        const std::string name(mesh_file.given() ? mesh_file.path() : "gear_coarse");
        const std::size_t at = name.rfind("_coarse");
        if (at != std::string::npos) return {{"mesh_file", name.substr(0, at) + "_fine"}};
        if (order() == 1) return {{"element", "quadratic"}};
        return {};
    }
    if (moving()) return {{"time_step", format_exact(dt / 4)}};
    std::vector<std::pair<std::string, std::string>> cells{{"cells_x", twice(body.cells_x)}, {"cells_y", twice(body.cells_y)}};
    if (shape() == Shape::beam) cells.emplace_back("cells_z", twice(body.cells_z));
    return cells;
}

const Registration<FemLesson> registration{
    {.id = "mesh/fem",
     .title = "Finite elements",
     .summary =
         "From one triangle to a body: shape functions, strain, stress, the stiffness of an element, its place in the matrix, "
         "and the solution.",
     .demo_steps = 1}};

}  // namespace pliant::fem
