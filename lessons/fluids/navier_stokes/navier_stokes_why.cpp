// How each number of a step came about: the forces and the smoke; what the grid's stages do is told by the parts that all flows
// share.
#include "navier_stokes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pliant::navier_stokes {
namespace {

using From = Input::From;
using Values = std::span<const Real>;

}  // namespace

flow::GridWhy NavierStokes::why_on_grid() const { return {*grid_, Input::of(dt)}; }

// The acceleration by a jet along an axis at a face.
Input NavierStokes::why_jet(const std::string& symbol, const Jet& jet, Input strength, Real direction, int axis,
                            Index face) const {
    const Lattice<2>& faces = grid_->faces(axis);
    const GridPlace<2> place = faces.place(faces.coordinates(face));
    Real square = 0;
    for (int b = 0; b < 2; ++b) {
        Real d = place[static_cast<std::size_t>(b)] * dx() - jet.centre[b];
        const Real period = static_cast<Real>(grid_->cell_counts()[static_cast<std::size_t>(b)]) * dx();
        if (grid_->periodic(b)) d -= period * std::round(d / period);
        square += d * d;
    }
    const bool reached = square <= 16 * jet.radius * jet.radius;
    return Input::part(
        symbol, "m/s²",
        {symbol + (reached ? " = a d exp(−½ (r/ρ)²)" : " = 0 a d (r/ρ)   (nothing beyond 4 ρ)"),
         {Input::constant("r", std::sqrt(square), "m", "distance of the face from the middle of the jet"),
          Input::constant("ρ", jet.radius, "m", "radius of the jet"), std::move(strength),
          Input::constant("d", direction, "", axis == 0 ? "x of the jet's direction" : "y of the jet's direction")},
         [reached](Values x) { return reached ? x[2] * x[3] * std::exp(-0.5 * (x[0] / x[1]) * (x[0] / x[1])) : Real{0}; }});
}

Input NavierStokes::why_buoyancy(Index face) const {
    return Input::part("f_smoke", "m/s²",
                       {"f_smoke = β ½ (s_below + s_above)",
                        {Input::of(buoyancy), flow::sample("s_below", From::before, "smoke", grid_->cell_beside(1, face, 0)),
                         flow::sample("s_above", From::before, "smoke", grid_->cell_beside(1, face, 1))}});
}

Explanation NavierStokes::why_force(int axis, Index face) const {
    if (why_on_grid().closed(axis, face)) return flow::kept_by_wall(axis, face);
    Explanation why{"", {flow::sample("u", From::before, flow::face_field(axis), face), Input::of(dt)}, {}};
    if (stirred())
        why.inputs.push_back(why_jet("f_stirrer", stirrer_jet(force_time_), Input::of(stirring, "a"),
                                     stirrer_heading(force_time_)[axis], axis, face));
    if (axis == 0 && scene().drives.body_force) why.inputs.push_back(Input::of(body_force));
    if (axis == 1 && scene().drives.smoke) why.inputs.push_back(why_buoyancy(face));
    if (pull_) {
        const Jet jet = hand_jet();
        const Real strength = jet.acceleration.norm();
        why.inputs.push_back(why_jet("f_hand", jet,
                                     Input::constant("a", strength, "m/s²", "40 1/s² times the length of the pull"),
                                     strength > 0 ? jet.acceleration[axis] / strength : 0, axis, face));
    }
    std::string sum;
    for (std::size_t k = 2; k < why.inputs.size(); ++k) sum += (k > 2 ? " + " : "") + why.inputs[k].symbol;
    if (sum.empty()) {
        // No force of the scene acts along this axis.
        why.inputs.pop_back();
        why.formula = "u′ = u   (no force along this axis)";
        why.evaluate = [](Values x) { return x[0]; };
        why.substitute = [](Values x) { return fmt::format("{:.6g}", x[0]); };
        return why;
    }
    why.formula = why.inputs.size() > 3 ? "u′ = u + Δt (" + sum + ")" : "u′ = u + Δt " + sum;
    why.evaluate = [](Values x) {
        Real f = 0;
        for (std::size_t k = 2; k < x.size(); ++k) f += x[k];
        return x[0] + x[1] * f;
    };
    return why;
}

Explanation NavierStokes::why_diffused(int axis, Index face) const {
    const VecX* residual = scheme == Scheme::implicit_euler ? &diffusion_->residual(axis) : nullptr;
    return why_on_grid().diffused(nu_input(), residual, axis, face);
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

Explanation NavierStokes::why_smoke(Index cell) const {
    if (std::ranges::binary_search(source_cells_, cell)) return fixed_value("s = 1   (a cell of the source)", 1);
    return why_advected().quantity("smoke", cell);
}

}  // namespace pliant::navier_stokes
