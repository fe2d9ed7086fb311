// Why strain, energy and forces are what they are: segment by segment, spring by spring.
#include "rod.h"

#include <fmt/format.h>

namespace pliant::rod {
namespace {

using Values = std::span<const Real>;

const char* letter(int component) { return axis_name(component); }

// The two coordinates of the ends of a segment: x_j, x_i, y_j, y_i.
std::vector<Input> ends_of(std::string_view field, std::string_view mark, Index j, Index i) {
    std::vector<Input> inputs;
    for (int c = 0; c < 2; ++c) {
        inputs.push_back(Input::now(fmt::format("{}{}_j", mark, letter(c)), field, j, c));
        inputs.push_back(Input::now(fmt::format("{}{}_i", mark, letter(c)), field, i, c));
    }
    return inputs;
}

Input length_between(Index j, Index i) {
    return Input::part("|x_ij|", "m", {"|x_ij| = √((x_j − x_i)² + (y_j − y_i)²)", ends_of("position", "", j, i)});
}

}  // namespace

Input RodLesson::why_segment() const { return part("Δs = L / N", {length, segments}); }

Input RodLesson::why_node_mass() const { return part("m = M / N", {total_mass, segments}); }

Input RodLesson::why_stiffness() const {
    if (by_hand()) return Input::of(picked_stiffness, "k");
    return part("k = EA / Δs", {axial_stiffness, why_segment()});
}

Input RodLesson::why_axial_stiffness() const {
    if (!by_hand()) return Input::of(axial_stiffness);
    return part("EA = k₀ Δs", {picked_stiffness, why_segment()});
}

// ---------------------------------------------------------------------------------------------- from positions to energy

Explanation RodLesson::why_slope(Index s, int component) const {
    return {fmt::format("∂{0}/∂s = ({0}_j − {0}_i) / Δs", letter(component)),
            {Input::now(fmt::format("{}_j", letter(component)), "position", s + 1, component),
             Input::now(fmt::format("{}_i", letter(component)), "position", s, component), why_segment()}};
}

Explanation RodLesson::why_strain(Index s) const {
    return {"ε = √(x_s² + y_s²) − 1", {Input::now("x_s", "slope", s, 0), Input::now("y_s", "slope", s, 1)}};
}

Explanation RodLesson::why_energy_density(Index s) const {
    return {"w = ½ EA ε²", {why_axial_stiffness(), Input::now("ε", "strain", s)}};
}

Explanation RodLesson::why_segment_energy(Index s) const {
    return {"U = w Δs", {Input::now("w", "energy_density", s), why_segment()}};
}

Explanation RodLesson::why_spring(const Question& q) const {
    if (q.field == "spring_stiffness") {
        if (by_hand()) return {"k = k₀", {Input::of(picked_stiffness)}};
        return {"k = EA / Δs", {Input::of(axial_stiffness), why_segment()}};
    }
    return {"T = k (|x_ij| − Δs)", {why_stiffness(), length_between(q.index + 1, q.index), why_segment()}};
}

// --------------------------------------------------------------------------------------------------------------- forces

// Of the segments on both sides of a node.
Explanation RodLesson::sum_over_neighbours(Index node, std::string formula, std::string_view symbol,
                                           const std::function<Explanation(Index other)>& term) const {
    std::vector<Input> terms;
    for (const Index other : {node - 1, node + 1})
        if (other >= 0 && other <= segments) terms.push_back(Input::part(fmt::format("{}_{}", symbol, other), "N", term(other)));
    return sum_of(std::move(formula), std::move(terms));
}

Explanation RodLesson::why_force(const Question& q) const {
    const char* c = letter(q.component);
    if (q.field == "gradient_force")
        return sum_over_neighbours(q.index, "−∂U/∂x_i = Σ of the segments beside", "f", [&, c](Index other) -> Explanation {
            const Index s = std::min(q.index, other);
            const Real sign = other > q.index ? 1 : -1;
            return {
                fmt::format("f_{} = {}EA ε {}_s / √(x_n² + y_n²)", other, sign > 0 ? "" : "− ", c),
                {why_axial_stiffness(), Input::now("ε", "strain", s), Input::now(fmt::format("{}_s", c), "slope", s, q.component),
                 Input::now("x_n", "slope", s, 0), Input::now("y_n", "slope", s, 1)}};
        });
    return sum_over_neighbours(q.index, "f = Σ of the springs beside", "f", [&, c](Index other) -> Explanation {
        return {fmt::format("f_{0} = k (|x_ij| − Δs) ({1}_j − {1}_i) / |x_ij|", other, c),
                {why_stiffness(), length_between(other, q.index), why_segment(),
                 Input::now(fmt::format("{}_j", c), "position", other, q.component),
                 Input::now(fmt::format("{}_i", c), "position", q.index, q.component)}};
    });
}

Explanation RodLesson::why_damping_force(Index node, int component) const {
    const char* c = letter(component);
    return sum_over_neighbours(node, "fᵈ = Σ of the dampers beside", "fᵈ", [&, c](Index other) -> Explanation {
        std::vector<Input> inputs = ends_of("velocity", "v", other, node);
        for (Input& end : ends_of("position", "", other, node)) inputs.push_back(std::move(end));
        inputs.push_back(length_between(other, node));
        Explanation rate{"w = ((vx_j − vx_i) (x_j − x_i) + (vy_j − vy_i) (y_j − y_i)) / |x_ij|²", std::move(inputs)};
        return {fmt::format("fᵈ_{0} = τ k w ({1}_j − {1}_i)", other, c),
                {Input::of(damping), why_stiffness(), Input::part("w", "1/s", std::move(rate)),
                 Input::now(fmt::format("{}_j", c), "position", other, component),
                 Input::now(fmt::format("{}_i", c), "position", node, component)}};
    });
}

Explanation RodLesson::why_external_force(Index, int component) const {
    if (component == 0) return fixed_value("fᵉ = 0: the weight acts along y", 0);
    return {"fᵉ = − m g", {why_node_mass(), Input::of(gravity)}};
}

// ---------------------------------------------------------------------------------------------------------- equilibrium

// Σ ΔT/k over the springs above a node, with ΔT = Σ f of the nodes beyond: every node's force counts once for each spring that
// it and the node hang from together.
Explanation RodLesson::why_balanced(Index node, int component) const {
    const Input before = Input::before(letter(component), "position", node, component);
    const auto kept = [](Values x) { return x[0]; };
    if (component == 0) return {"x′ = x: all forces act along the rod", {before}, kept};
    if (node == 0) return {"y′ = y: the support holds the node", {before}, kept};
    if (at_rest()) return {"y′ = y: the forces balance", {before}, kept};
    Explanation e{"y′ = y + Σ c_n (f_n + fᵉ_n) / k,  c_n = min(n, n_here)", {before, why_stiffness()}, {}};
    const bool weighty = loaded();
    for (Index n = 1; n <= segments; ++n) {
        e.inputs.push_back(Input::now(fmt::format("f_{}", n), "spring_force", n, 1));
        if (weighty) e.inputs.push_back(Input::now(fmt::format("fᵉ_{}", n), "external_force", n, 1));
    }
    const auto sum = [node, weighty](Values x) {
        Real total = 0;
        const std::size_t each = weighty ? 2 : 1;
        for (std::size_t k = 2; k < x.size(); k += each) {
            const auto n = static_cast<Index>((k - 2) / each) + 1;
            total += static_cast<Real>(std::min(n, node)) * (x[k] + (weighty ? x[k + 1] : Real{0}));
        }
        return total;
    };
    e.evaluate = [sum](Values x) { return x[0] + sum(x) / x[1]; };
    e.substitute = [sum](Values x) { return fmt::format("{} + {} / {}", as_factor(x[0]), as_factor(sum(x)), as_factor(x[1])); };
    return e;
}

Explanation RodLesson::why_displacement(Index node) const {
    const bool down = hangs();
    return {down ? "u = − y − s" : "u = x − s",
            {Input::now(down ? "y" : "x", "position", node, down ? 1 : 0),
             Input::constant("s", rest_place(node), "m", "place along the rod at rest, i Δs")},
            [down](Values x) { return (down ? -x[0] : x[0]) - x[1]; }};
}

}  // namespace pliant::rod
