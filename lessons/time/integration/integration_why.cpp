// Why forces, passes and the end of a step are what they are; and the probes: energies, the exact motion, growth and frequency by
// theory.
#include "integration.h"
#include "kits/schemes/scheme_why.h"

#include <fmt/format.h>

#include <cmath>

namespace pliant::integration {
namespace {

std::string of_mass(std::string_view symbol, Index dof, std::string_view mark) {
    return fmt::format("{}_{}{}", symbol, dof + 1, mark);
}

Input before_start(const IntegrationLesson& l, bool of_velocity, Index dof) {
    const Index n = l.x_.size(), first = (l.inside(l.force_known) ? 0 : 2 * n) + (of_velocity ? n : 0);
    return Input::constant(of_velocity ? "v_b" : "x_b", l.before_[first + dof], of_velocity ? "m/s" : "m",
                           of_velocity ? "velocity one step before the start" : "place one step before the start");
}

bool steps_back(const IntegrationLesson& l) {
    return l.scheme == Scheme::bdf2 && l.counts_[0] > (l.inside(l.force_known) ? 0 : 1);
}

// x̂: where the mass would be at the time that is solved for if no force acted from now on.
Explanation why_prediction(const IntegrationLesson& l, Index dof) {
    const Input x = Input::before("x", "position", dof), v = Input::before("v", "velocity", dof), step = Input::of(l.dt);
    if (l.scheme == Scheme::implicit_midpoint) return {"x̂ = x + ½ Δt v", {x, step, v}};
    if (l.scheme == Scheme::newmark)
        return {"x̂ = x + Δt v + ¼ Δt² f / m", {x, step, v, Input::now("f", "force", dof), l.unit_mass()}};
    if (steps_back(l))
        return {"x̂ = (4 x − x_b) / 3 + ⅔ Δt (4 v − v_b) / 3",
                {x, before_start(l, false, dof), step, v, before_start(l, true, dof)}};
    return {"x̂ = x + Δt v", {x, step, v}};
}

// What the iterate before the pass left unbalanced: m a − f, where the scheme says a = h_a (X − x̂).
Explanation why_residual(const IntegrationLesson& l, Index dof) {
    const ImplicitForm& form = l.integrator_->solver().form();
    return {"r = m h_a (X_k − x̂) − f_k",
            {l.unit_mass(), Input::constant("h_a", form.acceleration_rate, "1/s²", "of the scheme: a = h_a (X − x̂)"),
             Input::earlier("X_k", "trial_position", dof), Input::part("x̂", "m", why_prediction(l, dof)),
             Input::part("f_k", "N", l.why_force(dof, "trial_position", "trial_velocity", Input::earlier, "_k"))}};
}

// One row of H d = −r.
Input newton_direction(const IntegrationLesson& l, Index dof) {
    const ImplicitSolver& solver = l.integrator_->solver();
    const SparseMatrix& H = solver.curvature();
    const Input r = Input::now("r", "residual", dof),
                slope = Input::constant("H", H.coeff(dof, dof), "N/m", "slope of the residual: inertia, drag and stiffness");
    if (l.x_.size() == 1) return part("d = − r / H", {r, slope});
    const Index other = 1 - dof;
    return part("d = − (r + H_o d_o) / H",
                {r, slope, Input::constant("H_o", H.coeff(dof, other), "N/m", "coupling to the other mass"),
                 Input::constant("d_o", solver.direction()[other], "m", "direction of the other mass")});
}

Explanation why_iterate(const IntegrationLesson& l, Index dof) {
    const ImplicitSolver& solver = l.integrator_->solver();
    const Input from = Input::earlier("X_k", "trial_position", dof);
    if (solver.residual() == 0) return {"X = X_k: nothing is left to balance", {from}};
    return stepping::newton_iterate("X", "X", solver, dof, from, newton_direction(l, dof), std::nullopt);
}

// V = h_v (X − x_v), as each scheme says.
Explanation why_iterate_velocity(const IntegrationLesson& l, Index dof) {
    const Input X = Input::now("X", "trial_position", dof), x = Input::before("x", "position", dof), step = Input::of(l.dt);
    if (l.scheme == Scheme::implicit_midpoint) return {"V = 2 (X − x) / Δt", {X, x, step}};
    if (l.scheme == Scheme::newmark) return {"V = 2 (X − x) / Δt − v", {X, x, step, Input::before("v", "velocity", dof)}};
    if (steps_back(l)) return {"V = (3 X − 4 x + x_b) / (2 Δt)", {X, x, before_start(l, false, dof), step}};
    return {"V = (X − x) / Δt", {X, x, step}};
}

// With the force of the end of the step, and what Newton's method has left unbalanced.
Explanation why_balanced_velocity(const IntegrationLesson& l, Index dof) {
    VecX left;
    l.integrator_->solver().imbalance(left);
    const Input v = Input::before("v", "velocity", dof), step = Input::of(l.dt);
    const Input f = Input::part("f′", "N", l.why_force(dof, "position", "velocity", Input::now, "′"));
    const Input r = stepping::imbalance_left(left[dof]);
    if (l.scheme == Scheme::newmark)
        return {"v′ = v + ½ Δt (f + f′ + r) / m", {v, step, Input::now("f", "force", dof), f, r, l.unit_mass()}};
    if (steps_back(l))
        return {"v′ = (4 v − v_b) / 3 + ⅔ Δt (f′ + r) / m", {v, before_start(l, true, dof), step, f, r, l.unit_mass()}};
    return {"v′ = v + Δt (f′ + r) / m", {v, step, f, r, l.unit_mass()}};
}

}  // namespace

// ------------------------------------------------------------------------------------------------------------- forces

// The force at the place and velocity that two fields hold.
Explanation IntegrationLesson::why_force(Index dof, std::string_view x_field, std::string_view v_field, Reading at,
                                         std::string_view mark) const {
    const std::string x = fmt::format("x{}", mark), v = fmt::format("v{}", mark);
    if (omega == 0) return fixed_value("f = 0: without ω there is no spring, and no drag");
    if (is(SwingingKind::oscillator))
        return {fmt::format("f = − m (ω² {} + 2 ζ ω {})", x, v),
                {unit_mass(), Input::of(omega), at(x, x_field, 0, 0), Input::of(zeta), at(v, v_field, 0, 0)}};
    if (is(SwingingKind::pendulum))
        return {fmt::format("f = − m (g sin({} / l) + 2 ζ ω {})", x, v),
                {unit_mass(), Input::constant("g", Swinging::gravity, "m/s²", "gravity"), at(x, x_field, 0, 0),
                 Input::constant("l", motion_->length(), "m", "length of the pendulum, g/ω²"), Input::of(zeta), Input::of(omega),
                 at(v, v_field, 0, 0)}};
    Explanation e{fmt::format("f_{0} = − (K_{0}1 {1} + K_{0}2 {2}) − (C_{0}1 {3} + C_{0}2 {4})", dof + 1, of_mass("x", 0, mark),
                              of_mass("x", 1, mark), of_mass("v", 0, mark), of_mass("v", 1, mark)),
                  {}};
    for (Index k = 0; k < 2; ++k) {
        e.inputs.push_back(Input::constant(fmt::format("K_{}{}", dof + 1, k + 1), motion_->stiffness_matrix()(dof, k), "N/m",
                                           "of the soft spring ω² and the stiff one κω²"));
        e.inputs.push_back(at(of_mass("x", k, mark), x_field, k, 0));
    }
    for (Index k = 0; k < 2; ++k) {
        e.inputs.push_back(Input::constant(fmt::format("C_{}{}", dof + 1, k + 1), motion_->damping_matrix()(dof, k), "N s/m",
                                           "2ζ times the root of K: each mode has the damping ratio ζ"));
        e.inputs.push_back(at(of_mass("v", k, mark), v_field, k, 0));
    }
    return e;
}

// ---------------------------------------------------------------------------------------------------- where passes begin

std::optional<Explanation> IntegrationLesson::why_predicted(const Question& q) const {
    if (q.field == "trial_velocity") {
        if (implicit()) return why_iterate_velocity(*this, q.index);
        return Explanation{"V = v", {Input::before("v", "velocity", q.index)}};
    }
    if (!implicit() || !integrator_->solver().began_at_prediction())
        return Explanation{"X = x", {Input::before("x", "position", q.index)}};
    Explanation e = why_prediction(*this, q.index);
    e.formula.replace(0, std::string("x̂").size(), "X");
    return e;
}

// ------------------------------------------------------------------------------------------------------------- passes

std::optional<Explanation> IntegrationLesson::why_pass(const Question& q) const {
    if (q.field == "pass_force") return why_force(q.index, "trial_position", "trial_velocity", Input::earlier, "_k");
    if (q.field == "residual") return why_residual(*this, q.index);
    const bool of_velocity = q.field == "trial_velocity";
    if (!implicit())
        return stepping::table_row(of_velocity ? "V" : "X", *integrator_, of_velocity, q.index,
                                   Input::before("x", "position", q.index), Input::before("v", "velocity", q.index), dt,
                                   std::nullopt);
    return of_velocity ? why_iterate_velocity(*this, q.index) : why_iterate(*this, q.index);
}

// ------------------------------------------------------------------------------------------------------------ the end

Explanation IntegrationLesson::why_advanced(const Question& q) const {
    const bool of_velocity = q.field == "velocity";
    const Input reached = of_velocity ? Input::now("V", "trial_velocity", q.index) : Input::now("X", "trial_position", q.index);
    if (scheme == Scheme::implicit_midpoint)
        return of_velocity ? Explanation{"v′ = 2 V − v", {reached, Input::before("v", "velocity", q.index)}}
                           : Explanation{"x′ = 2 X − x", {reached, Input::before("x", "position", q.index)}};
    if (implicit() && of_velocity) return why_balanced_velocity(*this, q.index);
    return {of_velocity ? "v′ = V" : "x′ = X", {reached}};
}

// ------------------------------------------------------------------------------------------------------------- energy

Explanation IntegrationLesson::why_energy() const {
    return {"E = K + U", {Input::now("K", "kinetic_energy", 0), Input::now("U", "potential_energy", 0)}};
}

Explanation IntegrationLesson::why_kinetic_energy() const {
    Explanation e{x_.size() == 2 ? "K = ½ m (v_1² + v_2²)" : "K = ½ m v_1²", {unit_mass()}};
    for (Index n = 0; n < x_.size(); ++n) e.inputs.push_back(Input::now(fmt::format("v_{}", n + 1), "velocity", n));
    return e;
}

// With the force of the springs alone.
Explanation IntegrationLesson::why_shadow_energy() const {
    Explanation e{"Ẽ = E + ½ Δt Σ_n v_n f_n, f = − K x", {Input::now("E", "energy", 0), Input::of(dt)}};
    for (Index n = 0; n < x_.size(); ++n) {
        std::vector<std::pair<Input, Input>> terms;
        for (Index m = 0; m < x_.size(); ++m)
            terms.emplace_back(Input::constant(fmt::format("K_{}", m + 1), motion_->stiffness_matrix()(n, m), "N/m", "stiffness"),
                               Input::now(fmt::format("x_{}", m + 1), "position", m));
        const std::string force = fmt::format("f_{}", n + 1);
        e.inputs.push_back(Input::now(fmt::format("v_{}", n + 1), "velocity", n).in("v_n"));
        e.inputs.push_back(Input::part(force, "N", weighted_sum(force + " = − Σ_m K_m x_m", "K_m", "x_m", terms)).in("f_n"));
    }
    return e;
}

Explanation IntegrationLesson::why_potential_energy() const {
    if (omega == 0) return fixed_value("U = 0: without ω there is no spring");
    if (is(SwingingKind::oscillator)) return {"U = ½ m ω² x²", {unit_mass(), Input::of(omega), Input::now("x", "position", 0)}};
    if (is(SwingingKind::pendulum))
        return {"U = m g l (1 − cos(x / l))",
                {unit_mass(), Input::constant("g", Swinging::gravity, "m/s²", "gravity"),
                 Input::constant("l", motion_->length(), "m", "length of the pendulum, g/ω²"), Input::now("x", "position", 0)}};
    return {"U = ½ m ω² x_1² + ½ m κ ω² (x_2 − x_1)²",
            {unit_mass(), omega, Input::now("x_1", "position", 0), ratio, Input::now("x_2", "position", 1)}};
}

// -------------------------------------------------------------------------------------------------- the exact motion

// Below critical damping, where it is short to write.
Explanation IntegrationLesson::why_exact(bool of_velocity) const {
    const char* symbol = of_velocity ? "v_e" : "x_e";
    if (!is(SwingingKind::oscillator) || zeta >= 1 || omega == 0)
        return Explanation{fmt::format("{} = {}(t), {}", symbol, of_velocity ? "v" : "x",
                                       is(SwingingKind::pendulum)     ? "by Jacobi's elliptic functions"
                                       : is(SwingingKind::stiff_pair) ? "the sum of two modes, each of them an oscillator"
                                       : omega == 0                   ? "a free motion, x₀ + v₀ t"
                                                    : "the sum of two decays, exp(−ω(ζ ± √(ζ² − 1)) t)"),
                           {Input::constant("t", time(), "s", "the time")}}
            .by(of_velocity ? "v" : "x", of_velocity ? "m/s" : "m", [this, of_velocity](Values t) {
                const auto at = motion_->exact(watched(), t[0]);
                return at ? (of_velocity ? at->v : at->x) : 0;
            });
    const Real turning = omega * std::sqrt((1 - zeta) * (1 + zeta));
    std::vector<Input> inputs{Input::of(zeta), Input::of(omega), Input::constant("t", time(), "s", "the time"),
                              Input::of(x0),   Input::of(v0),    Input::constant("ω_d", turning, "rad/s", "ω √(1 − ζ²)")};
    if (of_velocity) return {"v_e = exp(− ζ ω t) (v₀ cos(ω_d t) − (ω² x₀ + ζ ω v₀) sin(ω_d t) / ω_d)", std::move(inputs)};
    return {"x_e = exp(− ζ ω t) (x₀ cos(ω_d t) + (v₀ + ζ ω x₀) sin(ω_d t) / ω_d)", std::move(inputs)};
}

Explanation IntegrationLesson::why_error() const {
    if (is(SwingingKind::stiff_pair)) {
        Explanation e{"e = max_n √((x_n − xᵉ_n)² + ((v_n − vᵉ_n) / w)²) / s, of both masses",
                      {Input::constant("w", rate(), "rad/s", "ω"),
                       Input::constant("s", motion_->scale(), "m", "how far the start can swing")}};
        for (Index n = 0; n < x_.size(); ++n) {
            const auto exact = *motion_->exact(n, time());
            const auto number = [n](const char* symbol) { return fmt::format("{}_{}", symbol, n + 1); };
            e.inputs.push_back(Input::now(number("x"), "position", n).in("x_n"));
            e.inputs.push_back(Input::constant(number("xᵉ"), exact.x, "m", "by the two modes").in("xᵉ_n"));
            e.inputs.push_back(Input::now(number("v"), "velocity", n).in("v_n"));
            e.inputs.push_back(Input::constant(number("vᵉ"), exact.v, "m/s", "by the two modes").in("vᵉ_n"));
        }
        return e;
    }
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
    return Explanation{"ρ = eigenvalue(ω, ζ, Δt), the largest of the matrix that takes (x, Δt v) from one step to the next",
                       {w, zeta, step}}
        .by("eigenvalue", "", [scheme_now = Scheme(scheme)](Values x) { return amplification(scheme_now, x[0], x[1], x[2]); });
}

Explanation IntegrationLesson::why_frequency() const {
    if (zeta == 0 && (scheme == Scheme::semi_implicit_euler || scheme == Scheme::velocity_verlet))
        return {"ω′ = 2 asin(ω Δt / 2) / Δt", {Input::of(omega), Input::of(dt)}};
    return {"ω′ = φ / Δt",
            {Input::constant("φ", phase_per_step(scheme, omega, zeta, dt), "rad", "angle of the eigenvalue of the step's matrix"),
             Input::of(dt)}};
}

}  // namespace pliant::integration
