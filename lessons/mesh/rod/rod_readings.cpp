// Probes, laws, assumptions, and what mends them.
#include "rod.h"

#include <pliant/lesson/format.h>
#include <pliant/solids/point_masses.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::rod {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr Real margin = 0.8;     // of a limit that a fix keeps to
constexpr Real slowest = 0.002;  // steps shorter than this part of the present ones would take too long

Fix with_time_step(Real step) {
    const Real rounded = rounded_down(step, 2);
    return {fmt::format("Δt = {}", format_quantity(rounded, "s")), {{"time_step", format_exact(rounded)}}};
}

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

void RodLesson::declare_checks() {
    conserved = {{.probe = "force_difference", .law = Law::zero, .tolerance = [this] { return force_rounding(); }},
                 {.probe = "energy",
                  .law = Law::never_grows,
                  .tolerance =
                      [this] {
                          // Symplectic schemes let the energy of the fastest waves swing by (ω Δt)²/4 of it.
                          const Real w = std::min(fastest() * dt, Real{2});
                          return (0.02 + w / 2) * (kinetic_energy_now() + elastic_energy()) + 1e-9 * std::abs(start_energy_);
                      },
                  .expected = [this] { return !hangs_still() && dt <= stable_time_step(); }}};
    assumptions = {
        {.name = "stability",
         .unit = "s",
         .value = [this] { return Real(dt); },
         .limit = [this] { return stable_time_step(); },
         .formula = "Δt ≤ limit of the scheme for ω = 2√(k/m) sin((2N − 1)π/(2(2N + 1))): Verlet and semi-implicit Euler 2/ω",
         .broken = "neighbouring points swing against each other, more in every step, until the run blows up",
         .used = [this] { return !hangs_still() && std::isfinite(stable_time_step()); },
         .fix = [this] { return stable_fix(); }},
        {.name = "not_turned_over",
         .value = [this] { return -strain_.minCoeff(); },
         .limit = [] { return 0.9; },
         .formula = "−ε ≤ 0.9 in every segment",
         .broken = "a segment is squeezed to nothing or turned over: |∂x/∂s| does not tell, and the waves are no longer linear",
         .fix = [this]() -> std::optional<Fix> {
             if (hangs()) return with_time_step(dt / 4);
             const Real A = rounded_down(0.2 * std::min(segment(), runs_a_pulse() ? Real{pulse_width} : segment()), 1);
             return Fix{fmt::format("A = {}", format_quantity(A, "m")), {{"amplitude", format_exact(A)}}};
         }},
        {.name = "pulse_resolved",
         .value = [this] { return segment() / pulse_width; },
         .limit = [] { return 0.5; },
         .formula = "Δs ≤ w/2",
         .broken = "a pulse as short as the segments falls apart: short waves run slower along a chain than along a rod",
         .used = [this] { return runs_a_pulse(); },
         .fix = [this]() -> std::optional<Fix> {
             const Real n = std::ceil(2.5 * length / pulse_width);
             if (n <= segments.accepted().max)
                 return Fix{fmt::format("N = {}", n), {{"segments", format_exact(n)}, {"time_step", format_exact(dt)}}};
             const Real w = 5 * length / segments.accepted().max;
             return Fix{fmt::format("N = 200, w = {}", format_quantity(w, "m")),
                        {{"segments", "200"}, {"pulse_width", format_exact(w)}}};
         }},
        {.name = "rod_of_its_own",
         .value =
             [this] {
                 const Real ratio = chain_axial_stiffness() / axial_stiffness;
                 return std::max(ratio, 1 / ratio);
             },
         .limit = [] { return 1.01; },
         .formula = "k Δs = EA",
         .broken = "springs picked by hand are another rod at every N: EA = k₀ Δs falls as segments are added",
         .fix =
             [] {
                 return std::optional(Fix{"derived springs", {{"spring_rule", "derived"}}});
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

// ------------------------------------------------------------------------------------------------------------- stability

const VecX& RodLesson::frequencies() const {
    const ChainKey key{segments, stiffness(), node_mass(), end()};
    if (frequencies_key_ != key) {
        frequencies_ = chain_frequencies(springs_.stiffness(), node_masses_, end() == RodEnd::fixed);
        frequencies_key_ = key;
    }
    return frequencies_;
}

Real RodLesson::fastest() const {
    const Index modes = chain().modes(end());
    return modes > 0 ? chain().frequency(modes, end()) : Real{0};
}

Real RodLesson::stable_time_step() const { return stability_limit(scheme, fastest(), damping_ratio(fastest())); }

std::optional<Fix> RodLesson::stable_fix() const {
    const Real limit = stable_time_step(), verlet = stability_limit(Scheme::velocity_verlet, fastest(), damping_ratio(fastest()));
    if (limit > slowest * dt) return with_time_step(margin * limit);
    if (verlet > slowest * dt) {
        Fix fix = with_time_step(std::min(margin * verlet, Real(dt)));
        fix.label = "velocity Verlet, " + fix.label;
        fix.assign.insert(fix.assign.begin(), {"scheme", std::string(info_of(Scheme::velocity_verlet).key)});
        return fix;
    }
    return Fix{"implicit Euler", {{"scheme", std::string(info_of(Scheme::implicit_euler).key)}}};
}

std::optional<Fix> RodLesson::fix(const Failure&) const {
    if (hangs_still()) return std::nullopt;
    if (dt > stable_time_step()) return stable_fix();
    return with_time_step(dt / 4);
}

std::string RodLesson::too_large_a_step() const {
    const Real limit = stable_time_step();
    if (!(dt > limit)) return "";
    const std::string_view name = info_of(scheme).name;
    const std::string growth =
        fmt::format("the fastest wave, ω = {}, grows by a factor {} per step", format_quantity(fastest(), "rad/s", 3),
                    format_quantity(amplification(scheme, fastest(), damping_ratio(fastest()), dt), "", 4));
    if (limit == 0)
        return fmt::format("{} without damping is stable at no Δt: {}. Give damping, or choose another scheme", name, growth);
    return fmt::format(
        "Δt = {} is above the stability limit of {} ({}, N = {}): {}. Lower time_step or segments, or choose implicit_euler",
        format_quantity(dt, "s"), format_quantity(limit, "s", 3), name, count(), growth);
}

std::string RodLesson::blow_up_hint() const {
    if (hangs_still())
        return "The rod is stretched beyond what numbers can hold: lower gravity or mass, or raise axial_stiffness";
    if (const std::string hint = too_large_a_step(); !hint.empty()) return hint;
    const Real limit = stable_time_step();
    return fmt::format(
        "Δt = {}{}: segments have turned over. Lower amplitude or time_step", format_quantity(dt, "s"),
        std::isfinite(limit) ? fmt::format(" is below the stability limit {}", format_quantity(limit, "s", 3)) : "");
}

// Twice the segments and half the step, up to the most there are; then the step alone.
std::vector<std::pair<std::string, std::string>> RodLesson::finer() const {
    if (hangs_still() && segments >= 200) return {};
    std::vector<std::pair<std::string, std::string>> finer_run;
    if (segments < 200) finer_run.emplace_back("segments", std::to_string(std::min<Index>(2 * segments, 200)));
    if (!hangs_still()) finer_run.emplace_back("time_step", format_exact(dt / 2));
    return finer_run;
}

}  // namespace pliant::rod
