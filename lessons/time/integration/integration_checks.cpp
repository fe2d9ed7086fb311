// Under which conditions a run can be trusted, what it must obey, and which parameters mend what does not.
#include "integration.h"

#include <pliant/run/until.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::integration {
namespace {

constexpr Real margin = 0.8;       // of a limit, in a fix
constexpr Real most_phase = 0.25;  // rad per step: 25 steps in a swing
constexpr Real slowest = 1e-3;     // steps shorter than this part of the present ones would take too long
constexpr Real solved = 1e-6;      // part of the energy that a step of Newton's method may leave open

std::string name_of(Scheme scheme) {
    std::string name(info_of(scheme).name);
    if (name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

// By how much the energy of a sound run may exceed that of the start: symplectic schemes let it swing about its mean, without end
// but bounded; beyond the limit nothing is allowed.
Real energy_tolerance(const IntegrationLesson& l) {
    const Real start = l.motion_->energy(l.motion_->start_position(), l.motion_->start_velocity());
    const Real rounding = l.implicit() ? solved : 1e-9;
    if (!l.stable()) return rounding * start;
    return start * (rounding + energy_excess(l.scheme, l.motion_->fast_rate() * l.dt, l.motion_->linear(), l.motion_->damped()));
}

// A shorter step, or where it would have to be very short or does not exist another scheme.
std::optional<Fix> stable_fix(const IntegrationLesson& l) {
    const Real limit = l.stable_time_step(), other = stability_limit(Scheme::semi_implicit_euler, l.motion_->fast_rate(), l.zeta);
    if (limit > slowest * l.dt) return fix_by(l.dt, rounded_down(margin * limit, 2));
    if (l.scheme != Scheme::semi_implicit_euler && l.dt <= margin * other)
        return Fix{"semi-implicit Euler", {{"integrator", "semi_implicit_euler"}}};
    return Fix{"implicit Euler", {{"integrator", "implicit_euler"}}};
}

std::optional<Fix> accurate_fix(const IntegrationLesson& l) {
    return fix_by(l.dt, rounded_down(margin * most_phase / l.motion_->slow_rate(), 2));
}

}  // namespace

void IntegrationLesson::declare_checks() {
    assumptions = {
        assumption_of(
            "stability", "s", [this] { return Real(dt); }, [this] { return stable_time_step(); },
            "explicit Euler: Δt ≤ 2ζ/ω up to ζ = 1, none without damping, beyond it (2/ω)(ζ − √(ζ² − 1));  semi-implicit: Δt ≤ "
            "(2/ω)(√(1 + ζ²) − ζ);  Verlet: 2/ω and Runge–Kutta 4: 2.83/ω without damping;  ω of the fastest mode",
            "every step makes the motion larger, until nothing else is left of it")
            .otherwise("unstable")
            .when([this] { return !implicit() && omega > 0; })
            .mended_by([this] { return stable_fix(*this); }),
        assumption_of(
            "accuracy", "rad", [this] { return motion_->slow_rate() * dt; }, [] { return most_phase; },
            "ωΔt ≤ ¼: 25 steps in a swing, of the slow mode",
            "a step is a large part of a swing: what is stable then still swings at a wrong rate, and schemes that damp stop it")
            .otherwise("coarse steps")
            .when([this] { return omega > 0; })
            .mended_by([this] { return accurate_fix(*this); })};
    conserved = {
        {.probe = "energy", .law = Law::never_grows, .tolerance = [this] { return energy_tolerance(*this); }},
        {.probe = "shadow_energy",
         .law = Law::constant,
         .tolerance = [this] { return 1e-9 * motion_->energy(motion_->start_position(), motion_->start_velocity()); },
         .expected =
             [this] { return scheme == Scheme::semi_implicit_euler && motion_->linear() && !motion_->damped() && stable(); }}};
}

namespace {
constexpr Real still = 1e-4;  // of the swing of the start
}

bool IntegrationLesson::at_rest() const {
    return energy() <= still * still * motion_->energy(motion_->start_position(), motion_->start_velocity());
}

// Its steps are counted by the slower of its modes, each multiplied by a factor that is known.
std::string IntegrationLesson::unrest() const {
    if (at_rest()) return "";
    if (omega == 0) return "no force acts on it, and it goes on at its speed (omega = 0)";
    const Real factor = std::max(amplification(scheme, motion_->slow_rate(), zeta, dt), growth_per_step());
    const Real steps = factor < 1 ? std::log(still) / std::log(factor) : std::numeric_limits<Real>::infinity();
    if (steps < static_cast<Real>(max_steps_to_rest)) return "";
    if (growth_per_step() > 1 + 1e-9) return fmt::format("{} makes it larger in every step", name_of(scheme));
    if (zeta == 0) return "nothing takes its energy out (damping_ratio = 0)";
    return fmt::format("it is damped so little that it would take {} steps", format_quantity(steps, "", 3));
}

std::string IntegrationLesson::blow_up_hint() const {
    if (implicit()) return "Lower the time step, or allow more Newton iterations";
    const Real limit = stable_time_step(), w = motion_->fast_rate();
    const std::string growth = fmt::format("every step multiplies the motion of ω = {} by {}", format_quantity(w, "rad/s", 3),
                                           format_quantity(growth_per_step(), "", 5));
    if (limit == 0)
        return fmt::format(
            "{} without damping is stable at no Δt: {} = √(1 + ω²Δt²). Choose another integrator, or raise the damping ratio",
            name_of(scheme), growth);
    if (dt > limit)
        return fmt::format("Δt = {} is above the limit of {} for {}: {}. Lower the time step, or choose implicit Euler",
                           format_quantity(dt, "s"), format_quantity(limit, "s"), info_of(scheme).name, growth);
    return fmt::format("Δt = {} is below the limit {} of small motions. Lower the time step", format_quantity(dt, "s"),
                       format_quantity(limit, "s", 3));
}

std::optional<Fix> IntegrationLesson::fix(const Failure&) const {
    if (!implicit() && dt > stable_time_step()) return stable_fix(*this);
    if (implicit() && newton_cap < 20) return Fix{"100 Newton iterations", {{"newton_iterations", "100"}}};
    return fix_by(dt, rounded_down(dt / 4, 2));
}

std::vector<Fix> IntegrationLesson::other_fixes(const Failure&) const {
    if (implicit()) return {fix_by(dt, rounded_down(dt / 4, 2))};
    return {Fix{"implicit Euler", {{"integrator", "implicit_euler"}}}};
}

std::vector<std::pair<std::string, std::string>> IntegrationLesson::finer() const {
    const Real step = omega > 0 ? std::min(Real(dt) / 8, 0.05 / (motion_->fast_rate() * std::max(Real{1}, Real(zeta)))) : dt / 8;
    return {{"integrator", "runge_kutta_4"}, {"time_step", format_exact(dt / std::ceil(dt / step))}};
}

}  // namespace pliant::integration
