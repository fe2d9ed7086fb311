// Why the probes are what they are: energies, the exact motion, growth and frequency by theory.
#include "integration.h"

#include <fmt/format.h>

#include <cmath>

namespace pliant::integration {

// ------------------------------------------------------------------------------------------------------------- energy

Explanation IntegrationLesson::why_energy() const {
    return {"E = K + U", {Input::now("K", "kinetic_energy", 0), Input::now("U", "potential_energy", 0)}};
}

Explanation IntegrationLesson::why_kinetic_energy() const {
    Explanation e{.formula = x_.size() == 2 ? "K = ½ (v_1² + v_2²)  with m = 1 kg" : "K = ½ v_1²  with m = 1 kg",
                  .inputs = {},
                  .evaluate = [](std::span<const Real> v) {
                      Real sum = 0;
                      for (const Real each : v) sum += each * each;
                      return sum / 2;
                  }};
    for (Index n = 0; n < x_.size(); ++n) e.inputs.push_back(Input::now(fmt::format("v_{}", n + 1), "velocity", n));
    return e;
}

// With f_0, the force of the springs alone.
Explanation IntegrationLesson::why_shadow_energy() const {
    Explanation e{"Ẽ = E + ½ Δt Σ v f_0", {Input::now("E", "energy", 0), Input::of(dt)}, {}};
    for (Index n = 0; n < x_.size(); ++n) {
        Explanation pull{"f_0 = − Σ K x", {}, {}};
        const Index count = x_.size();
        pull.evaluate = [](std::span<const Real> q) {
            Real sum = 0;
            for (std::size_t k = 0; k + 1 < q.size(); k += 2) sum -= q[k] * q[k + 1];
            return sum;
        };
        pull.substitute = [](std::span<const Real> q) { return "−(" + products_text(q) + ")"; };
        for (Index m = 0; m < count; ++m) {
            pull.inputs.push_back(Input::constant("K", motion_->stiffness_matrix()(n, m), "N/m", "stiffness"));
            pull.inputs.push_back(Input::now("x", "position", m));
        }
        e.inputs.push_back(Input::now("v", "velocity", n));
        e.inputs.push_back(Input::part("f_0", "N", std::move(pull)));
    }
    e.evaluate = [](std::span<const Real> q) {
        Real sum = 0;
        for (std::size_t k = 2; k + 1 < q.size(); k += 2) sum += q[k] * q[k + 1];
        return q[0] + q[1] / 2 * sum;
    };
    e.substitute = [](std::span<const Real> q) {
        return as_factor(q[0]) + " + ½ · " + as_factor(q[1]) + " · (" + products_text(q.subspan(2)) + ")";
    };
    return e;
}

Explanation IntegrationLesson::why_potential_energy() const {
    if (omega == 0) return fixed_value("U = 0: without ω there is no spring", 0);
    if (is(System::oscillator)) return {"U = ½ m ω² x²", {unit_mass(), Input::of(omega), Input::now("x", "position", 0)}};
    if (is(System::pendulum))
        return {"U = m g l (1 − cos(x / l))",
                {unit_mass(), Input::constant("g", Swinging::gravity, "m/s²", "gravity"),
                 Input::constant("l", motion_->length(), "m", "length of the pendulum, g/ω²"), Input::now("x", "position", 0)}};
    return {"U = ½ ω² x_1² + ½ κ ω² (x_2 − x_1)²  with m = 1 kg",
            {Input::of(omega), Input::now("x_1", "position", 0), Input::of(ratio), Input::now("x_2", "position", 1)},
            [](std::span<const Real> q) {
                const Real soft = q[0] * q[0], apart = q[3] - q[1];
                return 0.5 * soft * q[1] * q[1] + 0.5 * q[2] * soft * apart * apart;
            }};
}

// -------------------------------------------------------------------------------------------------- the exact motion

// Below critical damping, where it is short to write.
Explanation IntegrationLesson::why_exact(bool of_velocity) const {
    const char* symbol = of_velocity ? "v_e" : "x_e";
    const auto motion = motion_->exact(watched(), time());
    const Real now = motion ? (of_velocity ? motion->v : motion->x) : 0;
    if (!is(System::oscillator) || zeta >= 1 || omega == 0)
        return fixed_value(fmt::format("{}: {}", symbol,
                                       is(System::pendulum)     ? "by Jacobi's elliptic functions"
                                       : is(System::stiff_pair) ? "the sum of two modes, each of them an oscillator"
                                       : omega == 0             ? "a free motion, x₀ + v₀ t"
                                                                : "the sum of two decays, exp(−ω(ζ ± √(ζ² − 1)) t)"),
                           now);
    const Real turning = omega * std::sqrt((1 - zeta) * (1 + zeta));
    std::vector<Input> inputs{Input::of(zeta), Input::of(omega), Input::constant("t", time(), "s", "the time"),
                              Input::of(x0),   Input::of(v0),    Input::constant("ω_d", turning, "rad/s", "ω √(1 − ζ²)")};
    if (of_velocity) return {"v_e = exp(− ζ ω t) (v₀ cos(ω_d t) − (ω² x₀ + ζ ω v₀) sin(ω_d t) / ω_d)", std::move(inputs)};
    return {"x_e = exp(− ζ ω t) (x₀ cos(ω_d t) + (v₀ + ζ ω x₀) sin(ω_d t) / ω_d)", std::move(inputs)};
}

Explanation IntegrationLesson::why_error() const {
    if (is(System::stiff_pair)) return fixed_value("e: the larger one of the two masses, as a part of the swing", *error());
    return {
        "e = √((x − x_e)² + ((v − v_e) / w)²) / s",
        {Input::now("x", "x", 0), Input::now("x_e", "exact_x", 0), Input::now("v", "v", 0), Input::now("v_e", "exact_v", 0),
         Input::constant("w", rate(), "rad/s", "ω"), Input::constant("s", motion_->scale(), "m", "how far the start can swing")}};
}

// --------------------------------------------------------------------------------------------- growth and frequency

Explanation IntegrationLesson::why_growth() const {
    const Input w = Input::constant("ω", motion_->fast_rate(), "rad/s", "of the fastest mode"), step = Input::of(dt);
    if (zeta == 0 && scheme == Scheme::explicit_euler) return {"ρ = √(1 + ω² Δt²)", {w, step}};
    if (zeta == 0 && scheme == Scheme::implicit_euler) return {"ρ = 1 / √(1 + ω² Δt²)", {w, step}};
    return fixed_value("ρ: the largest eigenvalue of the matrix that takes (x, Δt v) from one step to the next",
                       growth_per_step());
}

Explanation IntegrationLesson::why_frequency() const {
    if (zeta == 0 && (scheme == Scheme::semi_implicit_euler || scheme == Scheme::velocity_verlet))
        return {"ω′ = 2 asin(ω Δt / 2) / Δt", {Input::of(omega), Input::of(dt)}};
    return {"ω′ = φ / Δt",
            {Input::constant("φ", phase_per_step(scheme, omega, zeta, dt), "rad", "angle of the eigenvalue of the step's matrix"),
             Input::of(dt)}};
}

}  // namespace pliant::integration
