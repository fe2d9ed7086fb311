// Probes, where the method holds, and what mends it.
#include "fem.h"

#include <pliant/solids/cooks_membrane_table.h>
#include <pliant/solids/elastica.h>
#include <pliant/solids/manufactured_solution.h>
#include <pliant/text/format.h>
#include <pliant/time/stability.h>
#include <pliant/time/vibration.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::fem {
namespace {

// Of an angle [rad], up to which the linear model is worth something.
constexpr Real small_rotation = 0.1;
constexpr Real locking_ratio = 0.45;
// Of linear elements across a beam, fewer of which are far too stiff in bending.
constexpr Index enough_cells = 4;
constexpr Real balanced = 1e-6;
constexpr Real panel_in_plane_stress = 23.96;  // m: middle of the loaded edge, Y = 1 Pa, ν = 1/3, F = 1 N

}  // namespace

Real FemLesson::tip(int component) const {
    Real sum = 0;
    for (const Index n : solid_->loaded_nodes()) sum += displacement_(component, n);
    return sum / static_cast<Real>(solid_->loaded_nodes().size());
}

Index FemLesson::unknowns() const {
    Index free = 0;
    for (Index n = 0; n < solid_->node_count(); ++n) free += solid_->held(n) ? 0 : solid_->dim();
    return free;
}

// By how much the axes of an element turn, at most: the skew part of F, of small angles the angle itself.
Real FemLesson::largest_rotation() const {
    Real largest = 0;
    for (Index e = 0; e < solid_->element_count(); ++e) {
        const Small F = taken(deformation_, e);
        for (int i = 0; i < solid_->dim(); ++i)
            for (int j = 0; j < i; ++j) largest = std::max(largest, std::abs(F(i, j) - F(j, i)) / 2);
    }
    return largest;
}

Real FemLesson::smallest_volume() const {
    Real smallest = 1;
    for (Index e = 0; e < solid_->element_count(); ++e) smallest = std::min(smallest, taken(deformation_, e).determinant());
    return smallest;
}

// What is left of loads and reactions together.
Real FemLesson::force_imbalance() const { return (load_ + reaction_).rowwise().sum().norm(); }

const solid_mesh::Solid::ErrorNorms& FemLesson::errors() const {
    if (!errors_) errors_ = solid_->plane_errors(displacement_, manufactured::displacement, manufactured::gradient);
    return *errors_;
}

// P L²/(E I) of a beam that its load bends down or up.
std::optional<Real> FemLesson::bending_number() const {
    if (!loaded_down()) return std::nullopt;
    const Real inertia = body.width * std::pow(body.height, 3) / 12;
    return std::abs(body.load_y) * body.length * body.length / (body.youngs_modulus * inertia);
}

// Between the nodes of the loaded edge, where none lies in its middle.
std::optional<Real> FemLesson::middle_deflection() const {
    if (!is(Setting::cook)) return std::nullopt;
    constexpr Real middle = 52;
    Index below = -1, above = -1;
    for (const Index n : solid_->loaded_nodes()) {
        const Real y = solid_->rest()(1, n);
        if (y <= middle + 1e-9 && (below < 0 || y > solid_->rest()(1, below))) below = n;
        if (y >= middle - 1e-9 && (above < 0 || y < solid_->rest()(1, above))) above = n;
    }
    const Real low = solid_->rest()(1, below), high = solid_->rest()(1, above);
    const Real t = high > low ? (middle - low) / (high - low) : 0;
    return (1 - t) * displacement_(1, below) + t * displacement_(1, above);
}

// Of the linear model alone, whose deflection is in proportion to F/Y.
std::optional<Real> FemLesson::middle_exact() const {
    if (!is(Setting::cook) || law() != Law::linear || body.load_x != 0 || !hand_off()) return std::nullopt;
    const Real scale = body.load_y / body.youngs_modulus;
    if (Plane(body.plane) == Plane::stress)
        return std::abs(body.poisson_ratio - Real{1} / 3) < 1e-3 ? std::optional(panel_in_plane_stress * scale) : std::nullopt;
    const auto converged = converged_deflection(body.poisson_ratio);
    return converged ? std::optional(*converged * scale) : std::nullopt;
}

// Of the body at rest; asked for anew where what it depends on is another.
Real FemLesson::frequency() const {
    return frequency_.of(density, [this] {
        const SparseMatrix K = solid_->stiffness(MatX::Zero(solid_->dim(), solid_->node_count()), false);
        return fastest_mode(K, *solid_->mass(density, lumped())).omega;
    });
}

// Of the integrator, with Rayleigh's damping of the fastest mode.
Real FemLesson::stable_time_step() const {
    return stability_limit(scheme(), frequency(), rayleigh_damping_ratio(frequency(), alpha(), stiffness_damping));
}

void FemLesson::add_moving_probes() {
    const auto moves = [this] { return moving(); };
    probes.push_back(probe_of("highest_frequency", "ω", "rad/s",
                              "angular frequency of the fastest vibration about the place at rest",
                              [this] { return frequency(); }));
    probes.push_back(probe_of("stable_time_step", "2/ω", "s", "longest step of explicit schemes that keep an undamped vibration")
                         .formula(*this, "Δt = 2 / ω", {Input::now("ω", "highest_frequency", 0)})
                         .when([this] { return frequency() > 0; }));
    probes.push_back(probe_of("energy", "E", "J", "of motion, elastic, and of weight and load", [this] {
                         return total_energy();
                     }).when(moves));
    probes.push_back(probe_of("kinetic_energy", "T", "J", "of motion", [this] { return kinetic_energy(); }).when(moves));
    probes.push_back(probe_of("height", "y_m", "m", "of the centre of mass", [this] { return centre()[1]; }).when(moves));
    probes.push_back(probe_of("momentum", "|p|", "kg m/s", "of the whole", [this] { return momentum().norm(); }).when(moves));
    probes.push_back(probe_of("angular_momentum", "|L|", "kg m²/s", "about the centre of mass", [this] {
                         return angular_momentum().norm();
                     }).when(moves));
}

void FemLesson::declare_probes() {
    const auto done = [this] { return done_[0] != 0; };
    const auto has_tip = [this] { return !is(Setting::manufactured); };
    const auto of_tip = [this](int component) { return [this, component] { return tip(component); }; };
    const auto stands = [this] { return !moving(); };
    const auto known_error = [this, done] { return is(Setting::manufactured) && done(); };
    probes = {
        probe_of("tip_x", "ū_x", "m", "along x, mean over the nodes of the loaded face", of_tip(0)).when(has_tip),
        probe_of("tip_y", "ū_y", "m", "along y, mean over the nodes of the loaded face", of_tip(1)).when(has_tip),
        probe_of("tip_z", "ū_z", "m", "along z, mean over the nodes of the loaded face", of_tip(2)).when([this] {
            return !in_plane();
        }),
        probe_of("middle_y", "u_y", "m", "of the middle of the panel's loaded edge; exact: converged values of cubic triangles",
                 [this] { return middle_deflection(); })
            .exactly([this, done] { return done() ? middle_exact() : std::nullopt; }),
        probe_of("times_too_stiff", "u_ref/u", "", "converged deflection of the panel over that of these elements: 1 is right",
                 [this]() -> std::optional<Real> {
                     const auto exact = middle_exact(), now = middle_deflection();
                     return exact && now && *now != 0 ? std::optional(*exact / *now) : std::nullopt;
                 })
            .when(done),
        probe_of("elastica_deflection", "−ū_y/L", "",
                 "of the tip of a slender beam that bends as far as it likes, over its length",
                 [this]() -> std::optional<Real> {
                     const auto a = bending_number();
                     return a && *a <= 100 ? std::optional(elastica(*a).deflection) : std::nullopt;
                 }),
        probe_of("deflection_over_length", "−ū_y/L", "", "of the tip of this beam, over its length")
            .formula(*this, "ratio = −u / L", {Input::now("u", "tip_y", 0), body.length})
            .when([this] { return is(Setting::beam); }),
        probe_of("strain_energy", "U", "J", "stored in the body", [this] { return solid_->energy(displacement_); }),
        probe_of("volume_ratio", "V/V₀", "", "volume now over volume at rest",
                 [this] { return solid_->volume(displacement_) / solid_->volume(); })
            .exactly([this]() -> std::optional<Real> {
                return is(Setting::twist) && turned == Turned::support ? std::optional<Real>(1) : std::nullopt;
            }),
        probe_of("largest_stress", "σ_max", "Pa", "largest of von Mises' stresses", [this] { return mises_.maxCoeff(); }),
        probe_of("l2_error", "‖u − u_ex‖", "m²", "root of the integral of the squared error of the displacement",
                 [this] { return errors().l2; })
            .when(known_error),
        probe_of("h1_error", "‖∇(u − u_ex)‖", "m", "root of the integral of the squared error of its gradient",
                 [this] { return errors().h1; })
            .when(known_error),
        probe_of("unknowns", "", "", "displacements that are free", [this] { return static_cast<Real>(unknowns()); }),
        probe_of("newton_iterations", "", "", "of all load steps together", [this] { return done_[1]; }).when(stands),
        probe_of("residual_ratio", "|r|/|f|", "", "largest force that nothing balances, over the largest force",
                 [this] { return done_[2]; })
            .when(stands),
        probe_of("force_imbalance", "|Σ f + Σ fʳ|", "N", "sum of all loads and reactions: 0 in equilibrium", [this] {
            return force_imbalance();
        }).when(done)};
    add_moving_probes();
}

std::string_view FemLesson::error_probe() const {
    return is(Setting::cook)           ? "middle_y"
           : is(Setting::manufactured) ? "l2_error"
           : is(Setting::twist)        ? "strain_energy"
                                       : "tip_y";
}

std::vector<std::string_view> FemLesson::first_plots() const {
    if (is(Setting::spin)) return {"volume_ratio", "energy"};
    if (moving()) return {"energy", is(Setting::drop) ? "height" : "tip_y"};
    if (is(Setting::cook)) return {"locking", "middle_y"};
    if (is(Setting::manufactured)) return {"convergence"};
    if (is(Setting::own)) return {"tip_y", "largest_stress"};
    return is(Setting::beam) ? std::vector<std::string_view>{"bending", "tip_y"} : std::vector<std::string_view>{"volume_ratio"};
}

std::vector<std::string_view> FemLesson::key_numbers() const {
    if (is(Setting::cook)) return {"middle_y", "largest_stress", "unknowns"};
    if (is(Setting::manufactured)) return {"l2_error", "h1_error", "unknowns"};
    if (is(Setting::spin)) return {"volume_ratio", "angular_momentum", "energy"};
    if (moving()) return {"height", "energy", "largest_stress"};
    if (is(Setting::twist)) return {"volume_ratio", "strain_energy", "largest_stress"};
    return {"tip_y", "largest_stress", "newton_iterations"};
}

void FemLesson::declare_checks() {
    const auto done = [this] { return done_[0] != 0; };
    const auto quadratic = [this] { return fix_by(element_kind, 1); };
    assumptions = {
        assumption_of(
            "small rotation", "rad", [this] { return largest_rotation(); }, [] { return small_rotation; }, "|F − Fᵀ|/2 ≤ 0.1",
            "the linear model takes a rotation for a strain: what turns inflates and resists")
            .otherwise("large rotation")
            .when([=, this] { return law() == Law::linear && (done() || moving()) && has_law(); })
            .mended_by(Fix{"model = corotational", {{"model", "corotational"}}}),
        assumption_of(
            "no locking", "", [this] { return Real(body.poisson_ratio); }, [] { return locking_ratio; }, "ν ≤ 0.45",
            "linear triangles and tetrahedra cannot bend without changing their volume, so near ν = ½ they hardly bend at all; "
            "elements with nodes in the middles of their edges can")
            .otherwise("locking")
            .when([this] { return order() == 1 && !(in_plane() && Plane(body.plane) == Plane::stress); })
            .mended_by(quadratic),
        assumption_of(
            "cells across enough", "", [] { return static_cast<Real>(enough_cells); },
            [this] { return static_cast<Real>(Index(body.cells_y)); }, "4 ≤ n_y",
            "linear elements have one strain each: a beam that bends needs several across its height, or quadratic ones")
            .otherwise("too stiff in bending")
            .when([this] { return is(Setting::beam) && order() == 1; })
            .mended_by(quadratic),
        assumption_of(
            "not inside out", "", [this] { return -smallest_volume(); }, [] { return Real{0}; }, "det F > 0 everywhere",
            "an element is turned inside out, which no body can be; this model stays finite and does not prevent it")
            .otherwise("an element inside out")
            .when([=, this] { return done() || moving(); })
            .mended_by(Fix{"model = neo_hookean", {{"model", "neo_hookean"}}}),
        assumption_of(
            "equilibrium", "", [this] { return done_[2]; }, [] { return balanced; }, "|r| ≤ 10⁻⁶ |f|",
            "Newton's method has left forces that nothing balances")
            .otherwise("out of equilibrium")
            .when(done)};
    assumptions.push_back(
        assumption_of(
            "stability", "s", [this] { return Real(dt); }, [this] { return stable_time_step(); },
            "semi-implicit: Δt ≤ (2/ω)(√(1 + ζ²) − ζ);  explicit: Δt ≤ 2ζ/ω up to ζ = 1, so none without damping, beyond it "
            "(2/ω)(ζ − √(ζ² − 1));  ω of the fastest mode",
            "the fastest mode grows in every step until the body tears itself apart")
            .otherwise("unstable")
            .when([this] { return moving() && !implicit(); })
            .mended_by(Fix{"integrator = implicit_euler", {{"integrator", "implicit_euler"}}}));
    conserved = {{.probe = "force_imbalance",
                  .law = pliant::Law::zero,
                  .tolerance = [this] { return balanced * (load_.cwiseAbs().sum() + reaction_.cwiseAbs().sum()); },
                  .expected = [this] { return !moving(); },
                  .cancels = [this] { return load_.cwiseAbs().sum() + internal_.cwiseAbs().sum(); }},
                 {.probe = "momentum",
                  .law = pliant::Law::constant,
                  .tolerance = [this] { return 1e-9 * motion_->node_mass().sum() * solid_mesh::size_at_rest(*solid_) / dt; },
                  .expected = [this] { return is(Setting::spin) && !pull_; },
                  .cancels = [this] { return motion_->node_mass().dot(velocity_.colwise().norm()); }}};
}

}  // namespace pliant::fem
