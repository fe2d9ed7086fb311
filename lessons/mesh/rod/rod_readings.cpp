// Probes, and what is measured.
#include "rod.h"

#include <pliant/solids/point_masses.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

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

// Laws and assumptions, what a step may be, and what mends a run.

namespace {

constexpr Real margin = 0.8;     // of a limit that a fix keeps to
constexpr Real slowest = 0.002;  // steps shorter than this part of the present ones would take too long

Real rounding_energy(const RodLesson& l) {
    return 0.5 * l.chain_axial_stiffness() * l.length * l.strain_rounding() * l.strain_rounding();
}

// By how much the energy of a sound run may exceed that of the start; beyond the limit of stability nothing is allowed but the
// energy of strains that are rounding.
Real energy_tolerance(const RodLesson& l) {
    const Real solved = is_implicit(l.scheme) ? 1e-6 : 1e-9;
    const Real excess = l.dt <= l.stable_time_step() ? energy_excess(l.scheme, l.fastest() * l.dt, true, l.damped()) : 0;
    return (solved + excess) * l.motion_energy() + rounding_energy(l);
}

std::optional<Fix> stable_fix(const RodLesson& l) {
    const Real limit = l.stable_time_step(),
               verlet = stability_limit(Scheme::velocity_verlet, l.fastest(), l.damping_ratio(l.fastest()));
    if (limit > slowest * l.dt) return fix_by(l.dt, rounded_down(margin * limit, 2));
    if (verlet > slowest * l.dt) {
        Fix fix = fix_by(l.dt, rounded_down(std::min(margin * verlet, Real(l.dt)), 2));
        fix.label = "velocity Verlet, " + fix.label;
        fix.assign.insert(fix.assign.begin(), {"integrator", std::string(info_of(Scheme::velocity_verlet).key)});
        return fix;
    }
    return Fix{"implicit Euler", {{"integrator", std::string(info_of(Scheme::implicit_euler).key)}}};
}

std::string too_large_a_step(const RodLesson& l) {
    const Real limit = l.stable_time_step();
    if (!(l.dt > limit)) return "";
    const std::string_view name = info_of(l.scheme).name;
    const std::string growth =
        fmt::format("the fastest wave, ω = {}, grows by a factor {} per step", format_quantity(l.fastest(), "rad/s", 3),
                    format_quantity(amplification(l.scheme, l.fastest(), l.damping_ratio(l.fastest()), l.dt), "", 4));
    if (limit == 0)
        return fmt::format("{} without damping is stable at no Δt: {}. Give damping, or choose another scheme", name, growth);
    return fmt::format(
        "Δt = {} is above the stability limit of {} ({}, N = {}): {}. Lower the time step or the number of segments, or choose "
        "implicit Euler",
        format_quantity(l.dt, "s"), format_quantity(limit, "s", 3), name, l.count(), growth);
}

}  // namespace

void RodLesson::declare_checks() {
    conserved = {{.probe = "force_difference", .law = Law::zero, .tolerance = [this] { return force_rounding(); }},
                 {.probe = "energy",
                  .law = Law::never_grows,
                  .tolerance = [this] { return energy_tolerance(*this); },
                  .expected = [this] { return !hangs_still(); },
                  .cancels = [this] { return kinetic_energy_now() + elastic_energy() + std::abs(gravitational_energy_now()); }}};
    assumptions = {
        assumption_of(
            "stability", "s", [this] { return Real(dt); }, [this] { return stable_time_step(); },
            "Δt ≤ limit of the scheme for ω = 2√(k/m) sin((2N − 1)π/(2(2N + 1))): Verlet and semi-implicit Euler 2/ω",
            "neighbouring points swing against each other, more in every step, until the run blows up")
            .otherwise("unstable")
            .when([this] { return !hangs_still() && std::isfinite(stable_time_step()); })
            .mended_by([this] { return stable_fix(*this); }),
        assumption_of(
            "not_turned_over", "", [this] { return 1 - (along().transpose() * slope_).minCoeff(); }, [] { return 0.9; },
            "1 − ∂x/∂s ≤ 0.9 along the rod, in every segment",
            "a segment is squeezed to nothing or turned over: |∂x/∂s| does not tell, and the waves are no longer linear")
            .otherwise("turned over")
            .mended_by([this]() -> std::optional<Fix> {
                if (hangs()) return fix_by(dt, rounded_down(dt / 4, 2));
                const Real A = rounded_down(0.2 * std::min(segment(), runs_a_pulse() ? Real{pulse_width} : segment()), 1);
                return fix_by(amplitude, A);
            }),
        assumption_of(
            "pulse_resolved", "", [this] { return segment() / pulse_width; }, [] { return 0.5; }, "Δs ≤ w/2",
            "a pulse as short as the segments falls apart: short waves run slower along a chain than along a rod")
            .otherwise("pulse not resolved")
            .when([this] { return runs_a_pulse(); })
            .mended_by([this]() -> std::optional<Fix> {
                const Real n = std::ceil(2.5 * length / pulse_width);
                if (n <= segments.accepted().max)
                    return Fix{fmt::format("N = {}", n), {{"segments", format_exact(n)}, {"time_step", format_exact(dt)}}};
                const Real w = 5 * length / segments.accepted().max;
                return Fix{fmt::format("N = 200, w = {}", format_quantity(w, "m")),
                           {{"segments", "200"}, {"pulse_width", format_exact(w)}}};
            }),
        assumption_of(
            "rod_of_its_own", "",
            [this] {
                const Real ratio = chain_axial_stiffness() / axial_stiffness;
                return std::max(ratio, 1 / ratio);
            },
            [] { return 1.01; }, "k Δs = EA",
            "springs picked by hand are another rod at every N: EA = k₀ Δs falls as segments are added")
            .otherwise("another rod at each N")
            .mended_by(Fix{"derived springs", {{"spring_rule", "derived"}}}),
    };
}

// ------------------------------------------------------------------------------------------------------------- stability

const VecX& RodLesson::frequencies() const {
    return frequencies_.of({segments, stiffness(), node_mass(), end()},
                           [this] { return chain_frequencies(springs_.stiffness(), node_masses_, end() == RodEnd::fixed); });
}

Real RodLesson::fastest() const {
    const Index modes = chain().modes(end());
    return modes > 0 ? chain().frequency(modes, end()) : Real{0};
}

Real RodLesson::stable_time_step() const { return stability_limit(scheme, fastest(), damping_ratio(fastest())); }

// What motion can come to: kinetic and elastic energy, and of a fall to twice the stretch at rest.
Real RodLesson::motion_energy() const {
    const Real g = weight_acceleration(), fall = g > 0 ? total_mass * g * 2 * chain().hanging_tip(g) : Real{0};
    return kinetic_energy_now() + elastic_energy() + fall;
}

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
    const Real speed = std::sqrt(2 * (start_motion_ + rounding_energy(*this)) / total_mass);
    // What is left at the nodes adds up along the rod to what still moves its tip; so does their rounding.
    const Real rounding = static_cast<Real>(force.cols()) * tension_of(rounding_energy(*this));
    return velocity_.cwiseAbs().maxCoeff() <= part * speed &&
           force.cwiseAbs().sum() <= part * (tension_of(start_motion_) + rounding);
}

std::string RodLesson::unrest() const {
    if (hangs_still() || at_rest() || damped() || dissipates(scheme)) return "";
    return "nothing takes its energy out (damping = 0)";
}

std::optional<Fix> RodLesson::fix(const Failure&) const {
    if (hangs_still()) return std::nullopt;
    if (dt > stable_time_step()) return stable_fix(*this);
    return fix_by(dt, rounded_down(dt / 4, 2));
}

std::string RodLesson::blow_up_hint() const {
    if (hangs_still())
        return "The rod is stretched beyond what numbers can hold: lower gravity or mass, or raise the axial stiffness";
    if (const std::string hint = too_large_a_step(*this); !hint.empty()) return hint;
    const Real limit = stable_time_step();
    return fmt::format(
        "Δt = {}{}: segments have turned over. Lower the amplitude or the time step", format_quantity(dt, "s"),
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
