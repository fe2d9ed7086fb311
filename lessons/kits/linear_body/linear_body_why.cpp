#include "linear_body_why.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::linear_body {
namespace {

std::string displacement_of(Index node, Index component) { return fmt::format("u{}_{}", axis_name(component), node); }

// The row of K x, with its diagonal or without, appended as two families, the entries and the unknowns: the stiffest first, since
// entries that cancel but for rounding say little.
template <int Dim>
void append_row(std::vector<Input>& inputs, const RowOfEquations& e, bool with_diagonal) {
    std::vector<std::pair<Real, Index>> entries;
    for (SparseMatrix::InnerIterator entry(*e.matrix, e.row); entry; ++entry)
        if ((entry.row() != e.row || with_diagonal) && entry.value() != 0) entries.emplace_back(entry.value(), entry.row());
    std::ranges::stable_sort(entries, std::ranges::greater(), [](const auto& entry) { return std::abs(entry.first); });
    for (const auto& [value, row] : entries) {
        const Index node = row / Dim, component = row % Dim;
        const std::string place = fmt::format("{}_{}", axis_name(component), node);
        const std::string symbol = fmt::format("{}{}", e.unknown, place);
        inputs.push_back(Input::constant(fmt::format("K{}", place), value, "N/m", "entry of the stiffness matrix").in("K_ab"));
        inputs.push_back(
            Input::now(symbol, e.field, e.first_row + node, static_cast<int>(component)).in(fmt::format("{}_b", e.unknown)));
    }
}

Input element_force(const SimplexMesh<3>& mesh, const Hooke& hooke, Index element, int corner, int component) {
    const std::string symbol = fmt::format("F_{}", element);
    const char* row = axis_name(component);
    Explanation e{fmt::format("{0} = V (σ_{1}x ∂N/∂x + σ_{1}y ∂N/∂y + σ_{1}z ∂N/∂z)", symbol, row),
                  {Input::constant("V", mesh.volumes()[element], "m³", "volume of the element")}};
    for (int c = 0; c < 3; ++c) {
        const char* column = axis_name(c);
        e.inputs.push_back(Input::part(fmt::format("σ_{}{}", row, column), "Pa", hooke.why_stress(element, component, c, true)));
        e.inputs.push_back(Input::constant(fmt::format("∂N/∂{}", column), mesh.gradients(element)(c, corner), "1/m",
                                           "slope of the node's shape function"));
    }
    return Input::part(symbol, "N", std::move(e));
}

}  // namespace

template <int Dim>
Explanation why_unknown(const RowOfEquations& equations, std::vector<Input> right) {
    std::string sum = right[0].symbol;
    for (std::size_t k = 1; k < right.size(); ++k) sum += fmt::format(" − {}", right[k].symbol);
    const std::size_t alone = right.size() + 1;
    Explanation e{fmt::format("{0}_a = ({1} − Σ_b K_ab {0}_b) / K_aa", equations.unknown, sum), std::move(right)};
    e.inputs.insert(e.inputs.begin(),
                    Input::constant("K_aa", equations.matrix->coeff(equations.row, equations.row) + equations.added_to_diagonal,
                                    "N/m", "diagonal of the stiffness matrix"));
    append_row<Dim>(e.inputs, equations, false);
    if (e.inputs.size() == alone) e.formula = fmt::format("{0}_a = ({1}) / K_aa", equations.unknown, sum);
    return e;
}
template Explanation why_unknown<2>(const RowOfEquations&, std::vector<Input>);
template Explanation why_unknown<3>(const RowOfEquations&, std::vector<Input>);

Explanation why_displacement(const StaticProblem<3>& problem, Index node, int component, bool has_residual) {
    if (problem.constraints().prescribed(node, component)) return fixed_value("u = 0: held by the support");
    std::vector<Input> right{Input::now("f_a", "load", node, component)};
    if (has_residual) right.push_back(Input::now("r_a", "residual", node, component));
    return why_unknown<3>({&problem.body().stiffness(), 3 * node + component, "u", "displacement"}, std::move(right));
}

Explanation why_residual(const StaticProblem<3>& problem, Index node, int component) {
    if (problem.constraints().prescribed(node, component)) return fixed_value("r = 0: the support takes what is left");
    Explanation e{"r_a = f_a − Σ_b K_ab u_b", {Input::now("f_a", "load", node, component)}};
    append_row<3>(e.inputs, {&problem.body().stiffness(), 3 * node + component, "u", "displacement"}, true);
    return e;
}

Input mean_displacement(std::string_view face, const std::vector<Index>& nodes, int component, Index first_row) {
    std::vector<Input> of_nodes;
    for (const Index n : nodes) of_nodes.push_back(Input::now(fmt::format("u_{}", n), "displacement", first_row + n, component));
    return part(fmt::format("ū_{} = mean_n u_n", face), family_of("u_n", std::move(of_nodes)));
}

Explanation why_strain(const SimplexMesh<3>& mesh, Index element, int row, int column) {
    const auto g = mesh.gradients(element);
    const char *r = axis_name(row), *c = axis_name(column);
    Explanation e{row == column ? fmt::format("ε_{0}{0} = Σ_a ∂N_a/∂{0} u{0}_a", r)
                                : fmt::format("ε_{0}{1} = ½ Σ_a (∂N_a/∂{1} u{0}_a + ∂N_a/∂{0} u{1}_a)", r, c)};
    const auto add = [&](int corner, int along, int component) {
        const Index node = mesh.simplices()(corner, element);
        const char* letter = axis_name(along);
        e.inputs.push_back(Input::constant(fmt::format("∂N_{}/∂{}", node, letter), g(along, corner), "1/m",
                                           "slope of the corner's shape function")
                               .in(fmt::format("∂N_a/∂{}", letter)));
        e.inputs.push_back(Input::now(displacement_of(node, component), "displacement", node, component)
                               .in(fmt::format("u{}_a", axis_name(component))));
    };
    for (int a = 0; a < 4; ++a) {
        add(a, column, row);
        if (row != column) add(a, row, column);
    }
    return e;
}

Explanation Hooke::why_stress(Index element, int row, int column, bool from_displacement) const {
    const auto strain = [&](int i, int j) {
        const std::string symbol = fmt::format("ε_{}{}", axis_name(i), axis_name(j));
        return from_displacement ? Input::part(symbol, "", why_strain(*mesh, element, i, j))
                                 : Input::now(symbol, "strain", element, 3 * i + j);
    };
    const std::string name = std::string(axis_name(row)) + axis_name(column);
    if (row != column) return {fmt::format("σ_{0} = 2 μ ε_{0}", name), {mu, strain(row, column)}};
    return {fmt::format("σ_{0} = λ (ε_xx + ε_yy + ε_zz) + 2 μ ε_{0}", name),
            {lambda, mu, strain(0, 0), strain(1, 1), strain(2, 2)}};
}

Explanation why_reaction(const StaticProblem<3>& problem, const Hooke& hooke, Index node, int component) {
    if (!problem.constraints().prescribed(node, component)) return fixed_value("r = 0: no support here");
    Explanation e{"r = Σ_e F_e − f, F_e = V σ·∇N", {Input::now("f", "load", node, component)}};
    const auto& simplices = problem.body().mesh().simplices();
    for (Index k = 0; k < simplices.cols(); ++k)
        for (int corner = 0; corner < 4; ++corner)
            if (simplices(corner, k) == node)
                e.inputs.push_back(element_force(problem.body().mesh(), hooke, k, corner, component).in("F_e"));
    return e;
}

}  // namespace pliant::linear_body
