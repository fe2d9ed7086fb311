// Under which conditions the picture can be trusted, what is said when it cannot, and which parameters would mend a run.
#include "mass_spring.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {
namespace {

// Part of a limit that small steps keep to, and of the limit of small motions where large ones have torn a block apart.
constexpr Real margin = 0.8, wide_margin = 0.4;
// Steps that are shorter than this part of the present ones would take too long.
constexpr Real slowest = 0.01;

Real growth_per_step(const MassSpringLesson& l) {
    const Real omega = l.rates().omega;
    return omega > 0 ? amplification(l.integrator, omega, l.rates().damping / (2 * omega), l.dt) : 1;
}

// A shorter step, or where it would have to be very short another scheme.
std::optional<Fix> stable_fix(const MassSpringLesson& l) {
    const Real limit = l.stable_time_step(), other = stability_limit(Scheme::semi_implicit_euler, l.rates());
    if (limit > slowest * l.dt) return fix_by(l.dt, rounded_down(margin * limit, 2));
    if (!l.semi_implicit() && other > slowest * l.dt) {
        Fix fix = fix_by(l.dt, rounded_down(std::min(margin * other, Real(l.dt)), 2));
        fix.label = "semi-implicit Euler, " + fix.label;
        fix.assign.insert(fix.assign.begin(), {"integrator", "semi_implicit_euler"});
        return fix;
    }
    if (l.block_->rest().cols() <= most_implicit_nodes) return Fix{"implicit Euler", {{"integrator", "implicit_euler"}}};
    return limit > 0 ? std::optional(fix_by(l.dt, rounded_down(margin * limit, 2))) : std::nullopt;
}

std::optional<Fix> slower_travel(const MassSpringLesson& l) {
    const Real speed = std::sqrt(l.velocity_.colwise().squaredNorm().maxCoeff()), cell = l.edge();
    return fix_by(l.dt, rounded_down(margin * cell / speed, 2));
}

std::optional<Fix> shear_springs(const MassSpringLesson& l) {
    const Real k = l.k_structural > 0 ? rounded_down(0.5 * l.k_structural, 2) : l.k_shear.info.initial;
    return fix_by(l.k_shear, k);
}

// The solid beside the net gets the ratio that the net has.
std::optional<Fix> own_poisson(const MassSpringLesson& l) {
    const Real own = l.endless_lattice().poisson_ratio();
    if (!l.target_poisson.accepted().contains(own)) return std::nullopt;
    return fix_by(l.target_poisson, own);
}

}  // namespace

void MassSpringLesson::declare_assumptions() {
    assumptions = {
        assumption_of(
            "stability", "s", [this] { return Real(dt); }, [this] { return stable_time_step(); },
            "semi-implicit: Δt ≤ (2/ω)(√(1 + ζ²) − ζ);  explicit: Δt ≤ 2ζ/ω up to ζ = 1, so none without damping, beyond "
            "it (2/ω)(ζ − √(ζ² − 1));  undamped Verlet: 2/ω, Runge–Kutta 4: 2√2/ω;  ω of the fastest mode",
            "the fastest mode grows in every step until the block tears itself apart")
            .otherwise("unstable")
            .when([this] { return !implicit() && !tested(); })
            .mended_by([this] { return stable_fix(*this); }),
        assumption_of(
            "cell_inversion", "", [this] { return 1 - block_->smallest_cell(position_); }, [] { return 0.9; },
            "1 − V/V₀ ≤ 0.9 in every cell",
            "a cell is nearly flat, or turned inside out; springs know lengths, not volumes, and may rest there")
            .otherwise("cell nearly flat")
            .when([this] { return !tested(); }),
        assumption_of(
            "travel", "m", [this] { return dt * std::sqrt(velocity_.colwise().squaredNorm().maxCoeff()); },
            [this] { return edge(); }, "|v| Δt ≤ l", "a node passes a whole cell in one step: impacts are met too late")
            .otherwise("travels far in a step")
            .when([this] { return !tested(); })
            .mended_by([this] { return slower_travel(*this); }),
        assumption_of(
            "shear_mechanism", "", [this] { return k_shear > 0 ? 0.0 : 1.0; }, [] { return 0.5; }, "k_d > 0",
            "edges alone do not resist shear: the block folds like a cardboard box without a lid")
            .otherwise("nothing resists shear")
            .when([this] { return has_diagonals(); })
            .mended_by([this] { return shear_springs(*this); }),
        assumption_of(
            "poisson_ratio", "", [this] { return std::abs(endless_lattice().poisson_ratio() - target_poisson); },
            [] { return 0.01; }, "|ν − ν*| ≤ 0.01;  central forces: C₁₂ = C₄₄",
            "where every node is a centre of symmetry and no spring is under tension, springs between nodes obey Cauchy's "
            "relation: an isotropic lattice has ν = 1/3 in a sheet and 1/4 in space, whatever their stiffness; the wished "
            "one it cannot have")
            .otherwise("Poisson's ratio out of reach")
            .when([this] { return tested() && lattice() != LatticeKind::chain && (k_structural > 0 || k_bending > 0); })
            .mended_by([this] { return own_poisson(*this); }),
    };
}

const SpringRates& MassSpringLesson::rates() const {
    return rates_.of({stiffnesses(), damping, total_mass, rest_length_scale, damping_mode}, [this] {
        return spring_rate_estimates<3>(block_->springs(), block_->inertia(), damping_mode, block_->rest());
    });
}

Real MassSpringLesson::stable_time_step() const {
    return stability_limit(integrator,
                           pulled() ? with_spring_to(rates(), pull_stiffness, block_->mass()[load_.pull.node]) : rates());
}

std::string MassSpringLesson::too_large_a_step() const {
    const Real limit = stable_time_step();
    if (implicit() || !(dt > limit)) return "";
    const std::string growth =
        fmt::format("its fastest mode, ω = {}, grows by a factor {} per step", format_quantity(rates().omega, "rad/s", 3),
                    format_quantity(growth_per_step(*this), "", 4));
    if (limit == 0)
        return fmt::format(
            "Explicit Euler without damping is stable at no Δt: {}. Switch damping on, or choose another integrator", growth);
    return fmt::format(
        "Δt = {} is above the stability limit of {} ({}): {}. Lower the time step or the stiffness, or choose implicit Euler",
        format_quantity(dt, "s"), format_quantity(limit, "s", 3), limit_in_words(integrator), growth);
}

std::string MassSpringLesson::blow_up_hint() const {
    if (const std::string hint = too_large_a_step(); !hint.empty()) return hint;
    if (implicit()) return "Lower the time step, or allow more Newton iterations";
    return fmt::format(
        "Δt = {} is below the limit {} of small motions: the deformation is large. Lower the time step, or choose implicit Euler",
        format_quantity(dt, "s"), format_quantity(stable_time_step(), "s", 3));
}

std::optional<Fix> MassSpringLesson::fix(const Failure&) const {
    if (tested()) return has_diagonals() ? shear_springs(*this) : std::nullopt;
    if (!implicit() && dt > stable_time_step()) {
        const Real limit = stable_time_step();
        if (limit <= slowest * dt) return stable_fix(*this);
        return fix_by(dt, rounded_down(wide_margin * limit, 2));
    }
    // The small motions are stable: the block is far from its shape at rest.
    return fix_by(dt, rounded_down(dt / 4, 2));
}

std::vector<Fix> MassSpringLesson::other_fixes(const Failure&) const {
    if (tested()) return {};
    if (!implicit()) return {Fix{"implicit Euler", {{"integrator", "implicit_euler"}}}};
    return newton_cap < 100 ? std::vector{Fix{"100 Newton iterations", {{"newton_iterations", "100"}}}} : std::vector<Fix>{};
}

// The integrator of second-order energy error, well inside its limit, in whole parts of the present step.
std::vector<std::pair<std::string, std::string>> MassSpringLesson::finer() const {
    const Real limit = stability_limit(Scheme::semi_implicit_euler, rates());
    const Real parts = std::ceil(std::max(Real{8}, 10 * dt / limit));
    return {{"integrator", "semi_implicit_euler"}, {"time_step", format_exact(dt / parts)}};
}

}  // namespace pliant::mass_spring
