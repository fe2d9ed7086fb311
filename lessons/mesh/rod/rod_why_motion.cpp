// Why the nodes move as they do: one row of an explicit scheme's table, or the equations of an implicit one.
#include "rod.h"

#include <fmt/format.h>

namespace pliant::rod {
namespace {

using Values = std::span<const Real>;

}  // namespace

std::optional<Explanation> RodLesson::why_integrated(const Question& q) const {
    const bool of_velocity = q.field == "velocity";
    if (inertia_.fixed(2 * q.index))
        return Explanation{of_velocity ? "v′ = v: the support holds the node" : "x′ = x: the support holds the node",
                           {Input::before(of_velocity ? "v" : "x", q.field, q.index, q.component)},
                           [](Values x) { return x[0]; }};
    if (!is_implicit(scheme)) return why_row(q.index, q.component, of_velocity);
    // The iterates stay with the solver; what it found is written at the end.
    if (integrator_->again()) return std::nullopt;
    return of_velocity ? why_solved_velocity(q.index, q.component) : why_solved_position(q.index, q.component);
}

// ------------------------------------------------------------------------------------------------------------- explicit

// M⁻¹f of a pass: of the first, from the forces of the stages before.
Input RodLesson::why_acceleration(Index pass, Index node, int component) const {
    const std::string symbol = fmt::format("a_{}", pass + 1);
    if (pass > 0)
        return Input::constant(symbol, integrator_->acceleration(pass)[2 * node + component], "m/s²",
                               fmt::format("f/m where pass {} of the scheme evaluates it", pass + 1));
    Explanation e{"", {why_node_mass(), Input::now("f", "spring_force", node, component)}, [](Values x) {
                      Real force = 0;
                      for (const Real f : x.subspan(1)) force += f;
                      return force / x[0];
                  }};
    std::string forces = "f";
    const auto add = [&](std::string_view name, std::string_view field) {
        e.inputs.push_back(Input::now(std::string(name), field, node, component));
        forces += fmt::format(" + {}", name);
    };
    if (damped()) add("fᵈ", "damping_force");
    if (loaded()) add("fᵉ", "external_force");
    e.formula = e.inputs.size() == 2 ? fmt::format("{} = f / m", symbol) : fmt::format("{} = ({}) / m", symbol, forces);
    return Input::part(symbol, "m/s²", std::move(e));
}

// x + c Δt v + Δt² Σ b a or v + Δt Σ b a: where the next force is evaluated, or the end of the step.
Explanation RodLesson::why_row(Index node, int component, bool of_velocity) const {
    const Index done = integrator_->passes();
    const NystromRow& row = nystrom_table(scheme)[static_cast<std::size_t>(done)];
    Explanation e{"", {}, {}};
    if (of_velocity) {
        e.inputs = {Input::before("v", "velocity", node, component), Input::of(dt)};
        e.formula = "v′ = v";
    } else {
        e.inputs = {Input::before("x", "position", node, component), Input::of(dt),
                    Input::constant("c", row.c, "", "part of the step, from the table of the scheme"),
                    Input::before("v", "velocity", node, component)};
        e.formula = "x′ = x + c Δt v";
    }
    const std::size_t head = e.inputs.size();
    const auto& weights = of_velocity ? row.velocity : row.position;
    for (Index j = 0; j < done; ++j) {
        const Real weight = weights[static_cast<std::size_t>(j)];
        if (weight == 0) continue;
        e.formula += fmt::format(" + b_{0} Δt{1} a_{0}", j + 1, of_velocity ? "" : "²");
        e.inputs.push_back(Input::constant(fmt::format("b_{}", j + 1), weight, "", "weight, from the table of the scheme"));
        e.inputs.push_back(why_acceleration(j, node, component));
    }
    e.evaluate = [of_velocity, head](Values x) {
        Real sum = 0;
        for (std::size_t k = head; k + 1 < x.size(); k += 2) sum += x[k] * x[k + 1];
        return of_velocity ? x[0] + x[1] * sum : x[0] + x[2] * x[1] * x[3] + x[1] * x[1] * sum;
    };
    return e;
}

// ------------------------------------------------------------------------------------------------------------- implicit

// The place that the scheme solves for: that of the end, or of the middle of the step.
Explanation RodLesson::why_solution(Index node, int component) const {
    const Index dof = 2 * node + component;
    ImplicitSolver& solver = integrator_->solver();
    VecX force(position_.size()), imbalance;
    solver.imbalance(imbalance);
    system_->force(solver.position(), solver.velocity(), force);
    return {"z = o + (F + r) / (m ρ²)",
            {Input::constant("o", solver.form().acceleration_origin[dof], "m", "where the node would be without forces"),
             Input::constant("F", force[dof], "N", "force of springs, dampers and weight there"),
             Input::constant("r", imbalance[dof], "N", "what the solver has left unbalanced"), why_node_mass(),
             Input::constant("ρ²", solver.form().acceleration_rate, "1/s²", "of the scheme: 1/Δt² for implicit Euler")}};
}

Explanation RodLesson::why_solved_position(Index node, int component) const {
    Explanation solution = why_solution(node, component);
    if (scheme != Scheme::implicit_midpoint) {
        solution.formula = "x′ = o + (F + r) / (m ρ²)";
        return solution;
    }
    return {"x′ = 2 z − x", {Input::part("z", "m", std::move(solution)), Input::before("x", "position", node, component)}};
}

Explanation RodLesson::why_solved_velocity(Index node, int component) const {
    const ImplicitForm& form = integrator_->solver().form();
    const Input rate = Input::constant("ρ", form.velocity_rate, "1/s", "of the scheme: 1/Δt for implicit Euler");
    const Input origin =
        Input::constant("o", form.velocity_origin[2 * node + component], "m", "of the scheme: x for implicit Euler");
    if (scheme != Scheme::implicit_midpoint)
        return {"v′ = ρ (x′ − o)", {rate, Input::now("x′", "position", node, component), origin}};
    Explanation middle{"v_m = ρ (z − o)", {rate, Input::part("z", "m", why_solution(node, component)), origin}};
    return {"v′ = 2 v_m − v", {Input::part("v_m", "m/s", std::move(middle)), Input::before("v", "velocity", node, component)}};
}

}  // namespace pliant::rod
