// What can be measured of a run: places, energies, growth and frequency, error, work.
#include "integration.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::integration {
namespace {

// How far along its arc a pendulum of 1 kg swings; to the top with more energy than that takes.
Real arc_amplitude(Real energy, Real gravity, Real length) {
    return 2 * length * std::asin(std::sqrt(std::min(Real{1}, energy / (2 * gravity * length))));
}

// Roots of z² − trace z + determinant: the larger modulus.
Real radius(Real trace, Real determinant) {
    const Real discriminant = trace * trace / 4 - determinant;
    return discriminant < 0 ? std::sqrt(determinant) : std::abs(trace) / 2 + std::sqrt(discriminant);
}

std::optional<Real> amplitude_of(const IntegrationLesson& l, Real energy) {
    if (l.omega == 0 || l.is(SwingingKind::stiff_pair)) return std::nullopt;
    if (l.is(SwingingKind::oscillator)) return std::sqrt(2 * energy) / l.omega;
    const Real length = l.motion_->length();
    return energy <= 2 * Swinging::gravity * length ? std::optional(arc_amplitude(energy, Swinging::gravity, length))
                                                    : std::nullopt;
}

// The 2 × 2 matrix A with A (s₋₂, s₋₁) = (s₋₁, s), where a state s is (x, v/ω).
std::optional<Mat<2>> measured_map(const IntegrationLesson& l) {
    constexpr Real too_flat = 1e-7;  // of the two states: below it the direction of one is known from the other
    if (!l.measures_map() || l.counts_[0] < 2) return std::nullopt;
    const Eigen::Vector2d now(l.x_[0], l.v_[0] / l.rate()), one(l.before_[0], l.before_[1] / l.rate()),
        two(l.before_[2], l.before_[3] / l.rate());
    Mat<2> from, to;
    from << two, one;
    to << one, now;
    if (!(std::abs(from.determinant()) > too_flat * two.norm() * one.norm())) return std::nullopt;
    return to * from.inverse();
}

std::optional<Real> theoretical_growth(const IntegrationLesson& l) {
    if (l.omega == 0) return std::nullopt;
    return l.growth_per_step();
}

std::optional<Real> measured_frequency(const IntegrationLesson& l) {
    const auto map = measured_map(l);
    if (!map) return std::nullopt;
    const Real half = map->trace() / 2, discriminant = half * half - map->determinant();
    if (discriminant >= 0) return std::nullopt;
    return std::atan2(std::sqrt(-discriminant), half) / l.dt;
}

// Of what swings with one period: not of a pair, nor of a pendulum that goes over the top or is damped.
std::optional<Real> exact_period(const IntegrationLesson& l) {
    if (l.omega == 0 || l.is(SwingingKind::stiff_pair)) return std::nullopt;
    if (l.is(SwingingKind::oscillator))
        return l.zeta < 1 ? std::optional(2 * std::numbers::pi / (l.omega * std::sqrt((1 - l.zeta) * (1 + l.zeta))))
                          : std::nullopt;
    return l.motion_->pendulum_period();
}

}  // namespace

void IntegrationLesson::declare_probes() {
    const auto exact = [this](Real t, Real Motion::*part) -> std::optional<Real> {
        const auto motion = motion_->exact(watched(), t);
        return motion ? std::optional((*motion).*part) : std::nullopt;
    };
    probes = {
        probe_of(
            "x", "x", "m", "place; of the pendulum along its arc, of the pair the outer mass", [this] { return x_[watched()]; },
            [this] {
                return Explanation{"x = x_m", {Input::now("x_m", "position", watched())}};
            })
            .exactly([exact](Real t) { return exact(t, &Motion::x); }),
        probe_of(
            "v", "v", "m/s", "velocity", [this] { return v_[watched()]; },
            [this] {
                return Explanation{"v = v_m", {Input::now("v_m", "velocity", watched())}};
            })
            .exactly([exact](Real t) { return exact(t, &Motion::v); }),
        probe_of(
            "energy", "E", "J", "kinetic and potential: without drag it never changes, with drag it never grows",
            [this] { return energy(); }, [this] { return why_energy(); })
            .exactly([this](Real t) { return motion_->exact_energy(t); }),
        probe_of(
            "kinetic_energy", "K", "J", "½ m v²", [this] { return kinetic_energy(); }, [this] { return why_kinetic_energy(); }),
        probe_of(
            "potential_energy", "U", "J", "of the spring or springs, or of the height", [this] { return motion_->potential(x_); },
            [this] { return why_potential_energy(); }),
        probe_of(
            "exact_x", "x_e", "m", "the solution in closed form; a damped pendulum has none",
            [this, exact] { return exact(time(), &Motion::x); }, [this] { return why_exact(false); }),
        probe_of(
            "exact_v", "v_e", "m/s", "its velocity", [this, exact] { return exact(time(), &Motion::v); },
            [this] { return why_exact(true); }),
        probe_of(
            "amplitude", "A", "m",
            "how far it would swing with its energy and without drag: √(2E)/ω; for the pendulum 2l asin(√(E/(2gl)))",
            [this] { return amplitude_of(*this, energy()); },
            [this]() -> Explanation {
                if (is(SwingingKind::oscillator))
                    return {"A = √(2 E / m) / ω", {Input::now("E", "energy", 0), unit_mass(), omega}};
                return {"A = 2 l asin(√(E / (2 m g l)))",
                        {Input::now("E", "energy", 0), unit_mass(), Input::constant("g", Swinging::gravity, "m/s²", "gravity"),
                         Input::constant("l", motion_->length(), "m", "length of the pendulum, g/ω²")}};
            })
            .exactly([this](Real t) -> std::optional<Real> {
                const auto e = motion_->exact_energy(t);
                return e ? amplitude_of(*this, *e) : std::nullopt;
            }),
        probe_of(
            "error", "e", "", "distance from the exact motion in the plane of x and v/ω, as a part of the swing",
            [this] { return error(); }, [this] { return why_error(); }),
        probe_of("angle", "θ", "°", "of the pendulum, x/l",
                 [this] {
                     return !is(SwingingKind::pendulum) || omega == 0
                                ? std::nullopt
                                : std::optional<Real>(x_[0] / motion_->length() * 180 / std::numbers::pi);
                 }),
        probe_of(
            "shadow_energy", "Ẽ", "J", "E − Δt/2 v·K x, which semi-implicit Euler keeps in place of the energy",
            [this] { return shadow_energy(); }, [this] { return why_shadow_energy(); }),
        probe_of(
            "growth_measured", "ρ_m", "",
            "by which a step multiplies the motion: the largest eigenvalue of the map that took the latest two states to the "
            "next two; of a pendulum or a pair √(E/E₀) per step of the whole run",
            [this] { return measured_growth(); })
            .exactly([this](Real) { return measures_map() && measured_growth() ? theoretical_growth(*this) : std::nullopt; }),
        probe_of(
            "growth_theory", "ρ", "",
            "the largest eigenvalue of the step's matrix, for the fastest mode or for small swings: above 1 it grows "
            "without end",
            [this] { return theoretical_growth(*this); }, [this] { return why_growth(); }),
        probe_of("frequency_measured", "ω_m", "rad/s", "the angle by which that map turns, over Δt",
                 [this] { return measured_frequency(*this); })
            .exactly([this](Real) { return measured_frequency(*this) ? theoretical_frequency() : std::nullopt; }),
        probe_of(
            "frequency_theory", "ω′", "rad/s", "of the scheme; undamped semi-implicit Euler has sin(ω′Δt/2) = ωΔt/2",
            [this] { return theoretical_frequency(); }, [this] { return why_frequency(); }),
        probe_of("period", "T", "s",
                 "of the latest swings, from one rise through 0 to the next; of a pendulum it grows with the amplitude",
                 [this] { return rhythm_.period(); })
            .exactly([this](Real) { return rhythm_.period() ? exact_period(*this) : std::nullopt; }),
        probe_of("artificial_damping", "ζ_a", "",
                 "damping ratio that the scheme adds to the true one; below 0 it feeds the motion")
            .formula(*this, "ζ_a = − ln(ρ) / (ω Δt) − ζ", {Input::now("ρ", "growth_theory", 0), omega, dt, zeta})
            .when([this] { return measures_map() && zeta < 1; }),
        probe_of("force_evaluations", "", "",
                 "of the latest step; an implicit scheme evaluates the force, and its slope, once in each Newton iteration",
                 [this] { return counts_[1]; }),
        probe_of("force_evaluations_in_all", "", "", "since the start", [this] { return counts_[2]; }),
        probe_of("newton_iterations_used", "", "", "of the latest step",
                 [this] { return implicit() ? std::optional<Real>(static_cast<Real>(integrator_->passes())) : std::nullopt; }),
        probe_of("order", "p", "",
                 "slope of log error against log Δt at a fixed time, from runs of their own with ever smaller steps",
                 [this] { return order(); })
            .exactly([this](Real) { return std::optional(static_cast<Real>(info_of(scheme).order)); })};
}

// ------------------------------------------------------------------------------------------------------ measured now

std::optional<Real> IntegrationLesson::error() const {
    Real largest = 0;
    for (Index n = 0; n < x_.size(); ++n) {
        const auto exact = motion_->exact(n, time());
        if (!exact) return std::nullopt;
        largest = std::max(largest, std::hypot(x_[n] - exact->x, (v_[n] - exact->v) / rate()));
    }
    return largest / motion_->scale();
}

std::optional<Real> IntegrationLesson::measured_growth() const {
    if (measures_map()) {
        const auto map = measured_map(*this);
        return map ? std::optional(radius(map->trace(), map->determinant())) : std::nullopt;
    }
    const Real before = motion_->energy(motion_->start_position(), motion_->start_velocity());
    if (counts_[0] == 0 || before == 0) return std::nullopt;
    return std::pow(energy() / before, 1 / (2 * counts_[0]));
}

std::optional<Real> IntegrationLesson::theoretical_frequency() const {
    if (!measures_map()) return std::nullopt;
    const Real phase = phase_per_step(scheme, omega, zeta, dt);
    return phase > 0 && phase < std::numbers::pi ? std::optional(phase / dt) : std::nullopt;
}

std::optional<Real> IntegrationLesson::shadow_energy() const {
    if (scheme != Scheme::semi_implicit_euler || !motion_->linear()) return std::nullopt;
    const auto K = motion_->stiffness_matrix().topLeftCorner(x_.size(), x_.size());
    return energy() - 0.5 * dt * v_.dot(K * x_);
}

std::optional<Real> IntegrationLesson::order() const { return measured_order(errors_of(scheme)); }

}  // namespace pliant::integration
