// Why the nodes move as they do: the integrators.
#include "mass_spring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {
namespace {

Explanation drifted(const Parameter& dt, Index node, int component, bool with_new_velocity) {
    return {.formula = with_new_velocity ? "x′ = x + Δt v′" : "x′ = x + Δt v",
            .inputs = {Input::before("x", "position", node, component), Input::of(dt),
                       with_new_velocity ? Input::now("v′", "velocity", node, component)
                                         : Input::before("v", "velocity", node, component)},
            .evaluate = [](std::span<const Real> x) { return x[0] + x[1] * x[2]; }};
}

}  // namespace

// ------------------------------------------------------------------------------------------------------- integration

Explanation MassSpringLesson::why_integrated(const Question& q) const {
    const bool of_velocity = q.field == "velocity";
    if (block_->inertia().fixed(3 * q.index)) {
        if (!of_velocity) return drifted(dt, q.index, q.component, false);
        return {.formula = "v′ = v: the support holds the node",
                .inputs = {Input::before("v", "velocity", q.index, q.component)}};
    }
    if (semi_implicit() || integrator == Scheme::explicit_euler)
        return of_velocity ? why_explicit_velocity(q.index, q.component) : drifted(dt, q.index, q.component, semi_implicit());
    if (!implicit()) return why_table_row(q);
    if (!integrator_->solver().converged())
        return of_velocity ? why_iterate_velocity(q.index, q.component) : why_newton_position(q.index, q.component);
    if (!implicit_euler()) return why_second_order(q);
    return of_velocity ? why_balanced_velocity(q.index, q.component) : drifted(dt, q.index, q.component, true);
}

// The row of the scheme's table that the latest pass has filled in: the next place to evaluate forces at, or the end of the step.
Explanation MassSpringLesson::why_table_row(const Question& q) const {
    const Index dof = 3 * q.index + q.component;
    const bool of_velocity = q.field == "velocity";
    const auto passes = static_cast<std::size_t>(integrator_->passes());
    const NystromRow& row = nystrom_table(integrator)[passes];
    Explanation e;
    if (of_velocity) {
        e.inputs = {Input::before("v", "velocity", q.index, q.component), Input::of(dt)};
    } else {
        e.inputs = {Input::before("x", "position", q.index, q.component), Input::of(dt),
                    Input::before("v", "velocity", q.index, q.component),
                    Input::constant("c", row.c, "", "the part of the step")};
    }
    std::string sum;
    for (std::size_t j = 0; j < passes; ++j) {
        const Real weight = of_velocity ? row.velocity[j] : row.position[j];
        if (weight == 0) continue;
        sum += fmt::format("{}b_{} a_{}", sum.empty() ? "" : " + ", j + 1, j + 1);
        e.inputs.push_back(Input::constant(fmt::format("b_{}", j + 1), weight, "", "from the table of the scheme"));
        if (j == 0)
            e.inputs.push_back(Input::part("a_1", "m/s²", why_acceleration(q.index, q.component)));
        else
            e.inputs.push_back(Input::constant(fmt::format("a_{}", j + 1), integrator_->acceleration(static_cast<Index>(j))[dof],
                                               "m/s²",
                                               fmt::format("f/m where pass {} of this step has evaluated the forces", j + 1)));
    }
    e.formula = of_velocity ? "v′ = v" : "x′ = x + c Δt v";
    if (!sum.empty()) e.formula += fmt::format(" + {} ({})", of_velocity ? "Δt" : "Δt²", sum);
    e.evaluate = [of_velocity](std::span<const Real> x) {
        Real sum_now = 0;
        for (std::size_t k = of_velocity ? 2 : 4; k + 1 < x.size(); k += 2) sum_now += x[k] * x[k + 1];
        return of_velocity ? x[0] + x[1] * sum_now : x[0] + x[3] * x[1] * x[2] + x[1] * x[1] * sum_now;
    };
    return e;
}

// Of the start of the step.
Explanation MassSpringLesson::why_acceleration(Index node, int component) const {
    Explanation e{
        .formula = "a = f / m", .inputs = {node_mass(), Input::now("f", "spring_force", node, component)}, .evaluate = {}};
    std::string forces = "f";
    if (damped()) e.inputs.push_back(Input::now("fᵈ", "damping_force", node, component)), forces += " + fᵈ";
    if (loaded()) e.inputs.push_back(Input::now("fᵉ", "external_force", node, component)), forces += " + fᵉ";
    if (damped() || loaded()) e.formula = fmt::format("a = ({}) / m", forces);
    e.evaluate = [](std::span<const Real> x) {
        Real force = 0;
        for (const Real f : x.subspan(1)) force += f;
        return force / x[0];
    };
    return e;
}

// The end of a step of Newmark's scheme, of the midpoint rule or of BDF2, from the acceleration that Newton's method has found.
Explanation MassSpringLesson::why_second_order(const Question& q) const {
    const Index dof = 3 * q.index + q.component;
    const ImplicitForm& form = integrator_->solver().form();
    const Real found = form.acceleration_rate * (integrator_->solver().position()[dof] - form.acceleration_origin[dof]);
    const Input x = Input::before("x", "position", q.index, q.component),
                v = Input::before("v", "velocity", q.index, q.component),
                x_new = Input::now("x′", "position", q.index, q.component);
    const auto acceleration = [found](std::string symbol, std::string where) {
        return Input::constant(std::move(symbol), found, "m/s²", "(f + R)/m " + where + ", from Newton's method");
    };
    if (integrator == Scheme::bdf2) {
        const Input h = Input::constant("h", 1 / form.velocity_rate, "s", "Δt (1 + r)/(1 + 2r), r = Δt over the step before"),
                    x_o = Input::constant("x_o", form.velocity_origin[dof], "m", "((1 + r)² x − r² x of before)/(1 + 2r)");
        if (q.field == "velocity")
            return {.formula = "v′ = (x′ − x_o) / h", .inputs = {x_new, x_o, h}, .evaluate = [](std::span<const Real> n) {
                        return (n[0] - n[1]) / n[2];
                    }};
        const Real moved = form.acceleration_origin[dof] - form.velocity_origin[dof];
        return {.formula = "x′ = x_o + d_o + h² a′",
                .inputs = {x_o, Input::constant("d_o", moved, "m", "h ((1 + r)² v − r² v of before)/(1 + 2r)"), h,
                           acceleration("a′", "at the end of the step")},
                .evaluate = [](std::span<const Real> n) { return n[0] + n[1] + n[2] * n[2] * n[3]; }};
    }
    if (q.field == "velocity")
        return {.formula = "v′ = 2 (x′ − x) / Δt − v",
                .inputs = {x_new, x, Input::of(dt), v},
                .evaluate = [](std::span<const Real> n) { return 2 * (n[0] - n[1]) / n[2] - n[3]; }};
    if (integrator == Scheme::implicit_midpoint)
        return {.formula = "x′ = x + Δt v + ½ Δt² a_m",
                .inputs = {x, Input::of(dt), v, acceleration("a_m", "in the middle of the step")},
                .evaluate = [](std::span<const Real> n) { return n[0] + n[1] * n[2] + 0.5 * n[1] * n[1] * n[3]; }};
    return {.formula = "x′ = x + Δt v + ¼ Δt² (a + a′)",
            .inputs = {x, Input::of(dt), v,
                       Input::constant("a", integrator_->acceleration(0)[dof], "m/s²", "f/m at the start of the step"),
                       acceleration("a′", "at the end of the step")},
            .evaluate = [](std::span<const Real> n) { return n[0] + n[1] * n[2] + 0.25 * n[1] * n[1] * (n[3] + n[4]); }};
}

// Of an iterate of Newton's method: the velocity that the scheme gives to a place.
Explanation MassSpringLesson::why_iterate_velocity(Index node, int component) const {
    const ImplicitForm& form = integrator_->solver().form();
    if (implicit_euler())
        return {.formula = "v′ = (x′ − x) / Δt",
                .inputs = {Input::now("x′", "position", node, component), Input::before("x", "position", node, component),
                           Input::of(dt)}};
    return {.formula = "v′ = r (x′ − x_o)",
            .inputs = {Input::constant("r", form.velocity_rate, "1/s", "of the scheme"),
                       Input::now("x′", "position", node, component),
                       Input::constant("x_o", form.velocity_origin[3 * node + component], "m",
                                       "the place at which the scheme's velocity is 0")}};
}

// With the forces of the start of the step.
Explanation MassSpringLesson::why_explicit_velocity(Index node, int component) const {
    std::vector<Input> inputs{Input::before("v", "velocity", node, component), Input::of(dt), node_mass(),
                              Input::now("f", "spring_force", node, component)};
    std::string forces = "f";
    if (damped()) inputs.push_back(Input::now("fᵈ", "damping_force", node, component)), forces += " + fᵈ";
    if (loaded()) inputs.push_back(Input::now("fᵉ", "external_force", node, component)), forces += " + fᵉ";
    if (damped() || loaded()) forces = fmt::format("({})", forces);
    return {.formula = fmt::format("v′ = v + Δt {} / m", forces),
            .inputs = std::move(inputs),
            .evaluate = [](std::span<const Real> x) {
                Real force = 0;
                for (const Real f : x.subspan(3)) force += f;
                return x[0] + x[1] * force / x[2];
            }};
}

// With the forces of the end of the step, the ground's, and what Newton's method has left unbalanced.
Explanation MassSpringLesson::why_balanced_velocity(Index node, int component) const {
    const Index dof = 3 * node + component;
    std::vector<Input> inputs{Input::before("v", "velocity", node, component), Input::of(dt), node_mass(),
                              Input::part("f(x′)", "N", why_spring_force(node, component))};
    std::string forces = "f(x′)";
    const auto add = [&](Input input) {
        forces += " + " + input.symbol;
        inputs.push_back(std::move(input));
    };
    if (damped()) add(Input::part("fᵈ(v′)", "N", why_damping_force(node, component, Input::before)));
    if (loaded()) add(Input::part("fᵉ(x′)", "N", why_external_force(node, component)));
    if (grounded() && component == up)
        add(Input::constant("R", integrator_->solver().reaction(dof), "N", "force of the ground, from the solver"));
    VecX imbalance;
    integrator_->solver().imbalance(imbalance);
    add(Input::constant("r", imbalance[dof], "N", "what the solver has left unbalanced"));
    return {.formula = fmt::format("v′ = v + Δt ({}) / m", forces),
            .inputs = std::move(inputs),
            .evaluate = [](std::span<const Real> x) {
                Real force = 0;
                for (const Real f : x.subspan(3)) force += f;
                return x[0] + x[1] * force / x[2];
            }};
}

// One Newton iteration: the iterate before it, and the direction.
Explanation MassSpringLesson::why_newton_position(Index node, int component) const {
    const Index dof = 3 * node + component;
    const ImplicitForm& form = integrator_->solver().form();
    const bool bounded = form.lower_bound.size() > 0 && std::isfinite(form.lower_bound[dof]);
    std::vector<Input> inputs;
    std::string step;
    if (integrator_->solver().searched()) {
        step = "x_s + s d";
        inputs = {
            Input::constant("x_s", integrator_->solver().search_origin()[dof], "m",
                            "the iterate where the search along a line started"),
            Input::constant("s", integrator_->solver().fraction(), "", "the fraction of the direction that lowers the potential"),
            Input::constant("d", integrator_->solver().search_direction()[dof], "m", "Newton's direction from there")};
    } else {
        step = "x_k + d";
        inputs = {integrator_->solver().iterations() == 1 ? newton_start(node, component)
                                                          : Input::earlier("x_k", "position", node, component),
                  newton_direction(dof)};
    }
    if (bounded) inputs.push_back(Input::constant("b", form.lower_bound[dof], "m", "the ground, or the node itself if below"));
    return {.formula = fmt::format("x′ = {}{}{}", bounded ? "max(" : "", step, bounded ? ", b)" : ""),
            .inputs = std::move(inputs),
            .evaluate = [bounded, searched = integrator_->solver().searched()](std::span<const Real> x) {
                const Real reached = searched ? x[0] + x[1] * x[2] : x[0] + x[1];
                return bounded ? std::max(reached, x.back()) : reached;
            }};
}

// Where Newton's method started in this step.
Input MassSpringLesson::newton_start(Index node, int component) const {
    const ImplicitForm& form = integrator_->solver().form();
    Explanation e{.formula = "x_k = x", .inputs = {Input::before("x", "position", node, component)}};
    if (!implicit_euler()) {
        ImplicitSolver& solver = integrator_->solver();
        const Index dof = 3 * node + component;
        Real start = solver.began_at_prediction() ? solver.form().acceleration_origin[dof] : contact_.start().data()[dof];
        if (form.lower_bound.size() > 0) start = std::max(start, form.lower_bound[dof]);
        return Input::constant("x_k", start, "m", "where Newton's method begins: as if no force changed, or where the node is");
    }
    if (integrator_->solver().began_at_prediction()) {
        e = drifted(dt, node, component, false);
        e.formula = "x_k = x + Δt v";
        const Index dof = 3 * node + component;
        if (form.lower_bound.size() > 0 && std::isfinite(form.lower_bound[dof])) {
            e.formula = "x_k = max(x + Δt v, b)";
            e.inputs.push_back(Input::constant("b", form.lower_bound[dof], "m", "the ground, or the node itself if below"));
            e.evaluate = [](std::span<const Real> x) { return std::max(x[0] + x[1] * x[2], x[3]); };
        }
    }
    return Input::part("x_k", "m", std::move(e));
}

// One row of H d = R − g.
Input MassSpringLesson::newton_direction(Index dof) const {
    const SparseMatrix& H = integrator_->solver().curvature();
    Explanation e{.formula = "d = (R − g − Σ H_ab d_b) / H_aa", .inputs = {}, .evaluate = {}};
    e.inputs = {Input::constant("R", integrator_->solver().reaction(dof), "N", "force of the ground"),
                Input::constant("g", integrator_->solver().gradient()[dof], "N", "what the iterate before left unbalanced"),
                Input::constant("H_aa", H.coeff(dof, dof), "N/m", "stiffness, damping and inertia of the node")};
    for (SparseMatrix::InnerIterator entry(H, dof); entry; ++entry) {
        if (entry.row() == dof || entry.value() == 0) continue;
        e.inputs.push_back(Input::constant("H_ab", entry.value(), "N/m", "coupling to a neighbour"));
        e.inputs.push_back(
            Input::constant("d_b", integrator_->solver().direction()[entry.row()], "m",
                            fmt::format("the neighbour's direction, {} of node {}", "xyz"[entry.row() % 3], entry.row() / 3)));
    }
    e.evaluate = [](std::span<const Real> x) {
        Real sum = x[0] - x[1];
        for (std::size_t k = 3; k + 1 < x.size(); k += 2) sum -= x[k] * x[k + 1];
        return sum / x[2];
    };
    e.substitute = [](std::span<const Real> x) {
        return fmt::format("({} − ({})) / {}", sum_text(std::array{x[0], -x[1]}), products_text(x.subspan(3)),
                           sum_text(x.subspan(2, 1)));
    };
    return Input::part("d", "m", std::move(e));
}

}  // namespace pliant::mass_spring
