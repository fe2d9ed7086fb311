// How the readings of the probes follow from the fields.
#include "navier_stokes.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace pliant::navier_stokes {
namespace {

using From = Input::From;
using Values = std::span<const Real>;
using std::numbers::pi;

Explanation difference_of(Input measured, Input expected) {
    std::string formula = fmt::format("|Δu| = |{} − {}|   (where it is largest)", measured.symbol, expected.symbol);
    return {std::move(formula), {std::move(measured), std::move(expected)}, [](Values x) { return std::abs(x[0] - x[1]); }};
}

}  // namespace

Explanation NavierStokes::why_strouhal() const {
    const Input length =
        Input::part("D", "m",
                    {"D = d L",
                     {Input::constant("d", scene().obstacle, "", "diameter of the disc in units of L"), Input::of(size)},
                     [](Values x) { return x[0] * x[1]; }});
    return {"St = D / (U T)",
            {length, Input::of(inflow), Input::constant("T", *wake_.period(), "s", "mean of the latest periods of the wake's v")},
            [](Values x) { return x[0] / (x[1] * x[2]); }};
}

Explanation NavierStokes::why_effective_viscosity() const {
    return {
        "ν_eff = −ln(e / e₀) L² / (16 π² t)",
        {Input::now("e", "kinetic_energy", 0), Input::constant("e₀", initial_energy_, "J/kg", "at the start"), Input::of(size),
         Input::constant("π", pi, "", "3.14159…"), Input::constant("t", time(), "s", "time since the start")}};
}

Explanation NavierStokes::why_max_speed() const {
    const int axis = velocity_[0].lpNorm<Eigen::Infinity>() >= velocity_[1].lpNorm<Eigen::Infinity>() ? 0 : 1;
    Index face = 0;
    velocity_[axis].cwiseAbs().maxCoeff(&face);
    return {fmt::format("max|u| = |u_face|   (largest of all faces: number {} across {})", face, axis == 0 ? "x" : "y"),
            {flow::sample("u_face", From::now, flow::face_field(axis), face)}};
}

Explanation NavierStokes::why_reynolds() const {
    const Real length = scene().reynolds_length;
    if (length == 0)
        return {"Re = U L / ν   (U: the fastest fluid)", {Input::now("U", "max_speed", 0), Input::of(size), nu_input()}};
    return {"Re = |U| l L / ν",
            {Input::of(scene().drives.lid ? static_cast<const Parameter&>(lid_speed) : inflow),
             Input::constant("l", length, "", "length of the Reynolds number in units of L"), Input::of(size), nu_input()}};
}

// The velocity on a line through the middle, from the samples around the place.
Input NavierStokes::on_centre_line(int axis, Real along) const {
    const Lattice<2>& faces = grid_->faces(axis);
    const flow::Surrounding in = flow::surrounding(faces, place_on_centre_line(axis, along));
    std::vector<std::pair<Input, Input>> terms;
    for (Index k = 0; k < 4; ++k) {
        const Real w = (k % 2 ? in.fraction[0] : 1 - in.fraction[0]) * (k / 2 ? in.fraction[1] : 1 - in.fraction[1]);
        const std::string number = std::to_string(k + 1);
        terms.emplace_back(Input::constant("w" + number, w, "", "bilinear weight of this sample"),
                           flow::sample("q" + number, From::now, flow::face_field(axis),
                                        flow::sample_beyond(faces, {in.corner[0] + k % 2, in.corner[1] + k / 2})));
    }
    return Input::part("u_line", "m/s", weighted_sum("u_line = Σ w q, over the samples around the place on the line", terms));
}

Explanation NavierStokes::why_table_difference() const {
    const Difference d = *largest_from_table();
    return difference_of(on_centre_line(d.axis, d.along),
                         Input::constant("u_table", d.expected, "m/s",
                                         fmt::format("published, at {} = {:.6g} m", d.axis == 0 ? "y" : "x", d.along)));
}

Explanation NavierStokes::why_profile_difference() const {
    const Difference d = *largest_from_closed_form();
    return difference_of(on_centre_line(d.axis, d.along),
                         Input::constant("u_exact", d.expected, "m/s", fmt::format("closed form at y = {:.6g} m", d.along)));
}

}  // namespace pliant::navier_stokes
