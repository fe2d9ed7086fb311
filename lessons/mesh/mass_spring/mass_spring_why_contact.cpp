// Why the nodes leave the ground as they do.
#include "mass_spring.h"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::mass_spring {
namespace {}  // namespace

// Nothing, where the stage has left the number as it was.
std::optional<Explanation> MassSpringLesson::why_contact(const Question& q) const {
    const Touch touch = contact_.touch(q.index);
    if (touch == Touch::none) return std::nullopt;
    if (q.field == "velocity") return q.component == up ? why_rebound(q.index) : why_rubbed_velocity(q.index, q.component);
    if (q.component == up) {
        if (touch != Touch::below) return std::nullopt;
        return Explanation{.formula = "y′ = max(y, 0)", .inputs = {Input::before("y", "position", q.index, up)}};
    }
    if (!semi_implicit()) return std::nullopt;
    return Explanation{
        .formula = "x′ = x + Δt (v′ − v)",
        .inputs = {Input::before("x", "position", q.index, q.component), Input::of(dt),
                   Input::now("v′", "velocity", q.index, q.component), Input::before("v", "velocity", q.index, q.component)}};
}

Explanation MassSpringLesson::why_rebound(Index node) const {
    if (!contact_.approach(node).late) return {.formula = "v_y′ = e w", .inputs = {Input::of(restitution), impact_speed(node)}};
    return {.formula = "v_y′ = max(e w + ½ Δt a_0, 0), or 0 if e w ≤ Δt a_0",
            .inputs = {Input::of(restitution), impact_speed(node), Input::of(dt), acceleration_on_ground(node)},
            .evaluate = [](std::span<const Real> x) {
                const Real w = x[0] * x[1];
                return w <= x[2] * x[3] ? 0 : std::max(w + x[2] / 2 * x[3], Real{0});
            }};
}

Input MassSpringLesson::acceleration_on_ground(Index node) const {
    return Input::constant("a_0", contact_.approach(node).acceleration_there, "m/s²",
                           "downwards, from the forces on the node where the ground has it");
}

// Coulomb's friction: it takes a part of the speed along the ground, or all of it.
Explanation MassSpringLesson::why_rubbed_velocity(Index node, int component) const {
    Explanation along{.formula = "|v_t| = √(v_x² + v_z²)",
                      .inputs = {Input::before("v_x", "velocity", node, 0), Input::before("v_z", "velocity", node, 2)}};
    return {
        .formula = "v′ = v (1 − min(1, μ max(v_y′ + u′, 0) / |v_t|))",
        .inputs = {Input::before("v", "velocity", node, component), Input::of(friction), Input::now("v_y′", "velocity", node, up),
                   free_speed(node), Input::part("|v_t|", "m/s", std::move(along))}};
}

// The speed with which a node met the ground, from what it began the step with and its acceleration on the way. Velocities of
// semi-implicit Euler are half a step late.
Input MassSpringLesson::impact_speed(Index node) const {
    const Approach& approach = contact_.approach(node);
    const Input before = Input::constant("u", approach.speed, "m/s", "downwards, when the step began"),
                height = Input::constant("h", approach.height, "m", "above the ground, when the step began");
    const Input a =
        Input::part("a", "m/s²", {.formula = "a = (u′ − u) / Δt", .inputs = {free_speed(node), before, Input::of(dt)}});
    if (!approach.late) return Input::part("w", "m/s", {.formula = "w = √(max(u² + 2 h a, 0))", .inputs = {before, height, a}});
    const Input caught_up = Input::part("s", "m/s", {.formula = "s = u + ½ Δt a", .inputs = {before, Input::of(dt), a}});
    return Input::part(
        "w", "m/s",
        {.formula = "w = √(max(s² + h (a + a_0), 0))", .inputs = {caught_up, height, a, acceleration_on_ground(node)}});
}

// Downwards, at the end of the step if there were no ground: what held the node there has taken a part of it.
Input MassSpringLesson::free_speed(Index node) const {
    const Input left = Input::before("v_y", "velocity", node, up);
    if (!implicit()) return Input::part("u′", "m/s", {.formula = "u′ = − v_y", .inputs = {left}});
    return Input::part(
        "u′", "m/s",
        {.formula = "u′ = τ R / m − v_y",
         .inputs = {
             Input::constant("τ", integrator_->impulse_time(), "s", "Δt, or what the scheme takes for it at the end of a step"),
             Input::constant("R", integrator_->solver().reaction(3 * node + up), "N", "force of the ground, from the solver"),
             node_mass(), left}});
}

}  // namespace pliant::mass_spring
