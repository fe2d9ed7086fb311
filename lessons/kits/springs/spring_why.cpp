#include "kits/springs/spring_why.h"

#include <pliant/lesson/array.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant::springs {
namespace {

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
            inputs.push_back(Input::now(fmt::format("{}{}_{}", before, axis_name(c), n), field, n, c)
                                 .in(fmt::format("{}{}{}", before, before.empty() ? "" : "_", axis_name(c))));
}

void append_points(std::vector<Input>& inputs, const std::string& symbol, std::string_view before, std::string_view field,
                   Index nodes, int dimension) {
    std::vector<Input> all;
    append_all(all, before, field, nodes, dimension);
    for (Input& one : all) inputs.push_back(one.in(symbol));
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

Explanation sum_over_springs(const Springs& springs, Index node, std::string_view left, std::string_view said,
                             std::string_view symbol, const std::function<Explanation(Index s, Index other)>& term) {
    std::vector<Input> terms;
    for (Index s = 0; s < springs.size(); ++s) {
        if (springs.i(s) != node && springs.j(s) != node) continue;
        const Index other = other_end(springs, s, node);
        terms.push_back(Input::part(fmt::format("{}_{}", symbol, other), "N", term(s, other)));
    }
    if (terms.empty()) return fixed_value(fmt::format("{} = 0: no springs", left));
    const std::string family = fmt::format("{}_j", symbol);
    return sum_of(fmt::format("{} = Σ_j {}, {}", left, family, said), family, std::move(terms));
}

Explanation spring_on_node(Input stiffness, Input rest, bool apart, Index other, Index node, int component, int dimension) {
    const char* c = axis_name(component);
    if (!apart) return fixed_value(fmt::format("f_{} = 0: both ends of the spring are at one place", other));
    return {fmt::format("f_{1} = k (|x_ij| − {2}) ({0}_j − {0}_i) / |x_ij|", c, other, rest.symbol),
            {std::move(stiffness), length_between(Input::now, other, node, dimension), std::move(rest),
             Input::now(fmt::format("{}_j", c), "position", other, component),
             Input::now(fmt::format("{}_i", c), "position", node, component)}};
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
            {length_between(Input::now, springs.j(s), springs.i(s)), rest_length(springs, s)}};
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
    return fixed_value(component != 1 && heavy ? "fᵉ = 0: the weight acts along y" : "fᵉ = 0");
}

// ----------------------------------------------------------------------------------------------------------- energies

Explanation energy_in_all(const ExternalLoad<3>& load, const Parameter& pull_stiffness) {
    Explanation e{
        "E = K + U + V",
        {Input::now("K", "kinetic_energy", 0), Input::now("U", "elastic_energy", 0), Input::now("V", "gravitational_energy", 0)}};
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
    Explanation e{"K = ½ m Σ_n (" + sum_over_axes("v_{0}²", dimension) + ")", {std::move(mass)}};
    append_all(e.inputs, "v", "velocity", nodes, dimension);
    return e;
}

Explanation gravitational_energy_of(Input mass, const Parameter& gravity, Index nodes) {
    Explanation e{"V = m g Σ_n y_n", {std::move(mass), gravity}};
    for (Index n = 0; n < nodes; ++n) e.inputs.push_back(Input::now(fmt::format("y_{}", n), "position", n, 1).in("y_n"));
    return e;
}

Real elongation_squares(const Springs& springs, Index first, Index last, PointsIn<3> x) {
    Real sum = 0;
    for (Index s = first; s < last; ++s) {
        const Real elongation = (x.col(springs.j(s)) - x.col(springs.i(s))).norm() - springs.rest_length()[s];
        sum += elongation * elongation;
    }
    return sum;
}

}  // namespace pliant::springs
