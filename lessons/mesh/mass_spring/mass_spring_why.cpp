// Why the forces are what they are: each spring, damper and load of a node.
#include "mass_spring.h"
#include "mesh/springs/spring_why.h"

#include <fmt/format.h>

#include <cmath>

namespace pliant::mass_spring {
namespace {

std::string named(const char* letter, std::string_view index) { return fmt::format("{}_{}", letter, index); }

using springs::append_ends, springs::difference, springs::length_between, springs::other_end, springs::rest_length;

// The sum over the springs of a node.
template <class Term>
Explanation sum_over_springs(const Springs& springs, Index node, std::string formula, std::string_view symbol, Term term) {
    std::vector<Input> terms;
    for (Index s = 0; s < springs.size(); ++s)
        if (springs.i(s) == node || springs.j(s) == node)
            terms.push_back(Input::part(fmt::format("{}_{}", symbol, other_end(springs, s, node)), "N", term(s)));
    if (terms.empty()) formula += ": no springs";
    return sum_of(std::move(formula), std::move(terms));
}

}  // namespace

Input MassSpringLesson::stiffness_of_spring(Index s) const {
    const Number& k = s < block_->last(structural) ? k_structural : s < block_->last(shear) ? k_shear : k_bending;
    return Input::of(k, "k");
}

Input MassSpringLesson::node_mass() const {
    return Input::part(
        "m", "kg",
        {.formula = "m = M / N",
         .inputs = {Input::of(total_mass), Input::constant("N", Real(block_->mass().size()), "", "nodes that share the mass")}});
}

Explanation MassSpringLesson::why_spring_stage(const Question& q) const {
    if (q.field == "tension") return why_tension(q.index);
    if (q.field == "strain") return why_strain(q.index);
    return why_spring_force(q.index, q.component);
}

Explanation MassSpringLesson::why_spring_force(Index node, int component) const {
    return sum_over_springs(block_->springs(), node, "f = Σ k (|x_ij| − l) (x_j − x_i) / |x_ij|", "f",
                            [&](Index s) { return why_spring_on_node(s, node, component); });
}

Explanation MassSpringLesson::why_spring_on_node(Index s, Index node, int component) const {
    const Index other = other_end(block_->springs(), s, node);
    const char* letter = axis_name(component);
    return {.formula = fmt::format("f_{1} = k (|x_ij| − l) ({0}_j − {0}_i) / |x_ij|", letter, other),
            .inputs = {stiffness_of_spring(s), length_between(Input::now, other, node), rest_length(block_->springs(), s),
                       Input::now(named(letter, "j"), "position", other, component),
                       Input::now(named(letter, "i"), "position", node, component)},
            .evaluate = [](std::span<const Real> x) { return (x[1] > 0 ? x[0] * (x[1] - x[2]) / x[1] : 0) * (x[3] - x[4]); }};
}

Explanation MassSpringLesson::why_tension(Index s) const {
    const Springs& springs = block_->springs();
    const bool rounded = tension_[s] == 0 && springs.rest_length()[s] > 0;
    return {.formula = rounded ? "T = k (|x_ij| − l), and 0 where the difference is rounding" : "T = k (|x_ij| − l)",
            .inputs = {stiffness_of_spring(s), length_between(Input::now, springs.j(s), springs.i(s)), rest_length(springs, s)},
            .evaluate = [](std::span<const Real> x) {
                return x[2] > 0 && std::abs((x[1] - x[2]) / x[2]) < strain_rounding ? Real{0} : x[0] * (x[1] - x[2]);
            }};
}

Explanation MassSpringLesson::why_strain(Index s) const {
    const Springs& springs = block_->springs();
    if (springs.rest_length()[s] == 0) return fixed_value("ε = 0: a spring of rest length 0 has no strain", 0);
    const bool rounded = strain_[s] == 0;
    return {.formula = rounded ? "ε = (|x_ij| − l) / l, and 0 where the difference is rounding" : "ε = (|x_ij| − l) / l",
            .inputs = {length_between(Input::now, springs.j(s), springs.i(s)), rest_length(springs, s)},
            .evaluate = [](std::span<const Real> x) {
                const Real strain = (x[0] - x[1]) / x[1];
                return std::abs(strain) < strain_rounding ? Real{0} : strain;
            }};
}

// direction_at: where the directions of projected dampers are taken from.
Explanation MassSpringLesson::why_damping_force(Index node, int component, Reading direction_at) const {
    const bool projected = damping_mode == SpringDamping::projected;
    return sum_over_springs(block_->springs(), node,
                            projected ? "fᵈ = Σ kᵈ (v_ij · x_ij / |x_ij|²) (x_j − x_i)" : "fᵈ = Σ kᵈ (v_j − v_i)", "fᵈ",
                            [&](Index s) { return why_damper_on_node(s, node, component, direction_at); });
}

Explanation MassSpringLesson::why_damper_on_node(Index s, Index node, int component, Reading direction_at) const {
    const Index other = other_end(block_->springs(), s, node);
    const char* letter = axis_name(component);
    if (damping_mode == SpringDamping::naive)
        return {.formula = fmt::format("fᵈ_{1} = kᵈ (v{0}_j − v{0}_i)", letter, other),
                .inputs = {Input::of(damping), Input::now(fmt::format("v{}_j", letter), "velocity", other, component),
                           Input::now(fmt::format("v{}_i", letter), "velocity", node, component)},
                .evaluate = [](std::span<const Real> x) { return x[0] * (x[1] - x[2]); }};

    Explanation rate{
        .formula = "w = ((vx_j − vx_i) (x_j − x_i) + (vy_j − vy_i) (y_j − y_i) + (vz_j − vz_i) (z_j − z_i)) / |x_ij|²",
        .inputs = {}};
    append_ends(rate.inputs, Input::now, "velocity", "v", other, node);
    append_ends(rate.inputs, direction_at, "position", "", other, node);
    rate.inputs.push_back(length_between(direction_at, other, node));
    return {.formula = fmt::format("fᵈ_{1} = kᵈ w ({0}_j − {0}_i)", letter, other),
            .inputs = {Input::of(damping), Input::part("w", "1/s", std::move(rate)),
                       direction_at(named(letter, "j"), "position", other, component),
                       direction_at(named(letter, "i"), "position", node, component)},
            .evaluate = [](std::span<const Real> x) { return x[0] * x[1] * (x[2] - x[3]); }};
}

Explanation MassSpringLesson::why_external_force(Index node, int component) const {
    Explanation e{.formula = "fᵉ = 0", .inputs = {}, .evaluate = {}};
    const bool falls = component == 1 && weight_acceleration() > 0;
    const bool pulled_here = load_.pull.active() && load_.pull.node == node;
    if (falls) e.inputs = {node_mass(), Input::of(gravity)};
    if (pulled_here) {
        const char* letter = axis_name(component);
        e.inputs.push_back(Input::of(pull_stiffness));
        e.inputs.push_back(Input::constant(named(letter, "hand"), load_.pull.target[component], "m", "where the hand pulls to"));
        e.inputs.push_back(Input::now(letter, "position", node, component));
        e.formula = fmt::format("fᵉ = {0}kₕ ({1}_hand − {1})", falls ? "− m g + " : "", letter);
    } else if (falls) {
        e.formula = "fᵉ = − m g";
    } else if (component != 1 && weight_acceleration() > 0) {
        e.formula = "fᵉ = 0: the weight acts along y";
    }
    e.evaluate = [falls, pulled_here](std::span<const Real> x) {
        const Real weight = falls ? -x[0] * x[1] : Real{0};
        const std::span<const Real> pull = x.subspan(falls ? 2 : 0);
        return pulled_here ? weight + pull[0] * (pull[1] - pull[2]) : weight;
    };
    return e;
}

}  // namespace pliant::mass_spring
