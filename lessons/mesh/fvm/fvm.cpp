// The start, and what the stages do.
#include "fvm.h"

#include <pliant/solids/point_masses.h>
#include <pliant/text/format.h>

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pliant::fvm {
namespace {

constexpr Index most_face_passes = 32;  // of the loop over the elements: larger bodies take several at once
constexpr Real longest_needle = 1e4;    // edges of a cell, longest over shortest
constexpr Real no_volume = 1e-12;       // |det F| of an element that is flat

const Registration<FvmLesson> registration{
    {.id = "mesh/fvm",
     .title = "Finite volumes",
     .summary = "A body moves by the forces on the faces of its elements, shared evenly among their nodes: the forces of finite "
                "elements, found without an energy.",
     .demo_steps = 300}};

VecX rigid_rotation_speed(int dim, const Vec<3>& arm, Real rate) { return Vec<3>(rate * Vec<3>::UnitZ().cross(arm)).head(dim); }

}  // namespace

void FvmLesson::check() const {
    body.check(body.settings(shape(), 1), !in_space(), true);
    const Real along = body.length / static_cast<Real>(Index(body.cells_x)),
               up = body.height / static_cast<Real>(Index(body.cells_y));
    if (std::max(along, up) > longest_needle * std::min(along, up))
        throw Refused(fmt::format(
            "length = {} m and height = {} m make cells of {} by {}: at most {} times as long as short is accepted",
            Real(body.length), Real(body.height), format_quantity(along, "m"), format_quantity(up, "m"), longest_needle));
    if (!implicit()) return;
    const Index nodes = (body.cells_x + 1) * (body.cells_y + 1) * (in_space() ? body.cells_z + 1 : Index{1});
    if (nodes > most_implicit_nodes)
        throw Refused(
            fmt::format("integrator = {} with {} nodes (cells_x = {}, cells_y = {}{}) is not accepted: its matrix is factorised "
                        "in every step; give cells that make at most {} nodes, or integrator = semi_implicit_euler",
                        scheme.option_key(), nodes, Index(body.cells_x), Index(body.cells_y),
                        in_space() ? fmt::format(", cells_z = {}", Index(body.cells_z)) : std::string(), most_implicit_nodes));
}

void FvmLesson::reset() {
    motion_.reset();
    fastest_.reset();
    pull_.reset();
    interfered_ = false;
    solid_ = solid_mesh::make_solid(body.settings(shape(), 1));
    mass_ = solid_mesh::lumped_mass(*solid_, density);
    const std::vector<Index> fixed = held() ? solid_->fixed_nodes() : std::vector<Index>{};
    if (solid_->dim() == 2) {
        plane_elements_ = &dynamic_cast<const HyperelasticFem<2>&>(*solid_->plane_body());
        plane_ = std::make_unique<FaceForceBody<2>>(*plane_elements_);
        motion_ = solid_mesh::SolidMotion::of<2>(*plane_, solid_->rest(), mass_, fixed);
    } else {
        space_elements_ = &dynamic_cast<const HyperelasticFem<3>&>(*solid_->space_body());
        space_ = std::make_unique<FaceForceBody<3>>(*space_elements_);
        motion_ = solid_mesh::SolidMotion::of<3>(*space_, solid_->rest(), mass_, fixed);
    }
    const Index d = solid_->dim(), nodes = solid_->node_count(), elements = solid_->element_count();
    position_ = solid_->rest();
    velocity_.setZero(d, nodes);
    if (!held()) {
        const Vec<3> centre = centre_of_mass<2>(mass_, solid_->rest()).homogeneous() - Vec<3>::UnitZ();
        for (Index n = 0; n < nodes; ++n)
            velocity_.col(n) = rigid_rotation_speed(solid_->dim(), solid_->rest(n) - centre, spin_rate);
    }
    clock_.setZero();
    start_position_ = flat(position_), total_force_ = VecX::Zero(position_.size());
    for (MatX* nodal : {&force_, &fem_force_, &outer_force_, &damping_force_}) nodal->setZero(d, nodes);
    for (MatX* tensors : {&deformation_, &rotation_, &strain_, &stress_, &cauchy_}) tensors->setZero(d * d, elements);
    for (Index k = 0; k < d; ++k) deformation_.row((d + 1) * k).setOnes(), rotation_.row((d + 1) * k).setOnes();
    for (MatX* faces : {&rest_area_, &deformed_area_, &face_force_, &true_face_force_}) faces->setZero(d, (d + 1) * elements);
    volume_.setZero(elements);
    first_of_pass_ = next_element_ = 0;
    loop_runs_ = forces_meet_ = false;
    start_kinetic_ = kinetic();
    compliance_.reset();
    start_spin_ = spin();
    for (Field& f : fields)
        if (f.rank != Rank::scalar) f.components = static_cast<int>(f.rank == Rank::vector ? d : d * d);
}

void FvmLesson::pull(const std::optional<Pull>& hand) {
    pull_ = hand;
    if (pull_ && (pull_->index < 0 || pull_->index >= solid_->node_count())) pull_.reset();
    interfered_ = interfered_ || pull_;
}

const MatX& FvmLesson::displacement() const {
    displacement_ = position_ - solid_->rest();
    return displacement_;
}

// ------------------------------------------------------------------------------------------------------------- elements

Small FvmLesson::taken(const MatX& tensors, Index element) const {
    const int d = solid_->dim();
    Small value(d, d);
    for (int i = 0; i < d; ++i)
        for (int j = 0; j < d; ++j) value(i, j) = tensors(d * i + j, element);
    return value;
}

void FvmLesson::put(MatX& tensors, Index element, const Small& value) const {
    const int d = solid_->dim();
    for (int i = 0; i < d; ++i)
        for (int j = 0; j < d; ++j) tensors(d * i + j, element) = value(i, j);
}

// The other corners in an order in which the area vector points away from the opposite one.
std::vector<Index> FvmLesson::face_nodes(Index element, int opposite) const {
    std::vector<Index> nodes;
    for (int k = 0; k < corners(); ++k)
        if (k != opposite) nodes.push_back(solid_->node(element, k));
    const bool turned = solid_->dim() == 2 ? opposite == 1 : opposite % 2 == 1;
    if (turned) std::swap(nodes[0], nodes[1]);
    return nodes;
}

void FvmLesson::measure_areas() {
    volume_ = solid_->volumes();
    for (Index e = 0; e < solid_->element_count(); ++e)
        for (int k = 0; k < corners(); ++k) {
            if (solid_->dim() == 2)
                rest_area_.col(face(e, k)) = rest_face_area<2>(*solid_->plane_mesh(), e, k);
            else
                rest_area_.col(face(e, k)) = rest_face_area<3>(*solid_->space_mesh(), e, k);
        }
}

void FvmLesson::deform() {
    loop_runs_ = false;  // a step that was left in the middle of its loop
    const auto of_each = [this](const auto& elements, const auto& u) {
        for (Index e = 0; e < solid_->element_count(); ++e) put(deformation_, e, elements.deformation_gradient(e, u));
    };
    if (solid_->dim() == 2)
        of_each(*plane_elements_, Points<2>(displacement()));
    else
        of_each(*space_elements_, Points<3>(displacement()));
}

void FvmLesson::turn() {
    for (Index e = 0; e < solid_->element_count(); ++e) put(rotation_, e, solid_->rotation(taken(deformation_, e)));
}

void FvmLesson::measure_strain() {
    for (Index e = 0; e < solid_->element_count(); ++e) put(strain_, e, solid_->strain(taken(deformation_, e)));
}

void FvmLesson::evaluate_stress() {
    for (Index e = 0; e < solid_->element_count(); ++e) put(stress_, e, solid_->stress(taken(deformation_, e)));
}

void FvmLesson::true_stress() {
    for (Index e = 0; e < solid_->element_count(); ++e) {
        const Small F = taken(deformation_, e), P = taken(stress_, e);
        const Real J = F.determinant();
        if (std::abs(J) > no_volume)
            put(cauchy_, e, P * F.transpose() / J);
        else
            cauchy_.col(e).setZero();
        for (int k = 0; k < corners(); ++k) {
            const Index f = face(e, k);
            if (solid_->dim() == 2)
                deformed_area_.col(f) = deformed_face_area<2>(F, rest_area_.col(f));
            else
                deformed_area_.col(f) = deformed_face_area<3>(F, rest_area_.col(f));
        }
    }
}

// ---------------------------------------------------------------------------------------------- the loop over the elements

void FvmLesson::begin_faces() {
    loop_runs_ = true, forces_meet_ = false;
    first_of_pass_ = next_element_ = 0;
    for (MatX* numbers : {&face_force_, &true_face_force_, &force_}) numbers->setZero();
}

void FvmLesson::face_forces() {
    const Index count = solid_->element_count(), batch = (count + most_face_passes - 1) / most_face_passes;
    if (!loop_runs_) begin_faces();
    first_of_pass_ = next_element_;
    next_element_ = std::min(count, first_of_pass_ + batch);
    for (Index e = first_of_pass_; e < next_element_; ++e) {
        const Small P = taken(stress_, e), sigma = taken(cauchy_, e);
        for (int k = 0; k < corners(); ++k) {
            const Index f = face(e, k);
            face_force_.col(f) = P * rest_area_.col(f);
            true_face_force_.col(f) = sigma * deformed_area_.col(f);
        }
    }
}

// What pulls at a face of the element pulls back at the nodes of the face.
void FvmLesson::share() {
    for (Index e = first_of_pass_; e < next_element_; ++e)
        for (int k = 0; k < corners(); ++k)
            for (int a = 0; a < corners(); ++a)
                if (a != k) force_.col(solid_->node(e, a)) -= face_force_.col(face(e, k)) / solid_->dim();
    loop_runs_ = next_element_ < solid_->element_count();
}

// -------------------------------------------------------------------------------------------------------------- the motion

void FvmLesson::fem_forces() {
    solid_->internal_force(displacement(), fem_force_);
    fem_force_ = -fem_force_;
    forces_meet_ = true;
}

Vec<3> FvmLesson::load_force() const {
    if (!held()) return Vec<3>::Zero();
    return {body.load_x, body.load_y, in_space() ? Real{body.load_z} : Real{0}};
}

MatX FvmLesson::load_on_nodes() const {
    MatX load = MatX::Zero(solid_->dim(), solid_->node_count());
    const VecX& area = solid_->loaded_area();
    for (int c = 0; c < solid_->dim(); ++c) load.row(c) = load_force()[c] / area.sum() * area.transpose();
    return load;
}

solid_mesh::OuterLoad FvmLesson::outer_load() const {
    solid_mesh::OuterLoad load{.gravity = weight_acceleration(), .force = load_on_nodes(), .pull = {}, .mass_damping = damping};
    if (pulled()) load.pull = {pull_->index, pull_->to, pull_stiffness};
    return load;
}

void FvmLesson::outer_forces() {
    outer_force_ = load_on_nodes();
    outer_force_.row(1) -= weight_acceleration() * mass_.transpose();
    if (pulled())
        outer_force_.col(pull_->index) += pull_stiffness * (pull_->to.head(solid_->dim()) - position_.col(pull_->index));
    damping_force_ = -damping * velocity_ * mass_.asDiagonal();
}

void FvmLesson::begin_integration() {
    start_position_ = flat(position_);
    total_force_ = flat(force_) + flat(outer_force_) + flat(damping_force_);
    TimeIntegrator& integrator = motion_->integrator();
    integrator.set_scheme(scheme);
    integrator.set_options({newton_tolerance, static_cast<int>(Index(newton_cap))});
    motion_->set_load(outer_load());
    integrator.begin(dt, flat(position_), flat(velocity_), &total_force_);
}

void FvmLesson::integrate() {
    motion_->integrator().pass();
    flat(position_) = motion_->integrator().position();
    flat(velocity_) = motion_->integrator().velocity();
    for (Index d = 0; d < velocity_.size(); ++d)
        if (motion_->mass().fixed(d)) velocity_.data()[d] = 0;
}

void FvmLesson::end_integration() {
    motion_->integrator().finish(flat(position_), flat(velocity_));
    clock_[0] += dt;
}

std::vector<std::string_view> FvmLesson::first_plots() const {
    if (!held()) return {"energy", "angular_momentum", "difference_from_fem"};
    return {"tip_y", "difference_from_fem", "cut_force"};
}

std::vector<std::string_view> FvmLesson::key_numbers() const {
    return {"difference_from_fem", "largest_face_force", held() ? "tip_y" : "angular_momentum"};
}

}  // namespace pliant::fvm
