#include "kits/schemes/scheme_why.h"

#include <pliant/time/scheme.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant::stepping {
namespace {

// "f", or "(f + fᵈ + fᵉ)".
std::string sum_of_symbols(const std::vector<Input>& terms) {
    std::string sum;
    for (const Input& term : terms) sum += (sum.empty() ? "" : " + ") + term.symbol;
    return terms.size() > 1 ? fmt::format("({})", sum) : sum;
}

std::vector<Input> joined(std::vector<Input> head, std::vector<Input> tail) {
    for (Input& input : tail) head.push_back(std::move(input));
    return head;
}

}  // namespace

Explanation drifted(const Parameter& dt, Index node, int component, bool with_new_velocity) {
    return {
        with_new_velocity ? "x′ = x + Δt v′" : "x′ = x + Δt v",
        {Input::before("x", "position", node, component), dt,
         with_new_velocity ? Input::now("v′", "velocity", node, component) : Input::before("v", "velocity", node, component)}};
}

Explanation pushed(Input v, const Parameter& dt, Input mass, std::vector<Input> forces) {
    const std::string formula = fmt::format("v′ = v + Δt {} / m", sum_of_symbols(forces));
    return {formula, joined({std::move(v), dt, std::move(mass)}, std::move(forces))};
}

Input first_acceleration(Input mass, std::vector<Input> forces) {
    const std::string formula = fmt::format("a_1 = {} / m", sum_of_symbols(forces));
    return part(formula, joined({std::move(mass)}, std::move(forces)));
}

Explanation table_row(std::string_view symbol, const TimeIntegrator& integrator, bool of_velocity, Index dof, Input x, Input v,
                      const Parameter& dt, const std::optional<Input>& first) {
    const auto passes = static_cast<std::size_t>(integrator.passes());
    const NystromRow& row = nystrom_table(integrator.scheme())[passes];
    Explanation e{fmt::format("{} = {}", symbol, of_velocity ? v.symbol : x.symbol), {of_velocity ? v : std::move(x)}};
    if (!of_velocity && row.c != 0) {
        e.formula += " + c Δt v";
        e.inputs.insert(e.inputs.end(),
                        {Input::constant("c", row.c, "", "part of the step, from the table of the scheme"), dt, v});
    }
    std::string sum;
    std::vector<Input> terms;
    for (std::size_t j = 0; j < passes; ++j) {
        const Real weight = of_velocity ? row.velocity[j] : row.position[j];
        if (weight == 0) continue;
        sum += fmt::format("{0}b_{1} a_{1}", sum.empty() ? "" : " + ", j + 1);
        terms.push_back(Input::constant(fmt::format("b_{}", j + 1), weight, "", "weight, from the table of the scheme"));
        terms.push_back(j == 0 && first
                            ? *first
                            : Input::constant(fmt::format("a_{}", j + 1), integrator.acceleration(static_cast<Index>(j))[dof],
                                              "m/s²", fmt::format("f/m where pass {} of this step has evaluated it", j + 1)));
    }
    if (sum.empty()) return e;
    if (e.inputs.size() == 1) e.inputs.push_back(dt);
    e.formula += fmt::format(" + {} ({})", of_velocity ? "Δt" : "Δt²", sum);
    e.inputs = joined(std::move(e.inputs), std::move(terms));
    return e;
}

Explanation newton_iterate(const std::string& symbol, const std::string& letter, const ImplicitSolver& solver, Index dof,
                           Input iterate_before, Input direction, const std::optional<Input>& bound) {
    std::string step = letter + "_k + d";
    std::vector<Input> inputs{std::move(iterate_before), std::move(direction)};
    if (solver.searched()) {
        step = letter + "_s + s d";
        inputs = {
            Input::constant(letter + "_s", solver.search_origin()[dof], "m", "the iterate where the search along a line started"),
            Input::constant("s", solver.fraction(), "", "the fraction of the direction that lowers the potential"),
            Input::constant("d", solver.search_direction()[dof], "m", "Newton's direction from there")};
    }
    if (bound) inputs.push_back(*bound);
    return {bound ? fmt::format("{} = max({}, b)", symbol, step) : fmt::format("{} = {}", symbol, step), std::move(inputs)};
}

Input newton_direction(const ImplicitSolver& solver, Index dof, Real diagonal, const std::vector<std::pair<Index, Real>>& row,
                       int dimension) {
    const bool bounded = solver.form().lower_bound.size() > 0, iterative = solver.linearised() != nullptr;
    const bool coupled = std::ranges::any_of(row, [dof](const auto& entry) { return entry.second != 0 && entry.first != dof; });
    Explanation e{
        fmt::format("d = ({}− g{}{}) / H_aa", bounded ? "R " : "", iterative ? " − r" : "", coupled ? " − Σ_b H_ab d_b" : ""),
        {Input::constant("H_aa", diagonal, "N/m", "stiffness, damping and inertia of the node"),
         Input::constant("g", solver.gradient()[dof], "N", "what the iterate before left unbalanced")}};
    if (bounded) e.inputs.push_back(Input::constant("R", solver.reaction(dof), "N", "force of the ground"));
    if (iterative)
        e.inputs.push_back(
            Input::constant("r", solver.linear_residual(dof), "N", "what conjugate gradients have left of this row"));
    for (const auto& [b, value] : row) {
        if (value == 0 || b == dof) continue;
        e.inputs.push_back(Input::constant("H_ab", value, "N/m", "coupling to a neighbour").in("H_ab"));
        e.inputs.push_back(
            Input::constant("d_b", solver.direction()[b], "m",
                            fmt::format("the neighbour's direction, {} of node {}", "xyz"[b % dimension], b / dimension))
                .in("d_b"));
    }
    return Input::part("d", "m", std::move(e));
}

Input newton_direction(const ImplicitSolver& solver, Index dof, int dimension) {
    const SparseMatrix& H = solver.curvature();
    std::vector<std::pair<Index, Real>> row;
    for (SparseMatrix::InnerIterator entry(H, dof); entry; ++entry) row.emplace_back(entry.row(), entry.value());
    return newton_direction(solver, dof, H.coeff(dof, dof), row, dimension);
}

Input imbalance_left(Real r) { return Input::constant("r", r, "N", "what the solver has left unbalanced"); }

}  // namespace pliant::stepping
