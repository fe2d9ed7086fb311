// Why the forces are what they are: each spring, damper and load of a node.
#include "cloth.h"
#include "mesh/springs/spring_why.h"

#include <fmt/format.h>

#include <cmath>

namespace pliant::cloth {
namespace {

using springs::append_ends, springs::difference, springs::length_between, springs::other_end, springs::rest_length;

// The sum over the springs of a node.
template <class Term>
Explanation sum_over_springs(const ClothSheet& sheet, Index node, std::string formula, std::string_view symbol, Term term) {
    std::vector<Input> terms;
    for (const Index s : sheet.springs_of(node))
        terms.push_back(Input::part(fmt::format("{}_{}", symbol, other_end(sheet.springs(), s, node)), "N", term(s)));
    return sum_of(std::move(formula), std::move(terms));
}

}  // namespace

Input ClothLesson::stiffness_of_spring(Index s) const {
    const std::array<const Number*, family_count> all{&k_structural, &k_shear, &k_bending};
    return Input::of(*all[sheet_->family_of(s)], "k");
}

Input ClothLesson::damping_of_spring(Index s) const {
    if (sheet_->springs().stiffness()[s] > 0) return Input::of(damping, "kᵈ");
    return Input::constant("kᵈ", 0, "N s/m", "a spring of stiffness 0 has no damper");
}

Input ClothLesson::node_mass() const {
    return Input::part(
        "m", "kg",
        {.formula = "m = M / N",
         .inputs = {Input::of(total_mass), Input::constant("N", Real(position_.cols()), "", "nodes that share the mass")}});
}

Explanation ClothLesson::why_spring_stage(const Question& q) const {
    if (q.field == "strain") return why_strain(q.index);
    if (q.field == "stretch" || q.field == "bending") return why_largest_of_node(q.index, q.field == "bending");
    return why_spring_force(q.index, q.component);
}

Explanation ClothLesson::why_spring_force(Index node, int component) const {
    return sum_over_springs(*sheet_, node, "f = Σ k (|x_ij| − l) (x_j − x_i) / |x_ij|", "f",
                            [&](Index s) { return why_spring_on_node(s, node, component); });
}

Explanation ClothLesson::why_spring_on_node(Index s, Index node, int component) const {
    const Index other = other_end(sheet_->springs(), s, node);
    const char* letter = axis_name(component);
    return {.formula = fmt::format("f_{1} = k (|x_ij| − l) ({0}_j − {0}_i) / |x_ij|", letter, other),
            .inputs = {stiffness_of_spring(s), length_between(Input::now, other, node), rest_length(sheet_->springs(), s),
                       Input::now(fmt::format("{}_j", letter), "position", other, component),
                       Input::now(fmt::format("{}_i", letter), "position", node, component)},
            .evaluate = [](std::span<const Real> x) { return (x[1] > 0 ? x[0] * (x[1] - x[2]) / x[1] : 0) * (x[3] - x[4]); }};
}

Explanation ClothLesson::why_strain(Index s) const {
    const Springs& springs = sheet_->springs();
    return {.formula = strain_[s] == 0 ? "ε = (|x_ij| − l) / l, and 0 where the difference is rounding" : "ε = (|x_ij| − l) / l",
            .inputs = {length_between(Input::now, springs.j(s), springs.i(s)), rest_length(springs, s)},
            .evaluate = [](std::span<const Real> x) {
                const Real strain = (x[0] - x[1]) / x[1];
                return std::abs(strain) < strain_rounding ? Real{0} : strain;
            }};
}

Explanation ClothLesson::why_largest_of_node(Index node, bool bent) const {
    Explanation e{.formula = bent ? "β = max(0" : "ε_s = the one farthest from 0 of (", .inputs = {}, .evaluate = {}};
    for (const Index s : sheet_->springs_of(node)) {
        if (sheet_->family_of(s) != (bent ? bending : structural)) continue;
        const std::string symbol = fmt::format("ε_{}", other_end(sheet_->springs(), s, node));
        e.formula += fmt::format("{}{}", bent ? ", − " : e.inputs.empty() ? "" : ", ", symbol);
        e.inputs.push_back(Input::now(symbol, "strain", s));
    }
    e.formula += ")";
    e.evaluate = [bent](std::span<const Real> x) {
        Real farthest = 0;
        for (const Real strain : x)
            if (bent ? -strain > farthest : std::abs(strain) > std::abs(farthest)) farthest = bent ? -strain : strain;
        return farthest;
    };
    return e;
}

// direction_at: where the directions of projected dampers are taken from.
Explanation ClothLesson::why_damping_force(Index node, int component, Reading direction_at) const {
    const bool projected = damping_mode == SpringDamping::projected;
    return sum_over_springs(*sheet_, node, projected ? "fᵈ = Σ kᵈ (v_ij · x_ij / |x_ij|²) (x_j − x_i)" : "fᵈ = Σ kᵈ (v_j − v_i)",
                            "fᵈ", [&](Index s) { return why_damper_on_node(s, node, component, direction_at); });
}

Explanation ClothLesson::why_damper_on_node(Index s, Index node, int component, Reading direction_at) const {
    const Index other = other_end(sheet_->springs(), s, node);
    const char* letter = axis_name(component);
    if (damping_mode == SpringDamping::naive)
        return {.formula = fmt::format("fᵈ_{1} = kᵈ (v{0}_j − v{0}_i)", letter, other),
                .inputs = {damping_of_spring(s), Input::now(fmt::format("v{}_j", letter), "velocity", other, component),
                           Input::now(fmt::format("v{}_i", letter), "velocity", node, component)},
                .evaluate = [](std::span<const Real> x) { return x[0] * (x[1] - x[2]); }};

    Explanation rate{
        .formula = "w = ((vx_j − vx_i) (x_j − x_i) + (vy_j − vy_i) (y_j − y_i) + (vz_j − vz_i) (z_j − z_i)) / |x_ij|²",
        .inputs = {}};
    append_ends(rate.inputs, Input::now, "velocity", "v", other, node);
    append_ends(rate.inputs, direction_at, "position", "", other, node);
    rate.inputs.push_back(length_between(direction_at, other, node));
    return {.formula = fmt::format("fᵈ_{1} = kᵈ w ({0}_j − {0}_i)", letter, other),
            .inputs = {damping_of_spring(s), Input::part("w", "1/s", std::move(rate)),
                       direction_at(fmt::format("{}_j", letter), "position", other, component),
                       direction_at(fmt::format("{}_i", letter), "position", node, component)},
            .evaluate = [](std::span<const Real> x) { return x[0] * x[1] * (x[2] - x[3]); }};
}

Explanation ClothLesson::why_external_force(Index node, int component) const {
    Explanation e{.formula = "fᵉ = 0", .inputs = {}, .evaluate = {}};
    const bool falls = component == 1 && gravity > 0;
    const bool pulled_here = pulled() && load_.pull.node == node;
    if (falls) e.inputs = {node_mass(), Input::of(gravity)};
    if (pulled_here) {
        const char* letter = axis_name(component);
        e.inputs.push_back(Input::of(pull_stiffness));
        e.inputs.push_back(
            Input::constant(fmt::format("{}_hand", letter), load_.pull.target[component], "m", "where the hand pulls to"));
        e.inputs.push_back(Input::now(letter, "position", node, component));
        e.formula = fmt::format("fᵉ = {0}kₕ ({1}_hand − {1})", falls ? "− m g + " : "", letter);
    } else if (falls) {
        e.formula = "fᵉ = − m g";
    } else if (component != 1 && gravity > 0) {
        e.formula = "fᵉ = 0: the weight acts along y";
    }
    e.evaluate = [falls, pulled_here](std::span<const Real> x) {
        const Real weight = falls ? -x[0] * x[1] : Real{0};
        const std::span<const Real> pull = x.subspan(falls ? 2 : 0);
        return pulled_here ? weight + pull[0] * (pull[1] - pull[2]) : weight;
    };
    return e;
}

}  // namespace pliant::cloth
