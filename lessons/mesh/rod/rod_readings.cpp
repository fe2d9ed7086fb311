// Probes, and what is measured.
#include "rod.h"

#include <pliant/solids/point_masses.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::rod {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
}  // namespace

std::vector<std::string_view> RodLesson::first_plots() const {
    if (hangs_still()) return {"tip_against_segments", "strain_profile", "displacement_profile"};
    if (setting == Setting::wave) return {"displacement_profile", "mode_amplitude", "frequencies"};
    return {"displacement_profile", "tip_displacement", "energy"};
}

std::vector<std::string_view> RodLesson::key_numbers() const {
    if (hangs_still()) return {"tip_displacement", "tip_over_continuum", "chain_axial_stiffness"};
    if (hangs()) return {"tip_displacement", "tip_of_chain", "chain_axial_stiffness"};
    if (setting == Setting::wave) return {"frequency", "frequency_chain", "frequency_continuum"};
    return {"wave_speed", "pulse_position", "tip_displacement"};
}

// ---------------------------------------------------------------------------------------------------------------- probes

void RodLesson::declare_probes() {
    const auto undamped_start = [this](Real) -> std::optional<Real> {
        if (hangs_still() || damped()) return std::nullopt;
        return start_energy_;
    };
    probes = {
        {.name = "tip_displacement",
         .symbol = "u_L",
         .unit = "m",
         .help = "of the free end, along the rod; exact: of the continuum, M g L/(2EA) when it hangs at rest",
         .value = [this] { return tip_displacement(); },
         .exact = [this](Real t) { return exact_displacement(length, t); }},
        {.name = "tip_over_continuum",
         .help = "u_L over that of the continuum; exact: (N + 1)/N for derived springs, which tends to 1",
         .value = [this]() -> std::optional<Real> {
             if (!hangs_still() || gravity == 0) return std::nullopt;
             return tip_displacement() / continuum().hanging_tip(gravity);
         },
         .exact = [this](Real) -> std::optional<Real> {
             if (!hangs_still() || gravity == 0) return std::nullopt;
             return chain().hanging_tip(gravity) / continuum().hanging_tip(gravity);
         }},
        {.name = "tip_of_chain",
         .symbol = "u_N",
         .unit = "m",
         .help = "M g (N + 1)/(2k): what a chain of N springs k comes to, at rest",
         .value = [this]() -> std::optional<Real> {
             if (!hangs()) return std::nullopt;
             return chain().hanging_tip(gravity);
         }},
        {.name = "stiffness",
         .symbol = "k",
         .unit = "N/m",
         .help = "of each spring: EA/Δs, or what was picked",
         .value = [this] { return stiffness(); }},
        {.name = "chain_axial_stiffness",
         .symbol = "k Δs",
         .unit = "N",
         .help = "EA of the rod that the springs amount to; exact: that of the rod",
         .value = [this] { return chain_axial_stiffness(); },
         .exact = [this](Real) { return std::optional<Real>(axial_stiffness); }},
        {.name = "energy",
         .symbol = "E",
         .unit = "J",
         .help = "kinetic, elastic and gravitational",
         .value = [this] { return total_energy(); },
         .exact = undamped_start},
        {.name = "elastic_energy",
         .symbol = "U",
         .unit = "J",
         .help = "Σ ½EAε² Δs; exact, of the continuum at rest: M²g²L/(6EA)",
         .value = [this] { return elastic_energy(); },
         .exact = [this](Real) -> std::optional<Real> {
             if (!hangs_still()) return std::nullopt;
             return continuum().hanging_energy(gravity);
         }},
        {.name = "kinetic_energy",
         .symbol = "K",
         .unit = "J",
         .help = "½ Σ m v²",
         .value = [this] { return kinetic_energy_now(); }},
        {.name = "gravitational_energy",
         .symbol = "V",
         .unit = "J",
         .help = "−Σ m g u_s: 0 with all mass at the support",
         .value = [this] { return gravitational_energy_now(); }},
        {.name = "force_difference",
         .symbol = "Δf",
         .unit = "N",
         .help = "largest difference between −∂U/∂x and the forces of the springs: they are the same forces",
         .value = [this] { return force_difference(); }},
        {.name = "imbalance",
         .symbol = "|f|",
         .unit = "N",
         .help = "largest force along the rod that springs leave unbalanced, on nodes that are free",
         .value = [this]() -> std::optional<Real> {
             if (!hangs_still()) return std::nullopt;
             return imbalance();
         }},
    };
}

// ------------------------------------------------------------------------------------------------------- what is measured

Real RodLesson::elastic_energy() const {
    Points<2> slope(2, count());
    VecX strain(count());
    rod_slopes(segment(), position_, slope);
    rod_strains(slope, strain);
    return rod_energy(chain_axial_stiffness(), segment(), strain);
}

Real RodLesson::kinetic_energy_now() const { return kinetic_energy<2>(node_masses_, velocity_); }

Real RodLesson::gravitational_energy_now() const {
    return gravitational_energy<2>(node_masses_, weight_acceleration() * along(), position_);
}

Real RodLesson::force_difference() const { return (gradient_force_ - spring_force_).cwiseAbs().maxCoeff(); }

// Lengths are known to the rounding of the positions that they are the difference of.
Real RodLesson::force_rounding() const {
    return 16 * epsilon * stiffness() * (position_.cwiseAbs().maxCoeff() + segment() * (1 + strain_.cwiseAbs().maxCoeff()));
}

// Of positions along the rod, after many steps.
Real RodLesson::strain_rounding() const { return 1e4 * epsilon * length / segment(); }

Real RodLesson::imbalance() const {
    Points<2> force = spring_force_;
    if (loaded()) force += external_force_;
    return (force.rightCols(count()).transpose() * along()).cwiseAbs().maxCoeff();
}

Real RodLesson::imbalance_rounding() const {
    return 1e-14 * total_mass * weight_acceleration() + 8 * epsilon * stiffness() * position_.cwiseAbs().maxCoeff();
}

Real RodLesson::static_tip(Rule rule, Index n) const {
    VecX tension, move;
    const Real m = total_mass / static_cast<Real>(n);
    balance_chain(VecX::Constant(n, stiffness_of(rule, n)), VecX::Constant(n + 1, m * weight_acceleration()), tension, move);
    return move[n];
}

// Of a rod that moves: ten times the strain with all of its energy in one segment, which no motion passes.
Real RodLesson::largest_strain() const {
    const Real weight = total_mass * weight_acceleration();
    if (hangs_still()) return 1000 * (1 + weight / chain_axial_stiffness());
    const Real energy = hangs() ? 2 * weight * chain().hanging_tip(gravity) : start_energy_;
    return 1e-3 + 10 * std::sqrt(2 * energy / (chain_axial_stiffness() * segment()));
}

}  // namespace pliant::rod
