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
    const auto undamped_start = [this](Real) {
        return hangs_still() || damped() ? std::nullopt : std::optional<Real>(start_energy_);
    };
    probes = {
        probe_of("tip_displacement", "u_L", "m",
                 "of the free end, along the rod; exact: of the continuum, M g L/(2EA) when it hangs at rest",
                 [this] { return tip_displacement(); })
            .exactly([this](Real t) { return exact_displacement(length, t); }),
        probe_of("tip_over_continuum", "", "",
                 "u_L over that of the continuum; exact: (N + 1)/N for derived springs, which tends to 1")
            .formula(*this, "u_L / u_c",
                     {Input::now("u_L", "tip_displacement", 0),
                      part("u_c = M g L / (2 EA)", {total_mass, gravity, length, axial_stiffness})})
            .exactly([this](Real) { return chain().hanging_tip(gravity) / continuum().hanging_tip(gravity); })
            .when([this] { return hangs_still() && gravity != 0; }),
        probe_of("tip_of_chain", "u_N", "m", "M g (N + 1)/(2k): what a chain of N springs k comes to, at rest")
            .formula(*this, "u_N = M g (N + 1) / (2 k)", {total_mass, gravity, segments, Input::now("k", "stiffness", 0)})
            .when([this] { return hangs(); }),
        probe_of("stiffness", "k", "N/m", "of each spring: EA/Δs, or what was picked", [this] { return stiffness(); }),
        probe_of("chain_axial_stiffness", "k Δs", "N", "EA of the rod that the springs amount to; exact: that of the rod")
            .formula(*this, "k Δs", {Input::now("k", "stiffness", 0), why_segment()})
            .exactly([this](Real) { return std::optional<Real>(axial_stiffness); }),
        probe_of("energy", "E", "J", "kinetic, elastic and gravitational")
            .formula(*this, "E = K + U + V",
                     {Input::now("K", "kinetic_energy", 0), Input::now("U", "elastic_energy", 0),
                      Input::now("V", "gravitational_energy", 0)})
            .exactly(undamped_start),
        probe_of("elastic_energy", "U", "J", "Σ ½EAε² Δs; exact, of the continuum at rest: M²g²L/(6EA)",
                 [this] { return elastic_energy(); })
            .exactly(
                [this](Real) { return hangs_still() ? std::optional<Real>(continuum().hanging_energy(gravity)) : std::nullopt; }),
        probe_of("kinetic_energy", "K", "J", "½ Σ m v²", [this] { return kinetic_energy_now(); }),
        probe_of("gravitational_energy", "V", "J", "−Σ m g u_s: 0 with all mass at the support",
                 [this] { return gravitational_energy_now(); }),
        probe_of("force_difference", "Δf", "N",
                 "largest difference between −∂U/∂x and the forces of the springs: they are the same forces",
                 [this] { return force_difference(); }),
        probe_of("imbalance", "|f|", "N", "largest force along the rod that springs leave unbalanced, on nodes that are free",
                 [this] { return hangs_still() ? std::optional<Real>(imbalance()) : std::nullopt; }),
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

Real RodLesson::gravitational_energy_now() const {
    return gravitational_energy<2>(node_masses_, weight_acceleration() * along(), position_);
}

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
