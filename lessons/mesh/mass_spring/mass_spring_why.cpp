// Why forces and motion are what they are: each spring, damper and load of a node, the integrators, the ground.
#include "kits/schemes/scheme_why.h"
#include "mass_spring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {
namespace {

using springs::Reading, springs::length_between, springs::rest_length;

// ------------------------------------------------------------------------------------------------------------- forces

Explanation why_spring_force(const MassSpringLesson& l, Index node, int component) {
    const Springs& springs = l.block_->springs();
    return springs::sum_over_springs(
        springs, node, "f", "f_j = k (|x_ij| − l) (x_j − x_i) / |x_ij|", "f", [&](Index s, Index other) {
            const bool apart = l.position_.col(other) != l.position_.col(node);
            return springs::spring_on_node(l.stiffness_of_spring(s), rest_length(springs, s), apart, other, node, component);
        });
}

Explanation why_tension(const MassSpringLesson& l, Index s) {
    const Springs& springs = l.block_->springs();
    const bool rounded = l.tension_[s] == 0 && springs.rest_length()[s] > 0;
    return {rounded ? "T = k (|x_ij| − l), and 0 where the difference is rounding" : "T = k (|x_ij| − l)",
            {l.stiffness_of_spring(s), length_between(Input::now, springs.j(s), springs.i(s)), rest_length(springs, s)}};
}

// direction_at: where the directions of projected dampers are taken from.
Explanation why_damping_force(const MassSpringLesson& l, Index node, int component, Reading direction_at) {
    const bool projected = l.damping_mode == SpringDamping::projected;
    return springs::sum_over_springs(
        l.block_->springs(), node, "fᵈ", projected ? "fᵈ_j = kᵈ (v_ij · x_ij / |x_ij|²) (x_j − x_i)" : "fᵈ_j = kᵈ (v_j − v_i)",
        "fᵈ", [&](Index, Index other) {
            return springs::damper_on_node({l.damping}, projected, other, node, component, direction_at);
        });
}

Explanation why_external_force(const MassSpringLesson& l, Index node, int component) {
    return springs::load_on_node(l.load_, l.node_mass(), l.gravity, l.pull_stiffness, node, component);
}

// ------------------------------------------------------------------------------------------------------- integration

// Of the start of the step.
std::vector<Input> forces_on(const MassSpringLesson& l, Index node, int component) {
    std::vector<Input> forces{Input::now("f", "spring_force", node, component)};
    if (l.damped()) forces.push_back(Input::now("fᵈ", "damping_force", node, component));
    if (l.loaded()) forces.push_back(Input::now("fᵉ", "external_force", node, component));
    return forces;
}

// Of the end of the step, with the ground's, and what Newton's method has left unbalanced.
std::vector<Input> balanced_forces_on(const MassSpringLesson& l, Index node, int component) {
    const ImplicitSolver& solver = l.integrator_->solver();
    const Index dof = 3 * node + component;
    std::vector<Input> forces{Input::part("f(x′)", "N", why_spring_force(l, node, component))};
    if (l.damped()) forces.push_back(Input::part("fᵈ(v′)", "N", why_damping_force(l, node, component, Input::before)));
    if (l.loaded()) forces.push_back(Input::part("fᵉ(x′)", "N", why_external_force(l, node, component)));
    if (l.grounded() && component == up)
        forces.push_back(Input::constant("R", solver.reaction(dof), "N", "force of the ground, from the solver"));
    VecX imbalance;
    solver.imbalance(imbalance);
    forces.push_back(stepping::imbalance_left(imbalance[dof]));
    return forces;
}

// The end of a step of Newmark's scheme, of the midpoint rule or of BDF2, from the acceleration that Newton's method has found.
Explanation why_second_order(const MassSpringLesson& l, const Question& q) {
    const Index dof = 3 * q.index + q.component;
    const ImplicitSolver& solver = l.integrator_->solver();
    const ImplicitForm& form = solver.form();
    const bool of_velocity = q.field == "velocity";
    const Input x = Input::before("x", "position", q.index, q.component),
                v = Input::before("v", "velocity", q.index, q.component),
                x_new = Input::now("x′", "position", q.index, q.component);
    const auto acceleration = [&](std::string symbol, std::string where) {
        return Input::constant(std::move(symbol),
                               form.acceleration_rate * (solver.position()[dof] - form.acceleration_origin[dof]), "m/s²",
                               "(f + R)/m " + where + ", from Newton's method");
    };
    if (l.integrator == Scheme::bdf2) {
        const Input h = Input::constant("h", 1 / form.velocity_rate, "s", "Δt (1 + r)/(1 + 2r), r = Δt over the step before"),
                    x_o = Input::constant("x_o", form.velocity_origin[dof], "m", "((1 + r)² x − r² x of before)/(1 + 2r)");
        if (of_velocity) return {"v′ = (x′ − x_o) / h", {x_new, x_o, h}};
        const Real moved = form.acceleration_origin[dof] - form.velocity_origin[dof];
        return {"x′ = x_o + d_o + h² a′",
                {x_o, Input::constant("d_o", moved, "m", "h ((1 + r)² v − r² v of before)/(1 + 2r)"), h,
                 acceleration("a′", "at the end of the step")}};
    }
    if (of_velocity) return {"v′ = 2 (x′ − x) / Δt − v", {x_new, x, l.dt, v}};
    if (l.integrator == Scheme::implicit_midpoint)
        return {"x′ = x + Δt v + ½ Δt² a_m", {x, l.dt, v, acceleration("a_m", "in the middle of the step")}};
    return {"x′ = x + Δt v + ¼ Δt² (a + a′)",
            {x, l.dt, v, Input::constant("a", l.integrator_->acceleration(0)[dof], "m/s²", "f/m at the start of the step"),
             acceleration("a′", "at the end of the step")}};
}

// Of an iterate of Newton's method: the velocity that the scheme gives to a place.
Explanation why_iterate_velocity(const MassSpringLesson& l, Index node, int component) {
    const ImplicitForm& form = l.integrator_->solver().form();
    const Input reached = Input::now("x′", "position", node, component);
    if (l.implicit_euler()) return {"v′ = (x′ − x) / Δt", {reached, Input::before("x", "position", node, component), l.dt}};
    return {"v′ = r (x′ − x_o)",
            {Input::constant("r", form.velocity_rate, "1/s", "of the scheme"), reached,
             Input::constant("x_o", form.velocity_origin[3 * node + component], "m",
                             "the place at which the scheme's velocity is 0")}};
}

// Where Newton's method started in this step.
Input newton_start(const MassSpringLesson& l, Index node, int component, const std::optional<Input>& bound) {
    const ImplicitSolver& solver = l.integrator_->solver();
    const Index dof = 3 * node + component;
    if (!l.implicit_euler()) {
        Real start = solver.began_at_prediction() ? solver.form().acceleration_origin[dof] : l.contact_.start().data()[dof];
        if (solver.form().lower_bound.size() > 0) start = std::max(start, solver.form().lower_bound[dof]);
        return Input::constant("x_k", start, "m", "where Newton's method begins: as if no force changed, or where the node is");
    }
    const Input x = Input::before("x", "position", node, component), v = Input::before("v", "velocity", node, component);
    if (!solver.began_at_prediction()) return part("x_k = x", {x});
    return bound ? part("x_k = max(x + Δt v, b)", {x, l.dt, v, *bound}) : part("x_k = x + Δt v", {x, l.dt, v});
}

// One Newton iteration: the iterate before it, and the direction.
Explanation why_newton_position(const MassSpringLesson& l, Index node, int component) {
    const ImplicitSolver& solver = l.integrator_->solver();
    const Index dof = 3 * node + component;
    const VecX& lower = solver.form().lower_bound;
    std::optional<Input> bound;
    if (lower.size() > 0 && std::isfinite(lower[dof]))
        bound = Input::constant("b", lower[dof], "m", "the ground, or the node itself if below");
    const Input iterate =
        solver.iterations() == 1 ? newton_start(l, node, component, bound) : Input::earlier("x_k", "position", node, component);
    return stepping::newton_iterate("x′", "x", solver, dof, iterate, stepping::newton_direction(solver, dof), bound);
}

// ------------------------------------------------------------------------------------------------------------- ground

// Downwards, at the end of the step if there were no ground: what held the node there has taken a part of it.
Input free_speed(const MassSpringLesson& l, Index node) {
    const Input left = Input::before("v_y", "velocity", node, up);
    if (!l.implicit()) return part("u′ = − v_y", {left});
    return part(
        "u′ = τ R / m − v_y",
        {Input::constant("τ", l.integrator_->impulse_time(), "s", "Δt, or what the scheme takes for it at the end of a step"),
         Input::constant("R", l.integrator_->solver().reaction(3 * node + up), "N", "force of the ground, from the solver"),
         l.node_mass(), left});
}

Input acceleration_on_ground(const MassSpringLesson& l, Index node) {
    return Input::constant("a_0", l.contact_.approach(node).acceleration_there, "m/s²",
                           "downwards, from the forces on the node where the ground has it");
}

// The speed with which a node met the ground, from what it began the step with and its acceleration on the way. Velocities of
// semi-implicit Euler are half a step late.
Input impact_speed(const MassSpringLesson& l, Index node) {
    const Approach& approach = l.contact_.approach(node);
    const Input before = Input::constant("u", approach.speed, "m/s", "downwards, when the step began"),
                height = Input::constant("h", approach.height, "m", "above the ground, when the step began"),
                a = part("a = (u′ − u) / Δt", {free_speed(l, node), before, l.dt});
    if (!approach.late) return part("w = √(max(u² + 2 h a, 0))", {before, height, a});
    return part("w = √(max(s² + h (a + a_0), 0))",
                {part("s = u + ½ Δt a", {before, l.dt, a}), height, a, acceleration_on_ground(l, node)});
}

Explanation why_rebound(const MassSpringLesson& l, Index node) {
    if (!l.contact_.approach(node).late) return {"v_y′ = e w", {l.restitution, impact_speed(l, node)}};
    return Explanation{"v_y′ = rebound(e w, Δt a_0), max(e w + ½ Δt a_0, 0), and 0 where e w ≤ Δt a_0",
                       {l.restitution, impact_speed(l, node), l.dt, acceleration_on_ground(l, node)}}
        .by("rebound", "m/s", [](Values x) { return x[0] <= x[1] ? 0 : std::max(x[0] + x[1] / 2, Real{0}); });
}

// Coulomb's friction: it takes a part of the speed along the ground, or all of it.
Explanation why_rubbed_velocity(const MassSpringLesson& l, Index node, int component) {
    return {
        "v′ = v (1 − min(1, μ max(v_y′ + u′, 0) / |v_t|))",
        {Input::before("v", "velocity", node, component), l.friction, Input::now("v_y′", "velocity", node, up),
         free_speed(l, node),
         part("|v_t| = √(v_x² + v_z²)", {Input::before("v_x", "velocity", node, 0), Input::before("v_z", "velocity", node, 2)})}};
}

}  // namespace

Input MassSpringLesson::stiffness_of_spring(Index s) const {
    return Input::of(s < block_->last(structural) ? k_structural : s < block_->last(shear) ? k_shear : k_bending, "k");
}

Explanation MassSpringLesson::why_force(const Question& q) const {
    if (q.field == "tension") return why_tension(*this, q.index);
    if (q.field == "damping_force") return why_damping_force(*this, q.index, q.component, Input::now);
    if (q.field == "external_force") return why_external_force(*this, q.index, q.component);
    if (q.field == "spring_force") return why_spring_force(*this, q.index, q.component);
    if (block_->springs().rest_length()[q.index] == 0) return fixed_value("ε = 0: a spring of rest length 0 has no strain");
    return springs::strain_of(block_->springs(), q.index, strain_[q.index]);
}

Explanation MassSpringLesson::why_integrated(const Question& q) const {
    const bool of_velocity = q.field == "velocity";
    const Input x = Input::before("x", "position", q.index, q.component),
                v = Input::before("v", "velocity", q.index, q.component);
    if (block_->inertia().fixed(3 * q.index)) {
        if (of_velocity) return {"v′ = v: the support holds the node", {v}};
        return stepping::drifted(dt, q.index, q.component, false);
    }
    if (semi_implicit() || integrator == Scheme::explicit_euler)
        return of_velocity ? stepping::pushed(v, dt, node_mass(), forces_on(*this, q.index, q.component))
                           : stepping::drifted(dt, q.index, q.component, semi_implicit());
    if (!implicit())
        return stepping::table_row(of_velocity ? "v′" : "x′", *integrator_, of_velocity, 3 * q.index + q.component, x, v, dt,
                                   stepping::first_acceleration(node_mass(), forces_on(*this, q.index, q.component)));
    if (!integrator_->solver().converged())
        return of_velocity ? why_iterate_velocity(*this, q.index, q.component) : why_newton_position(*this, q.index, q.component);
    if (!implicit_euler()) return why_second_order(*this, q);
    return of_velocity ? stepping::pushed(v, dt, node_mass(), balanced_forces_on(*this, q.index, q.component))
                       : stepping::drifted(dt, q.index, q.component, true);
}

// Nothing, where the stage has left the number as it was.
std::optional<Explanation> MassSpringLesson::why_contact(const Question& q) const {
    const Touch touch = contact_.touch(q.index);
    if (touch == Touch::none) return std::nullopt;
    if (q.field == "velocity")
        return q.component == up ? why_rebound(*this, q.index) : why_rubbed_velocity(*this, q.index, q.component);
    if (q.component == up) {
        if (touch != Touch::below) return std::nullopt;
        return Explanation{"y′ = max(y, 0)", {Input::before("y", "position", q.index, up)}};
    }
    if (!semi_implicit()) return std::nullopt;
    return Explanation{
        "x′ = x + Δt (v′ − v)",
        {Input::before("x", "position", q.index, q.component), dt, Input::now("v′", "velocity", q.index, q.component),
         Input::before("v", "velocity", q.index, q.component)}};
}

}  // namespace pliant::mass_spring
