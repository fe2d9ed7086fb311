// When it is at rest, under which conditions its numbers can be trusted, and what mends a run.
#include "fvm.h"

#include <pliant/text/format.h>

#include <fmt/format.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pliant::fvm {
namespace {

constexpr Real crawl = 1e-4;     // of the speed that its motion can come to, of a body at rest
constexpr Real margin = 0.8;     // of a limit, that steps keep to
constexpr Real slowest = 0.01;   // steps that are shorter than this part of the present ones take too long
constexpr Real most_turn = 0.1;  // rad, of a rotation that is small

}  // namespace

// m/s that its motion comes to, by the size of the loads and of the body.
Real FvmLesson::speed_scale() const {
    Real force =
        (load_on_nodes().rowwise().sum() - weight_acceleration() * mass_.sum() * MatX::Identity(solid_->dim(), 2).col(1)).norm();
    if (pulled()) force += pull_stiffness * (pull_->to.head(solid_->dim()) - position_.col(pull_->index)).norm();
    return std::sqrt((2 * start_kinetic_ + force * solid_mesh::size_at_rest(*solid_)) / mass_.sum());
}

// Slow against what its motion could come to, and in balance.
bool FvmLesson::at_rest() const {
    const Real slow = crawl * speed_scale();
    if (velocity_.colwise().norm().maxCoeff() > slow) return false;
    MatX left;
    solid_->internal_force(displacement(), left);
    left = load_on_nodes() - left;
    left.row(1) -= weight_acceleration() * mass_.transpose();
    if (pulled()) left.col(pull_->index) += pull_stiffness * (pull_->to.head(solid_->dim()) - position_.col(pull_->index));
    for (Index n = 0; n < left.cols(); ++n)
        if (!motion_->mass().fixed(solid_->dim() * n) && left.col(n).norm() > 0.1 * fastest() * slow * mass_[n]) return false;
    return true;
}

std::string FvmLesson::unrest() const {
    if (at_rest() || damped() || dissipates(scheme)) return "";
    return held() ? "nothing takes the energy of its vibrations out (damping)" : "nothing stops its rotation (damping)";
}

// Smaller cells, and steps that stay stable with them.
std::vector<std::pair<std::string, std::string>> FvmLesson::finer() const {
    const auto twice = [](const Whole& n) { return std::to_string(2 * Index(n)); };
    std::vector<std::pair<std::string, std::string>> finer{{"cells_x", twice(body.cells_x)}, {"cells_y", twice(body.cells_y)}};
    if (in_space()) finer.emplace_back("cells_z", twice(body.cells_z));
    finer.emplace_back("time_step", format_exact(dt / 2));
    return finer;
}

// ------------------------------------------------------------------------------------------------------------ conditions

void FvmLesson::declare_checks() {
    const auto part_of_largest = [this](Real part) { return part * largest_face_force() + 100 * face_rounding(); };
    const auto flies = [this] { return !held() && !pulled() && !damped(); };
    conserved = {
        {.probe = "difference_from_fem", .law = pliant::Law::zero, .tolerance = [] { return 1e-12; }},
        {.probe = "sum_of_faces", .law = pliant::Law::zero, .tolerance = [part_of_largest] { return part_of_largest(1e-12); }},
        {.probe = "momentum",
         .tolerance = [this] { return 1e-10 * mass_.sum() * solid_mesh::size_at_rest(*solid_) / dt; },
         .expected = flies,
         .cancels = [this] { return momentum_terms(); }},
        // Semi-implicit Euler keeps it where the stress of every element is without a couple: P Fᵀ symmetric.
        {.probe = "angular_momentum",
         .tolerance =
             [this] {
                 const Real size = solid_mesh::size_at_rest(*solid_);
                 return 1e-10 * mass_.sum() * size * size / dt;
             },
         .expected = [this,
                      flies] { return flies() && Scheme(scheme) == Scheme::semi_implicit_euler && Law(body.law) != Law::linear; },
         .cancels = [this] { return momentum_terms() * solid_mesh::size_at_rest(*solid_); }},
        {.probe = "energy",
         .law = pliant::Law::never_grows,
         .tolerance = [this] { return energy_tolerance(); },
         .expected = [this] { return !pulled(); },
         .cancels = [this] { return kinetic() + elastic() + std::abs(outer_energy()); }}};
    declare_assumptions();
}

void FvmLesson::declare_assumptions() {
    assumptions = {
        assumption_of(
            "stability", "s", [this] { return Real(dt); }, [this] { return stable_time_step(); },
            "semi-implicit: Δt ≤ (2/ω)(√(1 + ζ²) − ζ);  explicit: Δt ≤ 2ζ/ω, so none without damping;  ω of the fastest "
            "vibration",
            "the fastest vibration grows in every step until the body tears itself apart")
            .otherwise("unstable")
            .when([this] { return !implicit(); })
            .mended_by([this] { return stable_fix(); }),
        assumption_of(
            "small_rotations", "rad",
            [this] {
                Real most = 0;
                const int d = solid_->dim();
                for (Index e = 0; e < solid_->element_count(); ++e) {
                    const Small F = solid_->deformation(e, displacement());
                    for (int i = 0; i < d; ++i)
                        for (int j = 0; j < i; ++j) most = std::max(most, std::abs(F(i, j) - F(j, i)) / 2);
                }
                return most;
            },
            [] { return most_turn; }, "|F_ij − F_ji|/2 ≤ 0.1",
            "the linear strain takes a rotation for a stretch: elements that turn swell, and their forces have a couple")
            .otherwise("large rotations")
            .when([this] { return Law(body.law) == Law::linear; })
            .mended_by(Fix{"model = corotational", {{"model", "corotational"}}}),
        assumption_of(
            "no_inversion", "", [this] { return 1 - smallest_volume_ratio(); }, [] { return 0.95; }, "1 − V/V₀ ≤ 0.95",
            "an element is nearly flat or inside out: only the neo-Hookean law forbids it, the others may rest there")
            .otherwise("element nearly flat")};
}

std::optional<Fix> FvmLesson::stable_fix() const {
    const Real limit = stable_time_step();
    if (limit > slowest * dt) return fix_by(dt, rounded_down(margin * limit, 2));
    const Real other = stability_limit(Scheme::semi_implicit_euler, fastest(), 0);
    Fix fix = fix_by(dt, rounded_down(std::min(margin * other, Real(dt)), 2));
    fix.label = "semi-implicit Euler, " + fix.label;
    fix.assign.insert(fix.assign.begin(), {"integrator", "semi_implicit_euler"});
    return fix;
}

std::string FvmLesson::blow_up_hint() const {
    const Real limit = stable_time_step();
    if (!implicit() && dt > limit) {
        if (limit == 0) return "Explicit Euler without damping is stable at no Δt: take semi-implicit or implicit Euler";
        return fmt::format("Δt = {} is above the stability limit {} ({}). Lower the time step, or choose implicit Euler",
                           format_quantity(dt, "s"), format_quantity(limit, "s", 3), limit_in_words(scheme));
    }
    if (flies_apart())
        return "The linear law sees no strain in a body that turns: every node flies straight on, and the body grows for ever. "
               "Choose another model, which takes the rotation out";
    if (implicit()) return "Lower the time step, or allow more Newton iterations";
    return fmt::format(
        "Δt = {} is below the limit {} of small vibrations: the deformation is large. Lower the time step or the load, or choose "
        "implicit Euler",
        format_quantity(dt, "s"), format_quantity(limit, "s", 3));
}

std::optional<Fix> FvmLesson::fix(const Failure&) const {
    if (!implicit() && dt > stable_time_step()) return stable_fix();
    if (flies_apart()) return Fix{"model = corotational", {{"model", "corotational"}}};
    return fix_by(dt, rounded_down(dt / 4, 2));
}

std::vector<Fix> FvmLesson::other_fixes(const Failure&) const {
    if (!implicit() && solid_->node_count() <= most_implicit_nodes)
        return {Fix{"implicit Euler", {{"integrator", "implicit_euler"}}}};
    if (implicit() && newton_cap < 100) return {Fix{"100 Newton iterations", {{"newton_iterations", "100"}}}};
    return {};
}

}  // namespace pliant::fvm
