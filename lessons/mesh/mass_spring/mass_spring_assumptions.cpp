// Under which conditions the picture can be trusted, and what is said when it cannot.
#include "mass_spring.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant::mass_spring {

void MassSpringLesson::declare_assumptions() {
    assumptions = {
        {.name = "stability",
         .unit = "s",
         .value = [this] { return Real(dt); },
         .limit = [this] { return stable_time_step(); },
         .formula = "semi-implicit: Δt ≤ (2/ω)(√(1 + ζ²) − ζ);  explicit: Δt ≤ 2ζ/ω up to ζ = 1, so none without damping, beyond "
                    "it (2/ω)(ζ − √(ζ² − 1));  undamped Verlet: 2/ω, Runge–Kutta 4: 2√2/ω;  ω of the fastest mode",
         .broken = "the fastest mode grows in every step until the block tears itself apart",
         .used = [this] { return !implicit() && !tested(); },
         .fix = [this] { return stable_fix(); }},
        {.name = "cell_inversion",
         .value = [this] { return 1 - block_->smallest_cell(position_); },
         .limit = [] { return 0.9; },
         .formula = "1 − V/V₀ ≤ 0.9 in every cell",
         .broken = "a cell is nearly flat, or turned inside out; springs know lengths, not volumes, and may rest there",
         .used = [this] { return !tested(); }},
        {.name = "travel",
         .unit = "m",
         .value = [this] { return dt * std::sqrt(velocity_.colwise().squaredNorm().maxCoeff()); },
         .limit = [this] { return edge(); },
         .formula = "|v| Δt ≤ l",
         .broken = "a node passes a whole cell in one step: impacts are met too late",
         .used = [this] { return !tested(); },
         .fix = [this] { return slower_travel(); }},
        {.name = "shear_mechanism",
         .value = [this] { return k_shear > 0 ? 0.0 : 1.0; },
         .limit = [] { return 0.5; },
         .formula = "k_d > 0",
         .broken = "edges alone do not resist shear: the block folds like a cardboard box without a lid",
         .used = [this] { return has_diagonals(); },
         .fix = [this] { return shear_springs(); }},
        {.name = "poisson_ratio",
         .value =
             [this] { return std::abs(lattice_constants(lattice(), stiffnesses(), edge()).poisson_ratio() - target_poisson); },
         .limit = [] { return 0.01; },
         .formula = "|ν − ν*| ≤ 0.01;  central forces: C₁₂ = C₄₄",
         .broken = "where every node is a centre of symmetry and no spring is under tension, springs between nodes obey Cauchy's "
                   "relation: an isotropic lattice has ν = 1/3 in a sheet and 1/4 in space, whatever their stiffness; the wished "
                   "one it cannot have",
         .used = [this] { return tested() && lattice() != LatticeKind::chain && (k_structural > 0 || k_bending > 0); },
         .fix = [this] { return own_poisson(); }},
    };
}

const SpringRates& MassSpringLesson::rates() const {
    const RatesKey key{stiffnesses(), damping, total_mass, rest_length_scale, damping_mode};
    if (rates_key_ != key) {
        rates_ = spring_rate_estimates<3>(block_->springs(), block_->inertia(), damping_mode, block_->rest());
        rates_key_ = key;
    }
    return rates_;
}

Real MassSpringLesson::stable_time_step() const {
    SpringRates rates_now = rates();
    // The hand's spring acts on one node; what it adds to ω² is at most its own.
    if (pulled()) rates_now.omega = std::hypot(rates_now.omega, std::sqrt(pull_stiffness / block_->mass()[load_.pull.node]));
    return stability_limit(integrator, rates_now);
}

Real MassSpringLesson::growth_per_step() const {
    const Real omega = rates().omega;
    return omega > 0 ? amplification(integrator, omega, rates().damping / (2 * omega), dt) : 1;
}

std::string MassSpringLesson::too_large_a_step() const {
    const Real limit = stable_time_step();
    if (implicit() || !(dt > limit)) return "";
    const std::string growth = fmt::format("its fastest mode, ω = {}, grows by a factor {} per step",
                                           format_quantity(rates().omega, "rad/s", 3), format_quantity(growth_per_step(), "", 4));
    if (limit == 0)
        return fmt::format(
            "Explicit Euler without damping is stable at no Δt: {}. Switch damping_mode on, or choose another integrator",
            growth);
    return fmt::format(
        "Δt = {} is above the stability limit of {} ({}): {}. Lower time_step or the stiffness, or choose implicit_euler",
        format_quantity(dt, "s"), format_quantity(limit, "s", 3), limit_in_words(integrator), growth);
}

std::string MassSpringLesson::blow_up_hint() const {
    if (const std::string hint = too_large_a_step(); !hint.empty()) return hint;
    if (implicit()) return "Lower time_step, or allow more newton_iterations";
    return fmt::format(
        "Δt = {} is below the limit {} of small motions: the deformation is large. Lower time_step, or choose implicit_euler",
        format_quantity(dt, "s"), format_quantity(stable_time_step(), "s", 3));
}

}  // namespace pliant::mass_spring
