// Why forces, passes and the end of a step are what they are.
#include "integration.h"

#include <fmt/format.h>

#include <array>

namespace pliant::integration {
namespace {

std::string of_mass(std::string_view symbol, Index dof, std::string_view mark) {
    return fmt::format("{}_{}{}", symbol, dof + 1, mark);
}

}  // namespace

// ------------------------------------------------------------------------------------------------------------- forces

// The force at the place and velocity that two fields hold.
Explanation IntegrationLesson::why_force(Index dof, std::string_view x_field, std::string_view v_field, Reading at,
                                         std::string_view mark) const {
    const std::string x = fmt::format("x{}", mark), v = fmt::format("v{}", mark);
    if (omega == 0) return fixed_value("f = 0: without ω there is no spring, and no drag", 0);
    if (is(System::oscillator))
        return {fmt::format("f = − m (ω² {} + 2 ζ ω {})", x, v),
                {unit_mass(), Input::of(omega), at(x, x_field, 0, 0), Input::of(zeta), at(v, v_field, 0, 0)}};
    if (is(System::pendulum))
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
    if (q.field == "trial_velocity") return implicit() ? why_iterate_velocity(q.index) : start_value("V = v", "v", q.index);
    if (!implicit() || !integrator_->solver().began_at_prediction()) return start_value("X = x", "x", q.index);
    Explanation e = why_prediction(q.index);
    e.formula.replace(0, std::string("x̂").size(), "X");
    return e;
}

Explanation IntegrationLesson::start_value(std::string formula, std::string symbol, Index dof) const {
    const std::string_view field = symbol == "x" ? "position" : "velocity";
    return {std::move(formula), {Input::before(symbol, field, dof)}, [](std::span<const Real> x) { return x[0]; }};
}

Input IntegrationLesson::before_start(bool of_velocity, Index dof) const {
    const Index n = x_.size(), first = (inside(force_known) ? 0 : 2 * n) + (of_velocity ? n : 0);
    return Input::constant(of_velocity ? "v_b" : "x_b", before_[first + dof], of_velocity ? "m/s" : "m",
                           of_velocity ? "velocity one step before the start" : "place one step before the start");
}

bool IntegrationLesson::steps_back() const { return scheme == Scheme::bdf2 && counts_[0] > (inside(force_known) ? 0 : 1); }

// x̂: where the mass would be at the time that is solved for if no force acted from now on.
Explanation IntegrationLesson::why_prediction(Index dof) const {
    const Input x = Input::before("x", "position", dof), v = Input::before("v", "velocity", dof), step = Input::of(dt);
    if (scheme == Scheme::implicit_midpoint) return {"x̂ = x + ½ Δt v", {x, step, v}};
    if (scheme == Scheme::newmark)
        return {"x̂ = x + Δt v + ¼ Δt² f / m", {x, step, v, Input::now("f", "force", dof), unit_mass()}};
    if (steps_back())
        return {"x̂ = (4 x − x_b) / 3 + ⅔ Δt (4 v − v_b) / 3", {x, before_start(false, dof), step, v, before_start(true, dof)}};
    return {"x̂ = x + Δt v", {x, step, v}};
}

Input IntegrationLesson::unit_mass() const { return Input::constant("m", 1, "kg", "of each mass"); }

// ------------------------------------------------------------------------------------------------------------- passes

std::optional<Explanation> IntegrationLesson::why_pass(const Question& q) const {
    if (q.field == "pass_force") return why_force(q.index, "trial_position", "trial_velocity", Input::earlier, "_k");
    if (q.field == "residual") return why_residual(q.index);
    const bool of_velocity = q.field == "trial_velocity";
    if (!implicit()) return why_row(q.index, of_velocity);
    return of_velocity ? why_iterate_velocity(q.index) : why_iterate(q.index);
}

// A row of the scheme's table: X = x + c Δt v + Δt² Σ p_j a_j, V = v + Δt Σ q_j a_j.
Explanation IntegrationLesson::why_row(Index dof, bool of_velocity) const {
    const auto passes = static_cast<std::size_t>(integrator_->passes());
    const NystromRow& row = nystrom_table(scheme)[passes];
    const std::array<Real, 4>& weights = of_velocity ? row.velocity : row.position;
    const bool drifts = !of_velocity && row.c != 0;
    Explanation e{.formula = of_velocity ? "V = v" : "X = x", .inputs = {}, .evaluate = {}};
    e.inputs = {of_velocity ? Input::before("v", "velocity", dof) : Input::before("x", "position", dof), Input::of(dt)};
    if (drifts) {
        e.formula += " + c Δt v";
        e.inputs.push_back(Input::constant("c", row.c, "", "the part of the step after which this force is evaluated"));
        e.inputs.push_back(Input::before("v", "velocity", dof));
    }
    for (std::size_t j = 0; j < passes; ++j) {
        if (weights[j] == 0) continue;
        e.formula += fmt::format(" + {} w_{} a_{}", of_velocity ? "Δt" : "Δt²", j + 1, j + 1);
        e.inputs.push_back(Input::constant(fmt::format("w_{}", j + 1), weights[j], "", "weight, from the table of the scheme"));
        e.inputs.push_back(Input::constant(fmt::format("a_{}", j + 1), integrator_->acceleration(static_cast<Index>(j))[dof],
                                           "m/s²", fmt::format("acceleration f/m that pass {} evaluated", j + 1)));
    }
    e.evaluate = [of_velocity, drifts](std::span<const Real> q) {
        const Real step = of_velocity ? q[1] : q[1] * q[1];
        Real sum = q[0];
        if (drifts) sum += q[2] * q[1] * q[3];
        for (std::size_t k = drifts ? 4 : 2; k + 1 < q.size(); k += 2) sum += step * q[k] * q[k + 1];
        return sum;
    };
    return e;
}

// What the iterate before the pass left unbalanced: m a − f, where the scheme says a = h_a (X − x̂).
Explanation IntegrationLesson::why_residual(Index dof) const {
    const ImplicitForm& form = integrator_->solver().form();
    return {"r = m h_a (X_k − x̂) − f_k",
            {unit_mass(), Input::constant("h_a", form.acceleration_rate, "1/s²", "of the scheme: a = h_a (X − x̂)"),
             Input::earlier("X_k", "trial_position", dof), Input::part("x̂", "m", why_prediction(dof)),
             Input::part("f_k", "N", why_force(dof, "trial_position", "trial_velocity", Input::earlier, "_k"))}};
}

Explanation IntegrationLesson::why_iterate(Index dof) const {
    const ImplicitSolver& solver = integrator_->solver();
    const Input from = Input::earlier("X_k", "trial_position", dof);
    if (solver.residual() == 0) return {"X = X_k: nothing is left to balance", {from}};
    if (solver.searched())
        return {"X = X_s + s d",
                {Input::constant("X_s", solver.search_origin()[dof], "m", "the iterate where the search along a line started"),
                 Input::constant("s", solver.fraction(), "", "the part of the direction that lowers the potential"),
                 Input::constant("d", solver.search_direction()[dof], "m", "Newton's direction from there")},
                [](std::span<const Real> x) { return x[0] + x[1] * x[2]; }};
    return {"X = X_k + d", {from, newton_direction(dof)}};
}

// One row of H d = −r.
Input IntegrationLesson::newton_direction(Index dof) const {
    const ImplicitSolver& solver = integrator_->solver();
    const SparseMatrix& H = solver.curvature();
    Explanation e{"d = − r / H", {}, {}};
    e.inputs = {Input::now("r", "residual", dof),
                Input::constant("H", H.coeff(dof, dof), "N/m", "slope of the residual: inertia, drag and stiffness")};
    e.evaluate = [](std::span<const Real> x) { return -x[0] / x[1]; };
    if (x_.size() == 2) {
        const Index other = 1 - dof;
        e.formula = "d = − (r + H_o d_o) / H";
        e.inputs.push_back(Input::constant("H_o", H.coeff(dof, other), "N/m", "coupling to the other mass"));
        e.inputs.push_back(Input::constant("d_o", solver.direction()[other], "m", "direction of the other mass"));
        e.evaluate = [](std::span<const Real> x) { return -(x[0] + x[2] * x[3]) / x[1]; };
    }
    return Input::part("d", "m", std::move(e));
}

// V = h_v (X − x_v), as each scheme says.
Explanation IntegrationLesson::why_iterate_velocity(Index dof) const {
    const Input X = Input::now("X", "trial_position", dof), x = Input::before("x", "position", dof), step = Input::of(dt);
    if (scheme == Scheme::implicit_midpoint) return {"V = 2 (X − x) / Δt", {X, x, step}};
    if (scheme == Scheme::newmark) return {"V = 2 (X − x) / Δt − v", {X, x, step, Input::before("v", "velocity", dof)}};
    if (steps_back()) return {"V = (3 X − 4 x + x_b) / (2 Δt)", {X, x, before_start(false, dof), step}};
    return {"V = (X − x) / Δt", {X, x, step}};
}

// ------------------------------------------------------------------------------------------------------------ the end

Explanation IntegrationLesson::why_advanced(const Question& q) const {
    const bool of_velocity = q.field == "velocity";
    if (scheme == Scheme::implicit_midpoint) {
        const Input trial = of_velocity ? Input::now("V", "trial_velocity", q.index) : Input::now("X", "trial_position", q.index);
        const Input start = of_velocity ? Input::before("v", "velocity", q.index) : Input::before("x", "position", q.index);
        return {of_velocity ? "v′ = 2 V − v" : "x′ = 2 X − x", {trial, start}, [](std::span<const Real> x) {
                    return 2 * x[0] - x[1];
                }};
    }
    if (implicit() && of_velocity) return why_balanced_velocity(q.index);
    return {of_velocity ? "v′ = V" : "x′ = X",
            {of_velocity ? Input::now("V", "trial_velocity", q.index) : Input::now("X", "trial_position", q.index)},
            [](std::span<const Real> x) { return x[0]; }};
}

// With the force of the end of the step, and what Newton's method has left unbalanced.
Explanation IntegrationLesson::why_balanced_velocity(Index dof) const {
    VecX left;
    integrator_->solver().imbalance(left);
    const Input v = Input::before("v", "velocity", dof), step = Input::of(dt);
    const Input f = Input::part("f′", "N", why_force(dof, "position", "velocity", Input::now, "′"));
    const Input r = Input::constant("r", left[dof], "N", "what the solver has left unbalanced");
    if (scheme == Scheme::newmark)
        return {"v′ = v + ½ Δt (f + f′ + r) / m", {v, step, Input::now("f", "force", dof), f, r, unit_mass()}};
    if (steps_back()) return {"v′ = (4 v − v_b) / 3 + ⅔ Δt (f′ + r) / m", {v, before_start(true, dof), step, f, r, unit_mass()}};
    return {"v′ = v + Δt (f′ + r) / m", {v, step, f, r, unit_mass()}};
}

}  // namespace pliant::integration
