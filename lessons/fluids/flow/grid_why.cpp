#include "grid_why.h"

#include <algorithm>

#include <fmt/format.h>

namespace pliant::flow {
namespace {

using From = Input::From;
using Values = std::span<const Real>;

}  // namespace

Input sample(std::string symbol, Input::From from, std::string_view field, Index index) {
    return {.from = from, .symbol = std::move(symbol), .name = std::string(field), .index = index};
}

Input sample(std::string symbol, Input::From from, std::string_view field, const SampleBeyond& s) {
    if (s.factor == 1 && s.offset == 0) return sample(std::move(symbol), from, field, s.index);
    Explanation mirrored{fmt::format("{} = 2 U_wall − q", symbol),
                         {Input::constant("U_wall", s.offset / 2, "m/s", "velocity of the wall that lies half a cell away"),
                          sample("q", from, field, s.index)},
                         [](Values x) { return 2 * x[0] - x[1]; }};
    if (s.factor == 1)
        mirrored = {fmt::format("{} = 2 U_walls + q", symbol),
                    {Input::constant("U_walls", s.offset / 2, "m/s", "difference of the velocities of two walls that meet"),
                     sample("q", from, field, s.index)},
                    [](Values x) { return 2 * x[0] + x[1]; }};
    return Input::part(std::move(symbol), "m/s", std::move(mirrored));
}

Explanation kept_by_wall(int axis, Index face) {
    return {"u′ = u   (the face lies on a wall and keeps the wall's velocity)",
            {sample("u", From::before, face_field(axis), face)},
            [](Values x) { return x[0]; },
            [](Values x) { return fmt::format("{:.6g}", x[0]); }};
}

Surrounding surrounding(const Lattice<2>& lattice, const GridPlace<2>& place) {
    Surrounding in;
    for (int a = 0; a < 2; ++a) {
        const Real t = place[a] + (1 - lattice.offset[a]);
        const auto layer = static_cast<Index>(t);
        in.corner[a] = layer - 1;
        in.fraction[a] = t - static_cast<Real>(layer);
    }
    return in;
}

Explanation interpolated(const std::string& left, const Lattice<2>& lattice, std::string_view field, const GridPlace<2>& place) {
    const Surrounding in = surrounding(lattice, place);
    std::vector<std::pair<Input, Input>> terms;
    for (Index j = 0; j < 2; ++j)
        for (Index i = 0; i < 2; ++i) {
            const Real w = (i ? in.fraction[0] : 1 - in.fraction[0]) * (j ? in.fraction[1] : 1 - in.fraction[1]);
            const std::string k = std::to_string(2 * j + i + 1);
            terms.emplace_back(
                Input::constant("w" + k, w, "", "bilinear weight of this sample"),
                sample("q" + k, From::before, field, sample_beyond(lattice, {in.corner[0] + i, in.corner[1] + j})));
        }
    return weighted_sum(left + " = Σ w q, over the four samples around the place", terms);
}

bool GridWhy::closed(int axis, Index face) const {
    const auto& closed = grid_.closed_faces(axis);
    return std::ranges::binary_search(closed, face);
}

Input GridWhy::dx() const { return Input::constant("Δx", grid_.dx(), "m", "edge of a cell"); }

// Where the particle that arrives at a face was one step ago, along one axis, in cells: x − Δt/Δx u(x − ½ Δt/Δx u(x)).
Explanation GridWhy::departure_along(int axis, const GridPlace<2>& arrival, const GridPlace<2>& middle, bool inside,
                                     Real departure) const {
    const std::string x = axis == 0 ? "x" : "y";
    if (!inside)
        return {
            fmt::format("{}_d = edge   (the path leaves the domain: its nearest point, or the other side of a periodic one)", x),
            {Input::constant("edge", departure, "cells", "place in the domain")},
            [](Values v) { return v[0]; }};
    return {fmt::format("{0}_d = {0} − Δt u_m / Δx", x),
            {Input::constant(x, arrival[axis], "cells", "place that it comes to, from the corner of the domain"), dt_,
             Input::part("u_m", "m/s", interpolated("u_m", grid_.faces(axis), face_field(axis), middle)), dx()},
            [](Values v) { return v[0] - v[1] * v[2] / v[3]; }};
}

Explanation GridWhy::advected(const VelocitySampler<2>& flow, Real dt, int axis, Index face) const {
    if (closed(axis, face)) return kept_by_wall(axis, face);
    return arrived(flow, dt, grid_.faces(axis), face_field(axis), face, "u");
}

Explanation GridWhy::carried(const VelocitySampler<2>& flow, Real dt, std::string_view field, Index cell) const {
    return arrived(flow, dt, grid_.cells(), field, cell, "q");
}

// What a particle brings that is at a sample now.
Explanation GridWhy::arrived(const VelocitySampler<2>& flow, Real dt, const Lattice<2>& lattice, std::string_view field,
                             Index index, std::string_view symbol) const {
    const GridPlace<2> x = lattice.place(lattice.coordinates(index));
    const Real cells_per_speed = dt / grid_.dx();

    // The same path as the stage's: the velocity at the sample, half a step back, the velocity there, a whole step back.
    const auto back = [&](const GridPlace<2>& speed, Real step) {
        return GridPlace<2>{x[0] - step * speed[0], x[1] - step * speed[1]};
    };
    const GridPlace<2> middle = flow.confined(back(flow.at(x), 0.5 * cells_per_speed));
    const GridPlace<2> free_end = back(flow.at(middle), cells_per_speed);
    const GridPlace<2> departure = flow.confined(free_end);

    const Surrounding in = surrounding(lattice, departure);
    Explanation why{fmt::format("{0}′ = (1 − s) (1 − t) {0}₁ + s (1 − t) {0}₂ + (1 − s) t {0}₃ + s t {0}₄", symbol), {}, {}};
    for (int a = 0; a < 2; ++a) {
        const std::string part = a == 0 ? "s" : "t", place = a == 0 ? "x_d" : "y_d";
        const bool inside = departure[a] == free_end[a];
        why.inputs.push_back(Input::part(
            part, "",
            {fmt::format("{} = {} − x₁", part, place),
             {Input::part(place, "cells", departure_along(a, x, middle, inside, departure[a])),
              Input::constant("x₁", departure[a] - in.fraction[a], "cells", "place of the sample below or to the left")},
             [](Values v) { return v[0] - v[1]; }}));
    }
    for (Index k = 0; k < 4; ++k)
        why.inputs.push_back(sample(fmt::format("{}{}", symbol, std::array{"₁", "₂", "₃", "₄"}[static_cast<std::size_t>(k)]),
                                    From::before, field, sample_beyond(lattice, {in.corner[0] + k % 2, in.corner[1] + k / 2})));
    why.evaluate = [](Values v) {
        const Real s = v[0], t = v[1];
        return (1 - s) * (1 - t) * v[2] + s * (1 - t) * v[3] + (1 - s) * t * v[4] + s * t * v[5];
    };
    return why;
}

Input GridWhy::diffusion_number(Input viscosity) const {
    return Input::part(
        "r", "", {"r = ν Δt / Δx²", {std::move(viscosity), dt_, dx()}, [](Values x) { return x[0] * x[1] / (x[2] * x[2]); }});
}

Explanation GridWhy::diffused(Input viscosity, const VecX* residual, int axis, Index face) const {
    if (closed(axis, face)) return kept_by_wall(axis, face);
    const bool implicit = residual != nullptr;
    const std::string_view field = face_field(axis);
    const Lattice<2>& faces = grid_.faces(axis);
    const Counts<2> at = faces.coordinates(face);
    Explanation why{implicit ? "u′ = (u + r (u′_left + u′_right + u′_below + u′_above) − ρ) / (1 + 4 r)"
                             : "u′ = u + r (u_left + u_right + u_below + u_above − 4 u)",
                    {},
                    {}};
    why.inputs = {sample("u", From::before, field, face), diffusion_number(std::move(viscosity))};
    const std::array<const char*, 4> names{"left", "right", "below", "above"};
    for (int k = 0; k < 4; ++k) {
        Counts<2> beside = at;
        beside[k / 2] += k % 2 ? 1 : -1;
        why.inputs.push_back(sample(fmt::format("u{}_{}", implicit ? "′" : "", names[static_cast<std::size_t>(k)]),
                                    implicit ? From::now : From::before, field, sample_beyond(faces, beside)));
    }
    if (!implicit) {
        why.evaluate = [](Values x) { return x[0] + x[1] * ((x[2] + x[3] + x[4] + x[5]) - 4 * x[0]); };
        return why;
    }
    why.inputs.push_back(Input::constant("ρ", (*residual)[face], "m/s", "what the iterative solver has left of the equation"));
    why.evaluate = [](Values x) { return (x[0] + x[1] * (x[2] + x[3] + x[4] + x[5]) - x[6]) / (1 + 4 * x[1]); };
    return why;
}

}  // namespace pliant::flow
