// Why the nodes move as they do: three integrators.
#include "cloth.h"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::cloth {
namespace {

Explanation drifted(const Parameter& dt, Index node, int component, bool with_new_velocity) {
    return {.formula = with_new_velocity ? "x′ = x + Δt v′" : "x′ = x + Δt v",
            .inputs = {Input::before("x", "position", node, component), Input::of(dt),
                       with_new_velocity ? Input::now("v′", "velocity", node, component)
                                         : Input::before("v", "velocity", node, component)},
            .evaluate = [](std::span<const Real> x) { return x[0] + x[1] * x[2]; }};
}

// v + Δt Σ f / m, of inputs v, Δt, m, f, ...
Real accelerated(std::span<const Real> x) {
    Real force = 0;
    for (const Real f : x.subspan(3)) force += f;
    return x[0] + x[1] * force / x[2];
}

Explanation pushed(std::vector<Input> inputs) {
    std::string forces;
    for (std::size_t k = 3; k < inputs.size(); ++k) forces += (k > 3 ? " + " : "") + inputs[k].symbol;
    if (inputs.size() > 4) forces = fmt::format("({})", forces);
    return {.formula = fmt::format("v′ = v + Δt {} / m", forces), .inputs = std::move(inputs), .evaluate = accelerated};
}

}  // namespace

Explanation ClothLesson::why_integrated(const Question& q) const {
    const bool of_velocity = q.field == "velocity";
    if (sheet_->inertia().fixed(3 * q.index)) {
        if (!of_velocity) return drifted(dt, q.index, q.component, false);
        return {.formula = "v′ = v: the node is held", .inputs = {Input::before("v", "velocity", q.index, q.component)}};
    }
    if (!implicit())
        return of_velocity ? why_explicit_velocity(q.index, q.component)
                           : drifted(dt, q.index, q.component, scheme == Scheme::semi_implicit_euler);
    if (!solver()->again())
        return of_velocity ? why_balanced_velocity(q.index, q.component) : drifted(dt, q.index, q.component, true);
    if (!of_velocity) return why_newton_position(q.index, q.component);
    return {.formula = "v′ = (x′ − x) / Δt",
            .inputs = {Input::now("x′", "position", q.index, q.component), Input::before("x", "position", q.index, q.component),
                       Input::of(dt)}};
}

// With the forces of the start of the step.
Explanation ClothLesson::why_explicit_velocity(Index node, int component) const {
    std::vector<Input> inputs{Input::before("v", "velocity", node, component), Input::of(dt), node_mass(),
                              Input::now("f", "spring_force", node, component)};
    if (damped()) inputs.push_back(Input::now("fᵈ", "damping_force", node, component));
    if (loaded()) inputs.push_back(Input::now("fᵉ", "external_force", node, component));
    if (in_air()) inputs.push_back(Input::now("fʷ", "wind_force", node, component));
    return pushed(std::move(inputs));
}

// With the forces of the end of the step, and what the solver has left unbalanced: much of it, after one Newton iteration.
Explanation ClothLesson::why_balanced_velocity(Index node, int component) const {
    std::vector<Input> inputs{Input::before("v", "velocity", node, component), Input::of(dt), node_mass(),
                              Input::part("f(x′)", "N", why_spring_force(node, component))};
    if (damped()) inputs.push_back(Input::part("fᵈ(v′)", "N", why_damping_force(node, component, Input::before)));
    if (loaded()) inputs.push_back(Input::part("fᵉ(x′)", "N", why_external_force(node, component)));
    if (in_air()) inputs.push_back(Input::part("fʷ(v′)", "N", why_wind_force(node, component)));
    if (const NodePlane<3>* plane = plane_of(node)) {
        inputs.push_back(Input::part("fⁿ(x′)", "N", why_plane_force(*plane, component)));
        inputs.push_back(Input::part("fᵗ(v′)", "N", why_friction(*plane, component)));
    }
    inputs.push_back(Input::constant("r", imbalance_[3 * node + component], "N", "what the solver has left unbalanced"));
    return pushed(std::move(inputs));
}

// One Newton iteration: the iterate before it, and the direction.
Explanation ClothLesson::why_newton_position(Index node, int component) const {
    const Index dof = 3 * node + component;
    if (solver()->searched())
        return {
            .formula = "x′ = x_s + s d",
            .inputs = {Input::constant("x_s", solver()->search_origin()[dof], "m",
                                       "the iterate where the search along a line started"),
                       Input::constant("s", solver()->fraction(), "", "the fraction of the direction that lowers the potential"),
                       Input::constant("d", solver()->search_direction()[dof], "m", "Newton's direction from there")},
            .evaluate = [](std::span<const Real> x) { return x[0] + x[1] * x[2]; }};
    return {.formula = "x′ = x_k + d",
            .inputs = {
                solver()->iterations() == 1 ? newton_start(node, component) : Input::earlier("x_k", "position", node, component),
                newton_direction(dof)}};
}

// Where Newton's method started in this step.
Input ClothLesson::newton_start(Index node, int component) const {
    if (!solver()->began_at_prediction())
        return Input::part("x_k", "m", {.formula = "x_k = x", .inputs = {Input::before("x", "position", node, component)}});
    Explanation e = drifted(dt, node, component, false);
    e.formula = "x_k = x + Δt v";
    return Input::part("x_k", "m", std::move(e));
}

// One row of H d = − g − r.
Input ClothLesson::newton_direction(Index dof) const {
    Explanation e{.formula = "d = (− g − r − Σ H_ab d_b) / H_aa", .inputs = {}, .evaluate = {}};
    Real diagonal = 0;
    std::vector<std::pair<Index, Real>> row;
    if (iterative()) {
        diagonal = system_->tangent().diagonal(dof);
        row = system_->tangent().row(dof);
    } else {
        const SparseMatrix& H = solver()->curvature();
        diagonal = H.coeff(dof, dof);
        for (SparseMatrix::InnerIterator entry(H, dof); entry; ++entry)
            if (entry.row() != dof) row.emplace_back(entry.row(), entry.value());
    }
    e.inputs = {Input::constant("g", solver()->gradient()[dof], "N", "what the iterate before left unbalanced"),
                Input::constant("r", solver()->linear_residual(dof), "N", "what conjugate gradients have left of this row"),
                Input::constant("H_aa", diagonal, "N/m", "stiffness, damping and inertia of the node")};
    for (const auto& [b, value] : row) {
        if (value == 0) continue;
        e.inputs.push_back(Input::constant("H_ab", value, "N/m", "coupling to a neighbour"));
        e.inputs.push_back(Input::constant("d_b", solver()->direction()[b], "m",
                                           fmt::format("the neighbour's direction, {} of node {}", "xyz"[b % 3], b / 3)));
    }
    e.evaluate = [](std::span<const Real> x) {
        Real sum = -x[0] - x[1];
        for (std::size_t k = 3; k + 1 < x.size(); k += 2) sum -= x[k] * x[k + 1];
        return sum / x[2];
    };
    e.substitute = [](std::span<const Real> x) {
        return fmt::format("({} − ({})) / {}", sum_text(std::array{-x[0], -x[1]}), products_text(x.subspan(3)),
                           sum_text(x.subspan(2, 1)));
    };
    return Input::part("d", "m", std::move(e));
}

}  // namespace pliant::cloth
