// Laws and assumptions, what a step may be, and what mends a run.
#include "rod.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::rod {
namespace {

constexpr Real margin = 0.8;     // of a limit that a fix keeps to
constexpr Real slowest = 0.002;  // steps shorter than this part of the present ones would take too long

Fix with_time_step(Real step) {
    const Real rounded = rounded_down(step, 2);
    return {fmt::format("Δt = {}", format_quantity(rounded, "s")), {{"time_step", format_exact(rounded)}}};
}

}  // namespace

void RodLesson::declare_checks() {
    conserved = {{.probe = "force_difference", .law = Law::zero, .tolerance = [this] { return force_rounding(); }},
                 {.probe = "energy",
                  .law = Law::never_grows,
                  .tolerance = [this] { return energy_tolerance(); },
                  .expected = [this] { return !hangs_still(); },
                  .cancels = [this] { return kinetic_energy_now() + elastic_energy() + std::abs(gravitational_energy_now()); }}};
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
         .value = [this] { return 1 - (along().transpose() * slope_).minCoeff(); },
         .limit = [] { return 0.9; },
         .formula = "1 − ∂x/∂s ≤ 0.9 along the rod, in every segment",
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

// By how much the energy of a sound run may exceed that of the start; beyond the limit of stability nothing is allowed but the
// energy of strains that are rounding.
Real RodLesson::energy_tolerance() const {
    const Real solved = is_implicit(scheme) ? 1e-6 : 1e-9;
    const Real excess = dt <= stable_time_step() ? energy_excess(scheme, fastest() * dt, true, damped()) : 0;
    return (solved + excess) * motion_energy() + rounding_energy();
}

// What motion can come to: kinetic and elastic energy, and of a fall to twice the stretch at rest.
Real RodLesson::motion_energy() const {
    const Real g = weight_acceleration(), fall = g > 0 ? total_mass * g * 2 * chain().hanging_tip(g) : Real{0};
    return kinetic_energy_now() + elastic_energy() + fall;
}

Real RodLesson::rounding_energy() const { return 0.5 * chain_axial_stiffness() * length * strain_rounding() * strain_rounding(); }

// Slow, and in balance, against what the motion of the start comes to if all of the rod takes part.
bool RodLesson::at_rest() const {
    if (hangs_still()) return clock_[balanced] == 1;
    constexpr Real part = 1e-4;
    Points<2> force = Points<2>::Zero(2, position_.cols());
    add_spring_forces<2>(springs_, position_, force);
    for (Index i = 0; i < force.cols(); ++i)
        if (inertia_.fixed(2 * i))
            force.col(i).setZero();
        else
            force.col(i) += node_masses_[i] * weight_acceleration() * along();
    const auto tension_of = [this](Real energy) { return std::sqrt(2 * energy * chain_axial_stiffness() / length); };
    const Real speed = std::sqrt(2 * (start_motion_ + rounding_energy()) / total_mass);
    // What is left at the nodes adds up along the rod to what still moves its tip; so does their rounding.
    const Real rounding = static_cast<Real>(force.cols()) * tension_of(rounding_energy());
    return velocity_.cwiseAbs().maxCoeff() <= part * speed &&
           force.cwiseAbs().sum() <= part * (tension_of(start_motion_) + rounding);
}

std::string RodLesson::unrest() const {
    if (hangs_still() || at_rest() || damped() || dissipates(scheme)) return "";
    return "nothing takes its energy out (damping = 0)";
}

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
