// Why the nodes leave the ground as they do.
#include "mass_spring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {
namespace {}  // namespace

// Nothing, where the stage has left the number as it was.
std::optional<Explanation> MassSpringLesson::why_contact(const Question& q) const {
    const Touch touch = touches_[static_cast<std::size_t>(q.index)];
    if (touch == Touch::none) return std::nullopt;
    if (q.field == "velocity") return q.component == up ? why_rebound(q.index) : why_rubbed_velocity(q.index, q.component);
    if (q.component == up) {
        if (touch != Touch::below) return std::nullopt;
        return Explanation{.formula = "y′ = max(y, 0)",
                           .inputs = {Input::before("y", "position", q.index, up)},
                           .evaluate = [](std::span<const Real> x) { return std::max(x[0], Real{0}); }};
    }
    if (!semi_implicit()) return std::nullopt;
    return Explanation{
        .formula = "x′ = x + Δt (v′ − v)",
        .inputs = {Input::before("x", "position", q.index, q.component), Input::of(dt),
                   Input::now("v′", "velocity", q.index, q.component), Input::before("v", "velocity", q.index, q.component)},
        .evaluate = [](std::span<const Real> x) { return x[0] + x[1] * (x[2] - x[3]); }};
}

Explanation MassSpringLesson::why_rebound(Index node) const {
    return {.formula = "v_y′ = max(v_y, 0) + e w",
            .inputs = {Input::before("v_y", "velocity", node, up), Input::of(restitution), impact_speed(node)},
            .evaluate = [](std::span<const Real> x) { return std::max(x[0], Real{0}) + x[1] * x[2]; }};
}

// Coulomb's friction: it takes a part of the speed along the ground, or all of it.
Explanation MassSpringLesson::why_rubbed_velocity(Index node, int component) const {
    Explanation along{.formula = "|v_t| = √(v_x² + v_z²)",
                      .inputs = {Input::before("v_x", "velocity", node, 0), Input::before("v_z", "velocity", node, 2)},
                      .evaluate = [](std::span<const Real> x) { return std::hypot(x[0], x[1]); }};
    return {.formula = "v′ = v (1 − min(1, μ (1 + e) w / |v_t|))",
            .inputs = {Input::before("v", "velocity", node, component), Input::of(friction), Input::of(restitution),
                       impact_speed(node), Input::part("|v_t|", "m/s", std::move(along))},
            .evaluate = [](std::span<const Real> x) {
                const Real taken = x[4] > 0 ? std::min(Real{1}, x[1] * (1 + x[2]) * x[3] / x[4]) : 1;
                return x[0] * (1 - taken);
            }};
}

// The speed with which a node met the ground: that with which it went below, and what held it there has already taken.
Input MassSpringLesson::impact_speed(Index node) const {
    const bool below = touches_[static_cast<std::size_t>(node)] == Touch::below;
    std::string formula = below ? "w = max(− v_y, 0)" : "w = ";
    std::vector<Input> inputs;
    if (below) inputs.push_back(Input::before("v_y", "velocity", node, up));
    if (implicit()) {
        formula += below ? " + h R / m" : "h R / m";
        inputs.push_back(Input::constant("h", arrested_time(), "s", "Δt, or what the scheme takes for it at the end of a step"));
        inputs.push_back(
            Input::constant("R", integrator_->solver().reaction(3 * node + up), "N", "force of the ground, from the solver"));
        inputs.push_back(node_mass());
    }
    return Input::part("w", "m/s",
                       {.formula = std::move(formula), .inputs = std::move(inputs), .evaluate = [below](std::span<const Real> x) {
                            const Real down = below ? std::max(-x[0], Real{0}) : Real{0};
                            const std::span<const Real> held = x.subspan(below ? 1 : 0);
                            return held.empty() ? down : down + held[0] * held[1] / held[2];
                        }});
}

}  // namespace pliant::mass_spring
