// What can be measured of a run: places, energies, growth and frequency, error, work.
#include "integration.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::integration {
namespace {

Explanation of_one(std::string formula, Input input) {
    return {std::move(formula), {std::move(input)}, [](std::span<const Real> x) { return x[0]; }};
}

// How far along its arc a pendulum of 1 kg swings; to the top with more energy than that takes.
Real arc_amplitude(Real energy, Real gravity, Real length) {
    return 2 * length * std::asin(std::sqrt(std::min(Real{1}, energy / (2 * gravity * length))));
}

// Roots of z² − trace z + determinant: the larger modulus.
Real radius(Real trace, Real determinant) {
    const Real discriminant = trace * trace / 4 - determinant;
    return discriminant < 0 ? std::sqrt(determinant) : std::abs(trace) / 2 + std::sqrt(discriminant);
}

}  // namespace

void IntegrationLesson::declare_probes() {
    const auto exact = [this](Real t, Real Motion::*part) -> std::optional<Real> {
        const auto motion = motion_->exact(watched(), t);
        return motion ? std::optional((*motion).*part) : std::nullopt;
    };
    probes = {{.name = "x",
               .symbol = "x",
               .unit = "m",
               .help = "place; of the pendulum along its arc, of the pair the outer mass",
               .value = [this] { return x_[watched()]; },
               .exact = [exact](Real t) { return exact(t, &Motion::x); },
               .explain = [this] { return of_one("x = x_m", Input::now("x_m", "position", watched())); }},
              {.name = "v",
               .symbol = "v",
               .unit = "m/s",
               .help = "velocity",
               .value = [this] { return v_[watched()]; },
               .exact = [exact](Real t) { return exact(t, &Motion::v); },
               .explain = [this] { return of_one("v = v_m", Input::now("v_m", "velocity", watched())); }},
              {.name = "energy",
               .symbol = "E",
               .unit = "J",
               .help = "kinetic and potential: without drag it never changes, with drag it never grows",
               .value = [this] { return energy(); },
               .exact = [this](Real t) { return motion_->exact_energy(t); },
               .explain = [this] { return why_energy(); }},
              {.name = "kinetic_energy",
               .symbol = "K",
               .unit = "J",
               .help = "½ m v²",
               .value = [this] { return kinetic_energy(); },
               .explain = [this] { return why_kinetic_energy(); }},
              {.name = "potential_energy",
               .symbol = "U",
               .unit = "J",
               .help = "of the spring or springs, or of the height",
               .value = [this] { return motion_->potential(x_); },
               .explain = [this] { return why_potential_energy(); }},
              {.name = "exact_x",
               .symbol = "x_e",
               .unit = "m",
               .help = "the solution in closed form; a damped pendulum has none",
               .value = [this, exact] { return exact(time(), &Motion::x); },
               .explain = [this] { return why_exact(false); }},
              {.name = "exact_v",
               .symbol = "v_e",
               .unit = "m/s",
               .help = "its velocity",
               .value = [this, exact] { return exact(time(), &Motion::v); },
               .explain = [this] { return why_exact(true); }},
              {.name = "amplitude",
               .symbol = "A",
               .unit = "m",
               .help = "how far it would swing with its energy and without drag: √(2E)/ω; for the pendulum 2l asin(√(E/(2gl)))",
               .value = [this] { return amplitude_of(energy()); },
               .exact = [this](Real t) -> std::optional<Real> {
                   const auto e = motion_->exact_energy(t);
                   return e ? amplitude_of(*e) : std::nullopt;
               },
               .explain = [this]() -> Explanation {
                   if (is(System::oscillator))
                       return {"A = √(2 E / m) / ω", {Input::now("E", "energy", 0), unit_mass(), Input::of(omega)}};
                   return {"A = 2 l asin(√(E / (2 m g l)))",
                           {Input::now("E", "energy", 0), unit_mass(), Input::constant("g", Swinging::gravity, "m/s²", "gravity"),
                            Input::constant("l", motion_->length(), "m", "length of the pendulum, g/ω²")}};
               }},
              {.name = "error",
               .symbol = "e",
               .help = "distance from the exact motion in the plane of x and v/ω, as a part of the swing",
               .value = [this] { return error(); },
               .explain = [this] { return why_error(); }},
              {.name = "angle",
               .symbol = "θ",
               .unit = "°",
               .help = "of the pendulum, x/l",
               .value = [this]() -> std::optional<Real> {
                   if (!is(System::pendulum) || omega == 0) return std::nullopt;
                   return x_[0] / motion_->length() * 180 / std::numbers::pi;
               }},
              {.name = "shadow_energy",
               .symbol = "Ẽ",
               .unit = "J",
               .help = "E − Δt/2 v·K x, which semi-implicit Euler keeps in place of the energy",
               .value = [this] { return shadow_energy(); },
               .explain = [this] { return why_shadow_energy(); }}};
}

void IntegrationLesson::declare_growth_probes() {
    const std::array<Probe, 6> growth{
        Probe{
            .name = "growth_measured",
            .symbol = "ρ_m",
            .help =
                "by which a step multiplies the motion: the largest eigenvalue of the map that took the latest two states to the "
                "next two; of a pendulum or a pair √(E/E₀) per step of the whole run",
            .value = [this] { return measured_growth(); },
            .exact = [this](Real) { return measures_map() && measured_growth() ? theoretical_growth() : std::nullopt; }},
        Probe{.name = "growth_theory",
              .symbol = "ρ",
              .help = "the largest eigenvalue of the step's matrix, for the fastest mode or for small swings: above 1 it grows "
                      "without end",
              .value = [this] { return theoretical_growth(); },
              .explain = [this] { return why_growth(); }},
        Probe{.name = "frequency_measured",
              .symbol = "ω_m",
              .unit = "rad/s",
              .help = "the angle by which that map turns, over Δt",
              .value = [this] { return measured_frequency(); },
              .exact = [this](Real) { return measured_frequency() ? theoretical_frequency() : std::nullopt; }},
        Probe{.name = "frequency_theory",
              .symbol = "ω′",
              .unit = "rad/s",
              .help = "of the scheme; undamped semi-implicit Euler has sin(ω′Δt/2) = ωΔt/2",
              .value = [this] { return theoretical_frequency(); },
              .explain = [this] { return why_frequency(); }},
        Probe{.name = "period",
              .symbol = "T",
              .unit = "s",
              .help = "of the latest swings, from one rise through 0 to the next; of a pendulum it grows with the amplitude",
              .value = [this] { return rhythm_.period(); },
              .exact = [this](Real) { return rhythm_.period() ? exact_period() : std::nullopt; }},
        Probe{.name = "artificial_damping",
              .symbol = "ζ_a",
              .help = "damping ratio that the scheme adds to the true one; below 0 it feeds the motion",
              .value = [this] { return artificial_damping(); },
              .explain = [this]() -> Explanation {
                  return {"ζ_a = − ln(ρ) / (ω Δt) − ζ",
                          {Input::now("ρ", "growth_theory", 0), Input::of(omega), Input::of(dt), Input::of(zeta)}};
              }}};
    probes.insert(probes.end(), growth.begin(), growth.end());
}

void IntegrationLesson::declare_work_probes() {
    probes.push_back(
        {.name = "force_evaluations",
         .help = "of the latest step; an implicit scheme evaluates the force, and its slope, once in each Newton iteration",
         .value = [this] { return counts_[1]; }});
    probes.push_back({.name = "force_evaluations_in_all", .help = "since the start", .value = [this] { return counts_[2]; }});
    probes.push_back({.name = "newton_iterations_used", .help = "of the latest step", .value = [this]() -> std::optional<Real> {
                          if (!implicit()) return std::nullopt;
                          return static_cast<Real>(integrator_->passes());
                      }});
    probes.push_back({.name = "order",
                      .symbol = "p",
                      .help = "slope of log error against log Δt at a fixed time, from runs of their own with ever smaller steps",
                      .value = [this] { return order(); },
                      .exact = [this](Real) { return std::optional(static_cast<Real>(info_of(scheme).order)); }});
}

// ------------------------------------------------------------------------------------------------------ measured now

std::optional<Real> IntegrationLesson::amplitude_of(Real energy) const {
    if (omega == 0 || is(System::stiff_pair)) return std::nullopt;
    if (is(System::oscillator)) return std::sqrt(2 * energy) / omega;
    const Real l = motion_->length();
    return energy <= 2 * Swinging::gravity * l ? std::optional(arc_amplitude(energy, Swinging::gravity, l)) : std::nullopt;
}

std::optional<Real> IntegrationLesson::error() const {
    Real largest = 0;
    for (Index n = 0; n < x_.size(); ++n) {
        const auto exact = motion_->exact(n, time());
        if (!exact) return std::nullopt;
        largest = std::max(largest, std::hypot(x_[n] - exact->x, (v_[n] - exact->v) / rate()));
    }
    return largest / motion_->scale();
}

// The 2 × 2 matrix A with A (s₋₂, s₋₁) = (s₋₁, s), where a state s is (x, v/ω).
std::optional<Mat<2>> IntegrationLesson::measured_map() const {
    constexpr Real too_flat = 1e-7;  // of the two states: below it the direction of one is known from the other
    if (!measures_map() || counts_[0] < 2) return std::nullopt;
    const Eigen::Vector2d now(x_[0], v_[0] / rate()), one(before_[0], before_[1] / rate()), two(before_[2], before_[3] / rate());
    Mat<2> from, to;
    from << two, one;
    to << one, now;
    if (!(std::abs(from.determinant()) > too_flat * two.norm() * one.norm())) return std::nullopt;
    return to * from.inverse();
}

std::optional<Real> IntegrationLesson::measured_growth() const {
    if (measures_map()) {
        const auto map = measured_map();
        return map ? std::optional(radius(map->trace(), map->determinant())) : std::nullopt;
    }
    const Real before = motion_->energy(motion_->start_position(), motion_->start_velocity());
    if (counts_[0] == 0 || before == 0) return std::nullopt;
    return std::pow(energy() / before, 1 / (2 * counts_[0]));
}

std::optional<Real> IntegrationLesson::theoretical_growth() const {
    if (omega == 0) return std::nullopt;
    return growth_per_step();
}

std::optional<Real> IntegrationLesson::measured_frequency() const {
    const auto map = measured_map();
    if (!map) return std::nullopt;
    const Real half = map->trace() / 2, discriminant = half * half - map->determinant();
    if (discriminant >= 0) return std::nullopt;
    return std::atan2(std::sqrt(-discriminant), half) / dt;
}

std::optional<Real> IntegrationLesson::theoretical_frequency() const {
    if (!measures_map()) return std::nullopt;
    const Real phase = phase_per_step(scheme, omega, zeta, dt);
    return phase > 0 && phase < std::numbers::pi ? std::optional(phase / dt) : std::nullopt;
}

std::optional<Real> IntegrationLesson::artificial_damping() const {
    if (!measures_map() || zeta >= 1 || growth_per_step() == 0) return std::nullopt;
    return -std::log(growth_per_step()) / (omega * dt) - zeta;
}

std::optional<Real> IntegrationLesson::shadow_energy() const {
    if (scheme != Scheme::semi_implicit_euler || !motion_->linear()) return std::nullopt;
    const auto K = motion_->stiffness_matrix().topLeftCorner(x_.size(), x_.size());
    return energy() - 0.5 * dt * v_.dot(K * x_);
}

// Of what swings with one period: not of a pair, nor of a pendulum that goes over the top or is damped.
std::optional<Real> IntegrationLesson::exact_period() const {
    if (omega == 0 || is(System::stiff_pair)) return std::nullopt;
    if (is(System::oscillator))
        return zeta < 1 ? std::optional(2 * std::numbers::pi / (omega * std::sqrt((1 - zeta) * (1 + zeta)))) : std::nullopt;
    return motion_->pendulum_period();
}

std::optional<Real> IntegrationLesson::order() const { return measured_order(errors_of(scheme)); }

}  // namespace pliant::integration
