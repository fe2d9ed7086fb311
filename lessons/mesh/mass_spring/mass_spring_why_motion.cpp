// Why the nodes move as they do: the three integrators, and the ground.
#include "mass_spring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {
namespace {

constexpr int up = 1;

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
                .inputs = {Input::before("v", "velocity", q.index, q.component)},
                .evaluate = [](std::span<const Real> x) { return x[0]; }};
    }
    if (!implicit())
        return of_velocity ? why_explicit_velocity(q.index, q.component) : drifted(dt, q.index, q.component, semi_implicit());
    if (solver_->converged())
        return of_velocity ? why_balanced_velocity(q.index, q.component) : drifted(dt, q.index, q.component, true);
    if (!of_velocity) return why_newton_position(q.index, q.component);
    return {.formula = "v′ = (x′ − x) / Δt",
            .inputs = {Input::now("x′", "position", q.index, q.component), Input::before("x", "position", q.index, q.component),
                       Input::of(dt)},
            .evaluate = [](std::span<const Real> x) { return (x[0] - x[1]) / x[2]; }};
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
        add(Input::constant("R", solver_->reaction(dof), "N", "force of the ground, from the solver"));
    VecX imbalance;
    solver_->imbalance(imbalance);
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
    const ImplicitForm& form = solver_->form();
    const bool bounded = form.lower_bound.size() > 0 && std::isfinite(form.lower_bound[dof]);
    std::vector<Input> inputs;
    std::string step;
    if (solver_->searched()) {
        step = "x_s + s d";
        inputs = {Input::constant("x_s", solver_->search_origin()[dof], "m", "the iterate where the search along a line started"),
                  Input::constant("s", solver_->fraction(), "", "the fraction of the direction that lowers the potential"),
                  Input::constant("d", solver_->search_direction()[dof], "m", "Newton's direction from there")};
    } else {
        step = "x_k + d";
        inputs = {solver_->iterations() == 1 ? newton_start(node, component) : Input::earlier("x_k", "position", node, component),
                  newton_direction(dof)};
    }
    if (bounded) inputs.push_back(Input::constant("b", form.lower_bound[dof], "m", "the ground, or the node itself if below"));
    return {.formula = fmt::format("x′ = {}{}{}", bounded ? "max(" : "", step, bounded ? ", b)" : ""),
            .inputs = std::move(inputs),
            .evaluate = [bounded, searched = solver_->searched()](std::span<const Real> x) {
                const Real reached = searched ? x[0] + x[1] * x[2] : x[0] + x[1];
                return bounded ? std::max(reached, x.back()) : reached;
            }};
}

// Where Newton's method started in this step.
Input MassSpringLesson::newton_start(Index node, int component) const {
    const ImplicitForm& form = solver_->form();
    Explanation e{.formula = "x_k = x",
                  .inputs = {Input::before("x", "position", node, component)},
                  .evaluate = [](std::span<const Real> x) { return x[0]; }};
    if (solver_->began_at_prediction()) {
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
    const SparseMatrix& H = solver_->curvature();
    Explanation e{.formula = "d = (R − g − Σ H_ab d_b) / H_aa", .inputs = {}, .evaluate = {}};
    e.inputs = {Input::constant("R", solver_->reaction(dof), "N", "force of the ground"),
                Input::constant("g", solver_->gradient()[dof], "N", "what the iterate before left unbalanced"),
                Input::constant("H_aa", H.coeff(dof, dof), "N/m", "stiffness, damping and inertia of the node")};
    for (SparseMatrix::InnerIterator entry(H, dof); entry; ++entry) {
        if (entry.row() == dof || entry.value() == 0) continue;
        e.inputs.push_back(Input::constant("H_ab", entry.value(), "N/m", "coupling to a neighbour"));
        e.inputs.push_back(
            Input::constant("d_b", solver_->direction()[entry.row()], "m",
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

// ------------------------------------------------------------------------------------------------------------ contact

// Nothing, where the stage has left the number as it was.
std::optional<Explanation> MassSpringLesson::why_contact(const Question& q) const {
    const Touch touch = touches_[static_cast<std::size_t>(q.index)];
    if (touch == Touch::none) return std::nullopt;
    if (q.field == "velocity") return q.component == up ? why_rebound(q.index) : why_rubbed_velocity(q.index, q.component);
    if (q.component == up) {
        if (touch != Touch::below) return std::nullopt;
        return Explanation{.formula = "y′ = max(y, 0)",
                           .inputs = {Input::before("y", "position", q.index, up)},
                           .evaluate = [](std::span<const Real> x) { return std::max(x[0], Real{0}); }};
    }
    if (!semi_implicit()) return std::nullopt;
    return Explanation{
        .formula = "x′ = x + Δt (v′ − v)",
        .inputs = {Input::before("x", "position", q.index, q.component), Input::of(dt),
                   Input::now("v′", "velocity", q.index, q.component), Input::before("v", "velocity", q.index, q.component)},
        .evaluate = [](std::span<const Real> x) { return x[0] + x[1] * (x[2] - x[3]); }};
}

Explanation MassSpringLesson::why_rebound(Index node) const {
    return {.formula = "v_y′ = max(v_y, 0) + e w",
            .inputs = {Input::before("v_y", "velocity", node, up), Input::of(restitution), impact_speed(node)},
            .evaluate = [](std::span<const Real> x) { return std::max(x[0], Real{0}) + x[1] * x[2]; }};
}

// Coulomb's friction: it takes a part of the speed along the ground, or all of it.
Explanation MassSpringLesson::why_rubbed_velocity(Index node, int component) const {
    Explanation along{.formula = "|v_t| = √(v_x² + v_z²)",
                      .inputs = {Input::before("v_x", "velocity", node, 0), Input::before("v_z", "velocity", node, 2)},
                      .evaluate = [](std::span<const Real> x) { return std::hypot(x[0], x[1]); }};
    return {.formula = "v′ = v (1 − min(1, μ (1 + e) w / |v_t|))",
            .inputs = {Input::before("v", "velocity", node, component), Input::of(friction), Input::of(restitution),
                       impact_speed(node), Input::part("|v_t|", "m/s", std::move(along))},
            .evaluate = [](std::span<const Real> x) {
                const Real taken = x[4] > 0 ? std::min(Real{1}, x[1] * (1 + x[2]) * x[3] / x[4]) : 1;
                return x[0] * (1 - taken);
            }};
}

// The speed with which a node met the ground: that with which it went below, and what held it there has already taken.
Input MassSpringLesson::impact_speed(Index node) const {
    const bool below = touches_[static_cast<std::size_t>(node)] == Touch::below;
    std::string formula = below ? "w = max(− v_y, 0)" : "w = ";
    std::vector<Input> inputs;
    if (below) inputs.push_back(Input::before("v_y", "velocity", node, up));
    if (implicit()) {
        formula += below ? " + Δt R / m" : "Δt R / m";
        inputs.push_back(Input::of(dt));
        inputs.push_back(Input::constant("R", solver_->reaction(3 * node + up), "N", "force of the ground, from the solver"));
        inputs.push_back(node_mass());
    }
    return Input::part("w", "m/s",
                       {.formula = std::move(formula), .inputs = std::move(inputs), .evaluate = [below](std::span<const Real> x) {
                            const Real down = below ? std::max(-x[0], Real{0}) : Real{0};
                            const std::span<const Real> held = x.subspan(below ? 1 : 0);
                            return held.empty() ? down : down + held[0] * held[1] / held[2];
                        }});
}

}  // namespace pliant::mass_spring
