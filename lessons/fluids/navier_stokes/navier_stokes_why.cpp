// How each number of a step came about: the forces and the smoke; what the grid's stages do is told by the parts that all flows
// share.
#include "navier_stokes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::navier_stokes {
namespace {

using From = Input::From;

}  // namespace

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
          Input::constant("d", direction, "", axis == 0 ? "x of the jet's direction" : "y of the jet's direction")}});
}

Explanation NavierStokes::why_force(int axis, Index face) const {
    if (why_on_grid().closed(axis, face)) return grid2d::kept_by_wall(axis, face);
    Explanation why{"", {grid2d::sample("u", From::before, grid2d::face_field(axis), face), dt}};
    if (stirred())
        why.inputs.push_back(why_jet("f_stirrer", stirrer_jet(force_time_), Input::of(stirring, "a"),
                                     stirrer_heading(force_time_)[axis], axis, face));
    if (axis == 0 && scene().drives.body_force) why.inputs.push_back(body_force);
    if (axis == 1 && scene().drives.smoke)
        why.inputs.push_back(part("f_smoke = β ½ (s_below + s_above)",
                                  {buoyancy, grid2d::sample("s_below", From::before, "smoke", grid_->cell_beside(1, face, 0)),
                                   grid2d::sample("s_above", From::before, "smoke", grid_->cell_beside(1, face, 1))}));
    if (pull_) {
        const Jet jet = hand_jet();
        const Real strength = jet.acceleration.norm();
        why.inputs.push_back(why_jet("f_hand", jet,
                                     Input::constant("a", strength, "m/s²", "40 1/s² times the length of the pull"),
                                     strength > 0 ? jet.acceleration[axis] / strength : 0, axis, face));
    }
    if (why.inputs.size() == 2) return {"u′ = u   (no force along this axis)", {why.inputs.front()}};
    std::string sum;
    for (std::size_t k = 2; k < why.inputs.size(); ++k) sum += (k > 2 ? " + " : "") + why.inputs[k].symbol;
    why.formula = why.inputs.size() > 3 ? "u′ = u + Δt (" + sum + ")" : "u′ = u + Δt " + sum;
    return why;
}

// -------------------------------------------------------------------------------------------------------------- probes

Explanation NavierStokes::why_max_speed() const {
    const int axis = velocity_[0].lpNorm<Eigen::Infinity>() >= velocity_[1].lpNorm<Eigen::Infinity>() ? 0 : 1;
    Index face = 0;
    velocity_[axis].cwiseAbs().maxCoeff(&face);
    return {fmt::format("max|u| = |u_face|   (largest of all faces: number {} across {})", face, axis == 0 ? "x" : "y"),
            {grid2d::sample("u_face", From::now, grid2d::face_field(axis), face)}};
}

Explanation NavierStokes::why_reynolds() const {
    if (scene().reynolds_length == 0)
        return {"Re = U L / ν   (U: the fastest fluid)", {Input::now("U", "max_speed", 0), size, nu_input()}};
    return {"Re = |U| l L / ν", {speed_parameter(), reynolds_length_input(), size, nu_input()}};
}

// The velocity on a line through the middle, from the samples around the place, beside what is expected there.
Explanation NavierStokes::why_difference(const Difference& d, const std::string& expected) const {
    const std::string meaning = expected == "u_table"
                                    ? fmt::format("published, at {} = {:.6g} m", d.axis == 0 ? "y" : "x", d.along)
                                    : fmt::format("closed form at y = {:.6g} m", d.along);
    return {fmt::format("|Δu| = |u_line − {}|   (where it is largest)", expected),
            {Input::part("u_line", "m/s",
                         grid2d::interpolated("u_line", grid_->faces(d.axis), grid2d::face_field(d.axis),
                                              place_on_centre_line(d.axis, d.along), From::now,
                                              "the samples around the place on the line")),
             Input::constant(expected, d.expected, "m/s", meaning)}};
}

}  // namespace pliant::navier_stokes
