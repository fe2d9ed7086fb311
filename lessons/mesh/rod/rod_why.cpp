// Why strain, energy, forces and motion are what they are: segment by segment, spring by spring; one row of an explicit scheme's
// table, or the equations of an implicit one.
#include "kits/schemes/scheme_why.h"
#include "rod.h"

#include <fmt/format.h>

namespace pliant::rod {
namespace {

// -------------------------------------------------------------------------------------------------------------- forces

Explanation why_gradient_force(const RodLesson& l, const Question& q) {
    const char* c = axis_name(q.component);
    return springs::sum_over_springs(
        l.springs_, q.index, "−∂U/∂x_i", "of the segments beside", "f", [&, c](Index s, Index other) -> Explanation {
            return {fmt::format("f_{} = {}EA ε {}_s / √(x_n² + y_n²)", other, other > q.index ? "" : "− ", c),
                    {l.why_axial_stiffness(), Input::now("ε", "strain", s),
                     Input::now(fmt::format("{}_s", c), "slope", s, q.component), Input::now("x_n", "slope", s, 0),
                     Input::now("y_n", "slope", s, 1)}};
        });
}

Explanation why_spring_force(const RodLesson& l, const Question& q) {
    return springs::sum_over_springs(l.springs_, q.index, "f", "of the springs beside", "f", [&](Index, Index other) {
        return springs::spring_on_node(l.why_stiffness(), l.why_segment(), l.position_.col(other) != l.position_.col(q.index),
                                       other, q.index, q.component, 2);
    });
}

Explanation why_damping_force(const RodLesson& l, const Question& q) {
    return springs::sum_over_springs(l.springs_, q.index, "fᵈ", "of the dampers beside", "fᵈ", [&](Index, Index other) {
        return springs::damper_on_node({l.damping, l.why_stiffness()}, true, other, q.index, q.component, Input::now, 2);
    });
}

// --------------------------------------------------------------------------------------------------------- equilibrium

// Σ ΔT/k over the springs above a node, with ΔT = Σ f of the nodes beyond: every node's force counts once for each spring that
// it and the node hang from together.
Explanation why_balanced(const RodLesson& l, Index node, int component) {
    const Input before = Input::before(axis_name(component), "position", node, component);
    if (component == 0) return {"x′ = x: all forces act along the rod", {before}};
    if (node == 0) return {"y′ = y: the support holds the node", {before}};
    if (l.at_rest()) return {"y′ = y: the forces balance", {before}};
    const bool weighty = l.loaded();
    Explanation e{
        weighty ? "y′ = y + Σ_n c_n (f_n + fᵉ_n) / k, c_n = min(n, n_here)" : "y′ = y + Σ_n c_n f_n / k, c_n = min(n, n_here)",
        {before, l.why_stiffness()}};
    for (Index n = 1; n <= l.segments; ++n) {
        e.inputs.push_back(
            Input::constant(fmt::format("c_{}", n), static_cast<Real>(std::min(n, node)), "", "springs that both nodes hang from")
                .in("c_n"));
        e.inputs.push_back(Input::now(fmt::format("f_{}", n), "spring_force", n, 1).in("f_n"));
        if (weighty) e.inputs.push_back(Input::now(fmt::format("fᵉ_{}", n), "external_force", n, 1).in("fᵉ_n"));
    }
    return e;
}

// -------------------------------------------------------------------------------------------------------------- motion

std::vector<Input> forces_on(const RodLesson& l, const Question& q) {
    std::vector<Input> forces{Input::now("f", "spring_force", q.index, q.component)};
    if (l.damped()) forces.push_back(Input::now("fᵈ", "damping_force", q.index, q.component));
    if (l.loaded()) forces.push_back(Input::now("fᵉ", "external_force", q.index, q.component));
    return forces;
}

// The place that an implicit scheme solves for, called `symbol`: that of the end, or of the middle of the step.
Explanation why_solution(const RodLesson& l, Index dof, std::string_view symbol) {
    ImplicitSolver& solver = l.integrator_->solver();
    VecX force(l.position_.size()), imbalance;
    solver.imbalance(imbalance);
    l.system_->force(solver.position(), solver.velocity(), force);
    return {fmt::format("{} = o + (F + r) / (m ρ²)", symbol),
            {Input::constant("o", solver.form().acceleration_origin[dof], "m", "where the node would be without forces"),
             Input::constant("F", force[dof], "N", "force of springs, dampers and weight there"),
             stepping::imbalance_left(imbalance[dof]), l.why_node_mass(),
             Input::constant("ρ²", solver.form().acceleration_rate, "1/s²", "of the scheme: 1/Δt² for implicit Euler")}};
}

Explanation why_solved(const RodLesson& l, const Question& q, const Input& before) {
    const Index dof = 2 * q.index + q.component;
    const bool middle = l.scheme == Scheme::implicit_midpoint;
    const Input z = Input::part("z", "m", why_solution(l, dof, "z"));
    if (q.field == "position") return middle ? Explanation{"x′ = 2 z − x", {z, before}} : why_solution(l, dof, "x′");
    const ImplicitForm& form = l.integrator_->solver().form();
    const Input rate = Input::constant("ρ", form.velocity_rate, "1/s", "of the scheme: 1/Δt for implicit Euler"),
                origin = Input::constant("o", form.velocity_origin[dof], "m", "of the scheme: x for implicit Euler");
    if (middle) return {"v′ = 2 v_m − v", {part("v_m = ρ (z − o)", {rate, z, origin}), before}};
    return {"v′ = ρ (x′ − o)", {rate, Input::now("x′", "position", q.index, q.component), origin}};
}

}  // namespace

Input RodLesson::why_stiffness() const {
    return by_hand() ? Input::of(picked_stiffness, "k") : part("k = EA / Δs", {axial_stiffness, why_segment()});
}

Input RodLesson::why_axial_stiffness() const {
    return by_hand() ? part("EA = k₀ Δs", {picked_stiffness, why_segment()}) : axial_stiffness;
}

Explanation RodLesson::why_field(const Question& q) const {
    const Index s = q.index;
    const char* c = axis_name(q.component);
    if (q.field == "slope")
        return {fmt::format("∂{0}/∂s = ({0}_j − {0}_i) / Δs", c),
                {Input::now(fmt::format("{}_j", c), "position", s + 1, q.component),
                 Input::now(fmt::format("{}_i", c), "position", s, q.component), why_segment()}};
    if (q.field == "strain")
        return {"ε = √(x_s² + y_s²) − 1", {Input::now("x_s", "slope", s, 0), Input::now("y_s", "slope", s, 1)}};
    if (q.field == "energy_density") return {"w = ½ EA ε²", {why_axial_stiffness(), Input::now("ε", "strain", s)}};
    if (q.field == "segment_energy") return {"U = w Δs", {Input::now("w", "energy_density", s), why_segment()}};
    if (q.field == "spring_stiffness")
        return by_hand() ? Explanation{"k = k₀", {picked_stiffness}}
                         : Explanation{"k = EA / Δs", {axial_stiffness, why_segment()}};
    if (q.field == "tension")
        return {"T = k (|x_ij| − Δs)", {why_stiffness(), springs::length_between(Input::now, s + 1, s, 2), why_segment()}};
    if (q.field == "gradient_force") return why_gradient_force(*this, q);
    if (q.field == "spring_force") return why_spring_force(*this, q);
    if (q.field == "damping_force") return why_damping_force(*this, q);
    if (q.field == "external_force") {
        if (q.component == 0) return fixed_value("fᵉ = 0: the weight acts along y");
        return {"fᵉ = − m g", {why_node_mass(), gravity}};
    }
    if (q.field == "displacement")
        return {hangs() ? "u = − y − s" : "u = x − s",
                {Input::now(hangs() ? "y" : "x", "position", q.index, hangs() ? 1 : 0),
                 Input::constant("s", rest_place(q.index), "m", "place along the rod at rest, i Δs")}};
    return why_balanced(*this, q.index, q.component);
}

std::optional<Explanation> RodLesson::why_integrated(const Question& q) const {
    const bool of_velocity = q.field == "velocity";
    const Input before = Input::before(of_velocity ? "v" : "x", q.field, q.index, q.component);
    if (inertia_.fixed(2 * q.index))
        return Explanation{of_velocity ? "v′ = v: the support holds the node" : "x′ = x: the support holds the node", {before}};
    if (!is_implicit(scheme))
        return stepping::table_row(of_velocity ? "v′" : "x′", *integrator_, of_velocity, 2 * q.index + q.component, before,
                                   Input::before("v", "velocity", q.index, q.component), dt,
                                   stepping::first_acceleration(why_node_mass(), forces_on(*this, q)));
    // The iterates stay with the solver; what it found is written at the end.
    if (integrator_->again()) return std::nullopt;
    return why_solved(*this, q, before);
}

}  // namespace pliant::rod
