#include "kits/springs/spring_why.h"

#include <pliant/lesson/array.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant::springs {
namespace {

std::string product_of(Values factors) {
    std::string text;
    for (const Real x : factors) text += as_factor(x) + " · ";
    return text;
}

Real product(Values factors) {
    Real product = 1;
    for (const Real x : factors) product *= x;
    return product;
}

// (x_j − x_i)² + (y_j − y_i)² + …, or with velocities (vx_j − vx_i) (x_j − x_i) + …
std::string sum_over_axes(const char* term, int dimension) {
    std::string sum;
    for (int c = 0; c < dimension; ++c) sum += (c ? " + " : "") + fmt::format(fmt::runtime(term), axis_name(c));
    return sum;
}

}  // namespace

void append_ends(std::vector<Input>& inputs, Reading at, std::string_view field, std::string_view before, Index j, Index i,
                 int dimension) {
    for (int c = 0; c < dimension; ++c) {
        const char* letter = axis_name(c);
        inputs.push_back(at(fmt::format("{}{}_j", before, letter), field, j, c));
        inputs.push_back(at(fmt::format("{}{}_i", before, letter), field, i, c));
    }
}

void append_all(std::vector<Input>& inputs, std::string_view before, std::string_view field, Index nodes, int dimension) {
    for (Index n = 0; n < nodes; ++n)
        for (int c = 0; c < dimension; ++c)
            inputs.push_back(Input::now(fmt::format("{}{}_{}", before, axis_name(c), n), field, n, c));
}

Input length_between(Reading at, Index j, Index i, int dimension) {
    std::vector<Input> ends;
    append_ends(ends, at, "position", "", j, i, dimension);
    return part("|x_ij| = √(" + sum_over_axes("({0}_j − {0}_i)²", dimension) + ")", std::move(ends));
}

Input rest_length(const Springs& springs, Index s) {
    return Input::constant("l", springs.rest_length()[s], "m", "rest length of the spring");
}

Input shared_mass(const Parameter& total, Index nodes) {
    return part("m = M / N", {total, Input::constant("N", Real(nodes), "", "nodes that share the mass")});
}

// ------------------------------------------------------------------------------------------------------------- forces

Explanation sum_over_springs(const Springs& springs, Index node, std::string formula, std::string_view symbol,
                             const std::function<Explanation(Index s, Index other)>& term) {
    std::vector<Input> terms;
    for (Index s = 0; s < springs.size(); ++s) {
        if (springs.i(s) != node && springs.j(s) != node) continue;
        const Index other = other_end(springs, s, node);
        terms.push_back(Input::part(fmt::format("{}_{}", symbol, other), "N", term(s, other)));
    }
    if (terms.empty()) formula += ": no springs";
    return sum_of(std::move(formula), std::move(terms));
}

Explanation spring_on_node(Input stiffness, Input rest, Index other, Index node, int component, int dimension) {
    const char* c = axis_name(component);
    return {fmt::format("f_{1} = k (|x_ij| − {2}) ({0}_j − {0}_i) / |x_ij|", c, other, rest.symbol),
            {std::move(stiffness), length_between(Input::now, other, node, dimension), std::move(rest),
             Input::now(fmt::format("{}_j", c), "position", other, component),
             Input::now(fmt::format("{}_i", c), "position", node, component)},
            [](Values x) { return (x[1] > 0 ? x[0] * (x[1] - x[2]) / x[1] : 0) * (x[3] - x[4]); }};
}

Explanation damper_on_node(std::vector<Input> damping, bool projected, Index other, Index node, int component,
                           Reading direction_at, int dimension) {
    const char* c = axis_name(component);
    std::string formula = fmt::format("fᵈ_{} =", other);
    for (const Input& factor : damping) formula += " " + factor.symbol;
    if (!projected) {
        damping.push_back(Input::now(fmt::format("v{}_j", c), "velocity", other, component));
        damping.push_back(Input::now(fmt::format("v{}_i", c), "velocity", node, component));
        return {formula + fmt::format(" (v{0}_j − v{0}_i)", c), std::move(damping)};
    }
    std::vector<Input> rate;
    append_ends(rate, Input::now, "velocity", "v", other, node, dimension);
    append_ends(rate, direction_at, "position", "", other, node, dimension);
    rate.push_back(length_between(direction_at, other, node, dimension));
    damping.push_back(
        part("w = (" + sum_over_axes("(v{0}_j − v{0}_i) ({0}_j − {0}_i)", dimension) + ") / |x_ij|²", std::move(rate)));
    damping.push_back(direction_at(fmt::format("{}_j", c), "position", other, component));
    damping.push_back(direction_at(fmt::format("{}_i", c), "position", node, component));
    return {formula + fmt::format(" w ({0}_j − {0}_i)", c), std::move(damping)};
}

Explanation strain_of(const Springs& springs, Index s, Real strain) {
    return {strain == 0 ? "ε = (|x_ij| − l) / l, and 0 where the difference is rounding" : "ε = (|x_ij| − l) / l",
            {length_between(Input::now, springs.j(s), springs.i(s)), rest_length(springs, s)},
            [](Values x) {
                const Real by_lengths = (x[0] - x[1]) / x[1];
                return std::abs(by_lengths) < strain_rounding ? Real{0} : by_lengths;
            }};
}

Explanation load_on_node(const ExternalLoad<3>& load, const Input& mass, const Parameter& gravity,
                         const Parameter& pull_stiffness, Index node, int component) {
    const char* c = axis_name(component);
    const bool heavy = load.gravity[1] != 0, falls = component == 1 && heavy;
    std::vector<Input> inputs;
    if (falls) inputs = {mass, gravity};
    if (load.pull.active() && load.pull.node == node) {
        inputs.insert(inputs.end(),
                      {pull_stiffness,
                       Input::constant(fmt::format("{}_hand", c), load.pull.target[component], "m", "where the hand pulls to"),
                       Input::now(c, "position", node, component)});
        return {fmt::format("fᵉ = {0}kₕ ({1}_hand − {1})", falls ? "− m g + " : "", c), std::move(inputs)};
    }
    if (falls) return {"fᵉ = − m g", std::move(inputs)};
    return fixed_value(component != 1 && heavy ? "fᵉ = 0: the weight acts along y" : "fᵉ = 0", 0);
}

// ----------------------------------------------------------------------------------------------------------- energies

Explanation energy_in_all(const ExternalLoad<3>& load, const Parameter& pull_stiffness) {
    Explanation e = sum_of("E = K + U + V", {Input::now("K", "kinetic_energy", 0), Input::now("U", "elastic_energy", 0),
                                             Input::now("V", "gravitational_energy", 0)});
    if (!load.pull.active()) return e;
    std::vector<Input> ends{pull_stiffness};
    for (int c = 0; c < 3; ++c) {
        ends.push_back(
            Input::constant(fmt::format("{}_hand", axis_name(c)), load.pull.target[c], "m", "where the hand pulls to"));
        ends.push_back(Input::now(axis_name(c), "position", load.pull.node, c));
    }
    e.formula += " + H";
    e.inputs.push_back(part("H = ½ kₕ ((x_hand − x)² + (y_hand − y)² + (z_hand − z)²)", std::move(ends)));
    return e;
}

Explanation kinetic_energy_of(Input mass, Index nodes, int dimension) {
    std::vector<Input> velocities;
    append_all(velocities, "v", "velocity", nodes, dimension);
    return times_total(
        "K = ½ m Σ (" + sum_over_axes("v_{0}²", dimension) + ")", true, {std::move(mass)}, std::move(velocities),
        [](Values, Values v) { return Eigen::Map<const VecX>(v.data(), static_cast<Index>(v.size())).squaredNorm(); });
}

Explanation gravitational_energy_of(Input mass, const Parameter& gravity, Index nodes) {
    std::vector<Input> heights;
    for (Index n = 0; n < nodes; ++n) heights.push_back(Input::now(fmt::format("y_{}", n), "position", n, 1));
    return times_sum("V = m g Σ y", {std::move(mass), gravity}, std::move(heights));
}

Real elongation_squares(const Springs& springs, Index first, Index last, PointsIn<3> x) {
    Real sum = 0;
    for (Index s = first; s < last; ++s) {
        const Real elongation = (x.col(springs.j(s)) - x.col(springs.i(s))).norm() - springs.rest_length()[s];
        sum += elongation * elongation;
    }
    return sum;
}

// ----------------------------------------------------------------------------------------------------------- products

Explanation times_total(std::string formula, bool half, std::vector<Input> factors, std::vector<Input> many,
                        std::function<Real(Values factors, Values many)> total) {
    const std::size_t count = factors.size();
    factors.insert(factors.end(), std::make_move_iterator(many.begin()), std::make_move_iterator(many.end()));
    return {std::move(formula), std::move(factors),
            [=](Values x) { return (half ? 0.5 : 1) * product(x.first(count)) * total(x.first(count), x.subspan(count)); },
            [=](Values x) {
                return (half ? "½ · " : "") + product_of(x.first(count)) + as_factor(total(x.first(count), x.subspan(count)));
            }};
}

Explanation times_sum(std::string formula, std::vector<Input> factors, std::vector<Input> terms) {
    const std::size_t count = factors.size();
    Explanation e = times_total(std::move(formula), false, std::move(factors), std::move(terms),
                                [](Values, Values many) { return sum_of_terms(Making::sum, many); });
    e.substitute = [count](Values x) { return product_of(x.first(count)) + "(" + sum_text(x.subspan(count)) + ")"; };
    return e;
}

}  // namespace pliant::springs
