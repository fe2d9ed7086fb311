#include "linear_body_why.h"

#include <fmt/format.h>

namespace pliant::linear_body {
namespace {

std::string displacement_of(Index node, Index component) {
    return fmt::format("u{}_{}", axis[static_cast<std::size_t>(component)], node);
}

// The row of K u that belongs to an unknown, appended as pairs of an entry and a displacement. Supports hold nodes at 0: what
// they hold adds nothing. without: an unknown that is left out, or -1.
void append_row(std::vector<Input>& inputs, const StaticProblem<3>& problem, Index row, Index without) {
    const SparseMatrix& K = problem.body().stiffness();
    for (SparseMatrix::InnerIterator entry(K, row); entry; ++entry) {
        const Index node = entry.row() / 3, component = entry.row() % 3;
        if (entry.row() == without || entry.value() == 0) continue;
        if (problem.constraints().prescribed(node, static_cast<int>(component))) continue;
        inputs.push_back(
            Input::constant(fmt::format("K_{}", fmt::format("{}{}", axis[static_cast<std::size_t>(component)], node)),
                            entry.value(), "N/m", "entry of the stiffness matrix"));
        inputs.push_back(Input::now(displacement_of(node, component), "displacement", node, static_cast<int>(component)));
    }
}

Real products(std::span<const Real> x) {
    Real sum = 0;
    for (std::size_t k = 0; k + 1 < x.size(); k += 2) sum += x[k] * x[k + 1];
    return sum;
}

Input element_force(const SimplexMesh<3>& mesh, const Hooke& hooke, Index element, int corner, int component) {
    const std::string symbol = fmt::format("F_{}", element);
    const char row = axis[static_cast<std::size_t>(component)];
    Explanation e{.formula = fmt::format("{0} = V (σ_{1}x ∂N/∂x + σ_{1}y ∂N/∂y + σ_{1}z ∂N/∂z)", symbol, row),
                  .inputs = {Input::constant("V", mesh.volumes()[element], "m³", "volume of the element")},
                  .evaluate = [](std::span<const Real> x) { return x[0] * products(x.subspan(1)); }};
    for (int c = 0; c < 3; ++c) {
        const char column = axis[static_cast<std::size_t>(c)];
        e.inputs.push_back(Input::part(fmt::format("σ_{}{}", row, column), "Pa", hooke.why_stress(element, component, c, true)));
        e.inputs.push_back(Input::constant(fmt::format("∂N/∂{}", column), mesh.gradients(element)(c, corner), "1/m",
                                           "slope of the node's shape function"));
    }
    return Input::part(symbol, "N", std::move(e));
}

}  // namespace

Explanation nothing(std::string formula) {
    return {.formula = std::move(formula), .inputs = {}, .evaluate = [](std::span<const Real>) { return Real{0}; }};
}

Input lame_lambda(const Parameter& youngs_modulus, const Parameter& poisson_ratio) {
    return Input::part("λ", "Pa",
                       {.formula = "λ = Y ν / ((1 + ν) (1 − 2 ν))",
                        .inputs = {Input::of(youngs_modulus), Input::of(poisson_ratio)},
                        .evaluate = [](std::span<const Real> x) { return x[0] * x[1] / ((1 + x[1]) * (1 - 2 * x[1])); }});
}

Input lame_mu(const Parameter& youngs_modulus, const Parameter& poisson_ratio) {
    return Input::part("μ", "Pa",
                       {.formula = "μ = Y / (2 (1 + ν))",
                        .inputs = {Input::of(youngs_modulus), Input::of(poisson_ratio)},
                        .evaluate = [](std::span<const Real> x) { return x[0] / (2 * (1 + x[1])); }});
}

Explanation why_displacement(const StaticProblem<3>& problem, Index node, int component, bool has_residual) {
    if (problem.constraints().prescribed(node, component)) return nothing("u = 0: held by the support");
    const Index row = 3 * node + component;
    Explanation e{
        .formula = has_residual ? "u_a = (f_a − r_a − Σ K_ab u_b) / K_aa" : "u_a = (f_a − Σ K_ab u_b) / K_aa",
        .inputs = {Input::constant("K_aa", problem.body().stiffness().coeff(row, row), "N/m", "diagonal of the stiffness matrix"),
                   Input::now("f_a", "load", node, component)},
        .evaluate = {}};
    if (has_residual) e.inputs.push_back(Input::now("r_a", "residual", node, component));
    const std::size_t head = e.inputs.size();
    append_row(e.inputs, problem, row, row);
    e.evaluate = [head](std::span<const Real> x) {
        return (x[1] - (head > 2 ? x[2] : Real{0}) - products(x.subspan(head))) / x[0];
    };
    e.substitute = [head](std::span<const Real> x) {
        const std::array balance{x[1], head > 2 ? -x[2] : Real{0}};
        return fmt::format("({} − ({})) / {}", sum_text(std::span(balance).first(head - 1)), products_text(x.subspan(head)),
                           sum_text(x.first(1)));
    };
    return e;
}

Explanation why_residual(const StaticProblem<3>& problem, Index node, int component) {
    if (problem.constraints().prescribed(node, component)) return nothing("r = 0: the support takes what is left");
    Explanation e{.formula = "r_a = f_a − Σ K_ab u_b", .inputs = {Input::now("f_a", "load", node, component)}, .evaluate = {}};
    append_row(e.inputs, problem, 3 * node + component, -1);
    e.evaluate = [](std::span<const Real> x) { return x[0] - products(x.subspan(1)); };
    e.substitute = [](std::span<const Real> x) {
        return fmt::format("{} − ({})", sum_text(x.first(1)), products_text(x.subspan(1)));
    };
    return e;
}

Explanation why_strain(const SimplexMesh<3>& mesh, Index element, int row, int column) {
    const auto g = mesh.gradients(element);
    const char r = axis[static_cast<std::size_t>(row)], c = axis[static_cast<std::size_t>(column)];
    const bool normal = row == column;
    std::vector<std::pair<Input, Input>> terms;
    const auto add = [&](int corner, int along, int component) {
        const Index node = mesh.simplices()(corner, element);
        const char letter = axis[static_cast<std::size_t>(along)];
        terms.emplace_back(
            Input::constant(normal ? fmt::format("∂N_{}/∂{}", node, letter) : fmt::format("½ ∂N_{}/∂{}", node, letter),
                            (normal ? 1 : 0.5) * g(along, corner), "1/m", "slope of the corner's shape function"),
            Input::now(displacement_of(node, component), "displacement", node, component));
    };
    for (int a = 0; a < 4; ++a) {
        add(a, column, row);
        if (!normal) add(a, row, column);
    }
    return weighted_sum(normal ? fmt::format("ε_{0}{0} = Σ ∂N_a/∂{0} u{0}_a", r)
                               : fmt::format("ε_{0}{1} = ½ Σ (∂N_a/∂{1} u{0}_a + ∂N_a/∂{0} u{1}_a)", r, c),
                        terms);
}

Explanation Hooke::why_stress(Index element, int row, int column, bool from_displacement) const {
    const auto strain = [&](int i, int j) {
        const std::string symbol = fmt::format("ε_{}{}", axis[static_cast<std::size_t>(i)], axis[static_cast<std::size_t>(j)]);
        return from_displacement ? Input::part(symbol, "", why_strain(*mesh, element, i, j))
                                 : Input::now(symbol, "strain", element, 3 * i + j);
    };
    const std::string name{axis[static_cast<std::size_t>(row)], axis[static_cast<std::size_t>(column)]};
    if (row != column)
        return {.formula = fmt::format("σ_{0} = 2 μ ε_{0}", name),
                .inputs = {mu, strain(row, column)},
                .evaluate = [](std::span<const Real> x) { return 2 * x[0] * x[1]; }};
    return {.formula = fmt::format("σ_{0} = λ (ε_xx + ε_yy + ε_zz) + 2 μ ε_{0}", name),
            .inputs = {lambda, mu, strain(0, 0), strain(1, 1), strain(2, 2)},
            .evaluate = [row](std::span<const Real> x) {
                return x[0] * (x[2] + x[3] + x[4]) + 2 * x[1] * x[2 + static_cast<std::size_t>(row)];
            }};
}

Explanation why_reaction(const StaticProblem<3>& problem, const Hooke& hooke, Index node, int component) {
    if (!problem.constraints().prescribed(node, component)) return nothing("r = 0: no support here");
    Explanation e{.formula = "r = Σ V σ·∇N − f", .inputs = {Input::now("f", "load", node, component)}, .evaluate = {}};
    const auto& simplices = problem.body().mesh().simplices();
    for (Index k = 0; k < simplices.cols(); ++k)
        for (int corner = 0; corner < 4; ++corner)
            if (simplices(corner, k) == node)
                e.inputs.push_back(element_force(problem.body().mesh(), hooke, k, corner, component));
    const auto sum = [](std::span<const Real> x) {
        Real total = 0;
        for (const Real force : x.subspan(1)) total += force;
        return total;
    };
    e.evaluate = [sum](std::span<const Real> x) { return sum(x) - x[0]; };
    e.substitute = [](std::span<const Real> x) { return fmt::format("{} − {}", sum_text(x.subspan(1)), as_factor(x[0])); };
    return e;
}

}  // namespace pliant::linear_body
