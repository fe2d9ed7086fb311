#include "solid_why.h"

#include "kits/tensors/tensor_why.h"

#include <fmt/format.h>
#include <Eigen/LU>

#include <algorithm>
#include <set>

namespace pliant::solid_mesh {
namespace {

Small small_matrix(int dim, std::span<const Real> x) {
    Small m(dim, dim);
    for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) m(i, j) = x[static_cast<std::size_t>(dim * i + j)];
    return m;
}

std::string displacement_of(Index node, int component) { return fmt::format("u{}_{}", axis_name(component), node); }

// The displacements of some nodes as one family, "u_n".
std::vector<Input> displacements(const std::vector<Index>& nodes, int dim) {
    std::vector<Input> inputs;
    for (const Index n : nodes)
        for (int c = 0; c < dim; ++c) inputs.push_back(Input::now(displacement_of(n, c), "displacement", n, c).in("u_n"));
    return inputs;
}

// The same numbers back in their places.
void spread(std::span<const Real> x, const std::vector<Index>& nodes, MatX& u) {
    std::size_t k = 0;
    for (const Index n : nodes)
        for (Index c = 0; c < u.rows(); ++c) u(c, n) = x[k++];
}

std::vector<Index> nodes_of(const Solid& solid, Index element) {
    std::vector<Index> nodes;
    for (int a = 0; a < solid.nodes_of_element(); ++a) nodes.push_back(solid.node(element, a));
    return nodes;
}

}  // namespace

Input SolidWhy::entry_now(std::string_view symbol, std::string_view field, Index element, int i, int j) const {
    return Input::now(why::entry(symbol, i, j), field, element, solid->dim() * i + j);
}

std::vector<Input> SolidWhy::all_entries(std::string_view symbol, std::string_view field, Index element) const {
    std::vector<Input> all;
    for (int i = 0; i < solid->dim(); ++i)
        for (int j = 0; j < solid->dim(); ++j) all.push_back(entry_now(symbol, field, element, i, j));
    return all;
}

Input SolidWhy::mu() const { return lame_mu(parameters->youngs_modulus, parameters->poisson_ratio); }

Input SolidWhy::lambda() const {
    Input in_space = lame_lambda(parameters->youngs_modulus, parameters->poisson_ratio);
    if (solid->dim() == 3 || solid->settings().plane == Plane::strain) return in_space;
    in_space.symbol = "λ₃";
    return Input::part("λ", "Pa", {"λ = 2 λ₃ μ / (λ₃ + 2 μ), in plane stress", {std::move(in_space), mu()}});
}

// Of the corners of a beam from its sizes.
Input SolidWhy::place_at_rest(Index node, int axis) const {
    const std::string symbol = fmt::format("X{}_{}", axis_name(axis), node);
    const Real value = solid->rest()(axis, node);
    if (const Shape shape = solid->settings().shape; shape != Shape::beam && shape != Shape::panel)
        return Input::constant(symbol, value, "m", "place of the node at rest");
    const std::array<const Number*, 3> sizes{&parameters->length, &parameters->height, &parameters->width};
    const std::array<const Whole*, 3> cells{&parameters->cells_x, &parameters->cells_y, &parameters->cells_z};
    const auto k = static_cast<std::size_t>(axis);
    const Index count = *cells[k];
    // Middles of edges lie half way.
    const Real place = std::round(2 * value / *sizes[k] * static_cast<Real>(count)) / 2;
    return Input::part(symbol, "m",
                       {fmt::format("{} = {} k / n", symbol, sizes[k]->info.symbol),
                        {*sizes[k], Input::constant("k", place, "", "cells from the end"), Input::of(*cells[k], "n")}});
}

Explanation SolidWhy::volume(Index element) const {
    Explanation e{fmt::format("V = volume(X_n), of the {}", solid->dim() == 2 ? "triangle, 1 m thick" : "tetrahedron"), {}};
    for (int a = 0; a <= solid->dim(); ++a)
        for (int c = 0; c < solid->dim(); ++c) e.inputs.push_back(place_at_rest(solid->node(element, a), c).in("X_n"));
    return std::move(e).by("volume", "m³", [d = solid->dim()](Values x) {
        Small edges(d, d);
        for (int a = 0; a < d; ++a)
            for (int c = 0; c < d; ++c)
                edges(c, a) = x[static_cast<std::size_t>(d * (a + 1) + c)] - x[static_cast<std::size_t>(c)];
        return edges.determinant() / (d == 2 ? 2 : 6);
    });
}

Explanation SolidWhy::deformation(Index element, int i, int j) const {
    const MatX g = solid->slopes(element);
    std::vector<std::pair<Input, Input>> terms;
    for (int a = 0; a < solid->nodes_of_element(); ++a) {
        const Index n = solid->node(element, a);
        if (g(j, a) == 0) continue;
        terms.emplace_back(
            Input::now(displacement_of(n, i), "displacement", n, i),
            Input::constant(fmt::format("∂N_{}/∂{}", n, axis_name(j)), g(j, a), "1/m", "slope of the node's shape function"));
    }
    return weighted_sum(fmt::format("{} = {}Σ_a u_a ∂N_a", why::entry("F", i, j), i == j ? "1 + " : ""), "u_a", "∂N_a", terms);
}

Explanation SolidWhy::strain(Index element, int i, int j) const {
    const auto F = [&](int r, int c) { return entry_now("F", "deformation_gradient", element, r, c); };
    if (linear()) {
        if (i == j) return {fmt::format("{} = {} − 1", why::entry("ε", i, i), why::entry("F", i, i)), {F(i, i)}};
        return {fmt::format("{} = ½ ({} + {})", why::entry("ε", i, j), why::entry("F", i, j), why::entry("F", j, i)),
                {F(i, j), F(j, i)}};
    }
    const bool turns = solid->settings().law == Law::corotational;
    const auto left = [&](int r, int k) { return turns ? entry_now("R", "rotation", element, r, k) : F(r, k); };
    std::vector<Input> inputs;
    std::string sum;
    for (int k = 0; k < solid->dim(); ++k) {
        inputs.push_back(left(k, i));
        if (turns || i != j) inputs.push_back(F(k, j));
        const bool square = !turns && i == j;
        sum += fmt::format("{}{}", k ? " + " : "",
                           square ? why::entry("F", k, i) + "²"
                                  : fmt::format("{} {}", why::entry(turns ? "R" : "F", k, i), why::entry("F", k, j)));
    }
    const char* one = i == j ? " − 1" : "";
    if (turns) return {fmt::format("{} = {}{}, e = S − I = RᵀF − I", why::entry("e", i, j), sum, one), std::move(inputs)};
    return {fmt::format("{} = ½ ({}{})", why::entry("E", i, j), sum, one), std::move(inputs)};
}

Explanation SolidWhy::rotation(Index element, int i, int j) const {
    return Explanation{fmt::format("{} = turn(F_n), an entry of the rotation nearest to F", why::entry("R", i, j)),
                       family_of("F_n", all_entries("F", "deformation_gradient", element))}
        .by("turn", "", [body = solid, i, j](Values x) { return body->rotation(small_matrix(body->dim(), x))(i, j); });
}

// 2 μ ε_ij + λ tr ε.
Input SolidWhy::hooke(std::string_view left, std::string_view symbol, Index element, int i, int j) const {
    const std::string name = why::entry(left, i, j), own = why::entry(symbol, i, j);
    if (i != j)
        return Input::part(name, "Pa",
                           {fmt::format("{} = 2 μ {}", name, own), {mu(), entry_now(symbol, "strain", element, i, j)}});
    std::string trace;
    Explanation e{"", {mu(), lambda()}};
    for (int k = 0; k < solid->dim(); ++k) {
        e.inputs.push_back(entry_now(symbol, "strain", element, k, k));
        trace += (k ? " + " : "") + why::entry(symbol, k, k);
    }
    e.formula = fmt::format("{} = 2 μ {} + λ ({})", name, own, trace);
    return Input::part(name, "Pa", std::move(e));
}

Explanation SolidWhy::stress(Index element, int i, int j) const {
    const std::string name = why::entry("P", i, j);
    if (linear()) return *hooke("P", "ε", element, i, j).why;
    if (solid->settings().law != Law::neo_hookean) {
        // Hooke's law on the strain, turned by R or taken along by F.
        const bool turns = solid->settings().law == Law::corotational;
        const std::string_view left = turns ? "R" : "F", field = turns ? "rotation" : "deformation_gradient";
        std::vector<std::pair<Input, Input>> terms;
        for (int k = 0; k < solid->dim(); ++k)
            terms.emplace_back(entry_now(left, field, element, i, k), hooke("S", turns ? "e" : "E", element, k, j));
        const std::string along_row = fmt::format("{}_{}k", left, i + 1), along_column = fmt::format("S_k{}", j + 1);
        return weighted_sum(fmt::format("{} = Σ_k {} {}", name, along_row, along_column), along_row, along_column, terms);
    }
    Explanation e{fmt::format("{} = law(F_n, μ, λ), an entry of μ (F − G) + λ ln J G, G the transposed inverse of F", name),
                  family_of("F_n", all_entries("F", "deformation_gradient", element))};
    e.inputs.push_back(mu()), e.inputs.push_back(lambda());
    return std::move(e).by("law", "Pa", [d = solid->dim(), i, j](Values x) {
        const auto entries = static_cast<std::size_t>(d * d);
        const Lame material{.lambda = x[entries + 1], .mu = x[entries]};
        const Small F = small_matrix(d, x);
        if (d == 2) return EnergyDensity<2>(Energy::neo_hookean, material).P(F)(i, j);
        return EnergyDensity<3>(Energy::neo_hookean, material).P(F)(i, j);
    });
}

Explanation SolidWhy::von_mises(Index element) const {
    return Explanation{linear() ? "σ_v = mises(F_n), √(3/2) times the norm of the deviator of the stress"
                                : "σ_v = mises(F_n), √(3/2) times the norm of the deviator of Cauchy's stress",
                       family_of("F_n", all_entries("F", "deformation_gradient", element))}
        .by("mises", "Pa", [body = solid](Values x) { return body->von_mises(small_matrix(body->dim(), x)); });
}

Explanation SolidWhy::stiffness(Index element, int a, int i, int j) const {
    const std::string name = fmt::format("K_{}{}", axis_name(i), axis_name(j));
    if (linear() && first_order()) {
        const MatX g = solid->slopes(element);
        const auto slope = [&](int k) {
            return Input::constant(fmt::format("g_{}", axis_name(k)), g(k, a), "1/m", "slope of the node's shape function");
        };
        Explanation e{"", {Input::now("V", "rest_volume", element), lambda(), mu()}};
        std::string square;
        const bool diagonal = i == j;
        for (int k = 0; k < solid->dim(); ++k) {
            if (diagonal || k == i || k == j) e.inputs.push_back(slope(k));
            square += fmt::format("{}g_{}²", k ? " + " : "", axis_name(k));
        }
        e.formula = diagonal ? fmt::format("{} = V ((λ + μ) g_{}² + μ ({}))", name, axis_name(i), square)
                             : fmt::format("{} = V (λ + μ) g_{} g_{}", name, axis_name(i), axis_name(j));
        return e;
    }
    const std::vector<Index> nodes = nodes_of(*solid, element);
    return Explanation{fmt::format("{} = curvature(u_n), second derivative of the energy of the element", name),
                       displacements(nodes, solid->dim())}
        .by("curvature", "N/m", [body = solid, element, nodes, a, i, j](Values x) {
            MatX u = MatX::Zero(body->dim(), body->node_count());
            spread(x, nodes, u);
            return body->element_stiffness(element, u)(body->dim() * a + i, body->dim() * a + j);
        });
}

Explanation SolidWhy::internal_force(Index node, int component) const {
    if (!first_order()) return force_of_patch(node, component);
    std::vector<Input> parts;
    for (const auto& [element, a] : solid->elements_about(node)) {
        const MatX g = solid->slopes(element);
        const std::string symbol = fmt::format("f_{}", element);
        Explanation e{"", {Input::now("V", "rest_volume", element)}};
        std::string sum;
        for (int c = 0; c < solid->dim(); ++c) {
            const std::string entry = why::entry("P", component, c), slope = fmt::format("∂N/∂{}", axis_name(c));
            e.inputs.push_back(entry_now("P", "stress", element, component, c));
            e.inputs.push_back(Input::constant(slope, g(c, a), "1/m", "slope of the node's shape function"));
            sum += fmt::format("{}{} {}", c ? " + " : "", entry, slope);
        }
        e.formula = fmt::format("{} = V ({})", symbol, sum);
        parts.push_back(Input::part(symbol, "N", std::move(e)));
    }
    return sum_of("f = Σ f_e", "f_e", std::move(parts));
}

// Elements of second order take their stress at several points: from the displacements at once.
Explanation SolidWhy::force_of_patch(Index node, int component) const {
    std::set<Index> around;
    for (const auto& [element, a] : solid->elements_about(node))
        for (const Index n : nodes_of(*solid, element)) around.insert(n);
    const std::vector<Index> nodes(around.begin(), around.end());
    return Explanation{
        fmt::format("f = slope(u_n), of the energy of the {} elements about the node", solid->elements_about(node).size()),
        displacements(nodes, solid->dim())}
        .by("slope", "N", [body = solid, node, component, nodes](Values x) {
            MatX u = MatX::Zero(body->dim(), body->node_count()), f;
            spread(x, nodes, u);
            body->internal_force(u, f);
            return f(component, node);
        });
}

}  // namespace pliant::solid_mesh
