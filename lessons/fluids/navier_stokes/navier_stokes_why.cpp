// How each number of a step came about: the jets; what the grid's stages do is told by the parts that all flows share.
#include "navier_stokes.h"

#include <cmath>

#include <fmt/format.h>

namespace pliant::navier_stokes {
namespace {

using From = Input::From;
using Values = std::span<const Real>;

}  // namespace

flow::GridWhy NavierStokes::why_on_grid() const { return {*grid_, Input::of(dt)}; }

Explanation NavierStokes::why_force(int axis, Index face) const {
    if (why_on_grid().closed(axis, face)) return flow::kept_by_wall(axis, face);
    const Lattice<2>& faces = grid_->faces(axis);
    const GridPlace<2> place = faces.place(faces.coordinates(face));
    Explanation why{"u′ = u + Δt f", {}, {}};
    why.inputs = {flow::sample("u", From::before, flow::face_field(axis), face), Input::of(dt)};
    const auto add = [&](const std::string& symbol, const Jet& jet, Input strength, Real direction) {
        Real square = 0;
        for (int b = 0; b < 2; ++b) {
            const Real d = place[b] * dx() - jet.centre[b];
            square += d * d;
        }
        const bool reached = square <= 16 * jet.radius * jet.radius;
        why.inputs.push_back(Input::part(
            symbol, "m/s²",
            {symbol + (reached ? " = a d exp(−½ (r/ρ)²)" : " = 0 a d (r/ρ)   (nothing beyond 4 ρ)"),
             {Input::constant("r", std::sqrt(square), "m", "distance of the face from the middle of the jet"),
              Input::constant("ρ", jet.radius, "m", "radius of the jet"), std::move(strength),
              Input::constant("d", direction, "", axis == 0 ? "x of the jet's direction" : "y of the jet's direction")},
             [reached](Values x) { return reached ? x[2] * x[3] * std::exp(-0.5 * (x[0] / x[1]) * (x[0] / x[1])) : Real{0}; }}));
    };
    if (stirred()) add("f_stirrer", stirrer_jet(), Input::of(stirring, "a"), stirrer_heading()[axis]);
    if (pull_) {
        const Jet jet = hand_jet();
        const Real size = jet.acceleration.norm();
        add("f_hand", jet, Input::constant("a", size, "m/s²", "40 1/s² times the length of the pull"),
            size > 0 ? jet.acceleration[axis] / size : 0);
    }
    why.formula = stirred() && pull_ ? "u′ = u + Δt (f_stirrer + f_hand)"
                  : stirred()        ? "u′ = u + Δt f_stirrer"
                                     : "u′ = u + Δt f_hand";
    why.evaluate = [](Values x) {
        Real f = 0;
        for (std::size_t k = 2; k < x.size(); ++k) f += x[k];
        return x[0] + x[1] * f;
    };
    return why;
}

Explanation NavierStokes::why_diffused(int axis, Index face) const {
    const VecX* residual = scheme == Scheme::implicit_euler ? &diffusion_->residual(axis) : nullptr;
    return why_on_grid().diffused(viscosity, residual, axis, face);
}

std::optional<Explanation> NavierStokes::why_projection(const Question& q) const {
    const flow::GridWhy why = why_on_grid();
    if (q.field == "divergence_before") return why.divergence(q.index, From::before);
    if (q.field == "pressure") return why.pressure(q.index);
    const bool applied = projection_->converged();
    if (q.field == "divergence_after") return applied ? why.divergence(q.index, From::now) : why.remaining_divergence(q.index);
    if (!applied) return std::nullopt;
    return why.projected(flow::axis_of(q.field), q.index);
}

}  // namespace pliant::navier_stokes
