#include "advection_why.h"

#include <pliant/fluids/interpolation_stencil.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant::grid2d {
namespace {

using From = Input::From;

const char* numbered(Index k) {
    constexpr std::array digits{"₁", "₂", "₃", "₄"};
    return digits[static_cast<std::size_t>(k)];
}

Counts<2> beside(const Counts<2>& corner, Index i, Index j) { return {corner[0] + i, corner[1] + j}; }

}  // namespace

AdvectionWhy::Carried AdvectionWhy::component(int axis) const {
    return {grid_.faces(axis), advection_.flow().component(axis), face_field(axis), "u", axis};
}

Explanation AdvectionWhy::velocity(int axis, Index face) const { return answer(component(axis), face); }

Explanation AdvectionWhy::quantity(std::string_view field, Index cell) const {
    return answer({grid_.cells(), advection_.carried(), field, "q", -1}, cell);
}

bool AdvectionWhy::kept(const Carried& what, Index sample) const {
    return what.axis < 0 ? !grid_.is_fluid(sample) : std::ranges::binary_search(grid_.closed_faces(what.axis), sample);
}

Explanation AdvectionWhy::answer(const Carried& what, Index sample) const {
    return advection_.settings().mac_cormack ? corrected(what, sample) : interpolated(what, sample);
}

// ------------------------------------------------------------------------------------------------------------- the path

// Where the particle that arrives at a sample was one step ago, along one axis, in cells.
Input AdvectionWhy::path(int axis, const Departure<2>& d) const {
    const std::string x = axis == 0 ? "x" : "y", at_start = x + "_d";
    const auto a = static_cast<std::size_t>(axis);
    if (d.departure[a] != d.free_departure[a])
        return Input::part(
            at_start, "cells",
            {at_start + " = edge   (the path leaves the domain: its nearest point, or the other side of a periodic one)",
             {Input::constant("edge", d.departure[a], "cells", "place in the domain")}});
    const bool midpoint = advection_.settings().trace == BackTrace::midpoint;
    const std::string speed = midpoint ? "u_m" : "u_a";
    return Input::part(
        at_start, "cells",
        {fmt::format("{0}_d = {0} − Δt {1} / Δx", x, speed),
         {Input::constant(x, d.arrival[a], "cells", "place that it comes to, from the corner of the domain"), step_,
          Input::part(speed, "m/s", grid2d::interpolated(speed, grid_.faces(axis), face_field(axis), d.middle)),
          Input::constant("Δx", grid_.dx(), "m", "edge of a cell")}});
}

// -------------------------------------------------------------------------------------------------------- interpolation

Explanation AdvectionWhy::interpolated(const Carried& what, Index index) const {
    if (kept(what, index))
        return what.axis < 0 ? Explanation{"q′ = q   (a solid cell)", {sample("q", From::before, what.field, index)}}
                             : kept_by_wall(what.axis, index);
    const Departure<2> d = advection_.departure(what.lattice.place(what.lattice.coordinates(index)), dt_);
    if (advection_.settings().interpolation == Interpolation::linear) return bilinear(what, d);
    return weighted_sum(what.symbol + "′ = Σ_k w_k q_k, over the sixteen samples around the place that it comes from", "w_k",
                        "q_k", cubic_terms(what, d.departure));
}

Explanation AdvectionWhy::bilinear(const Carried& what, const Departure<2>& d) const {
    const Surrounding in = surrounding(what.lattice, d.departure);
    Explanation why{fmt::format("{0}′ = (1 − s) (1 − t) {0}₁ + s (1 − t) {0}₂ + (1 − s) t {0}₃ + s t {0}₄", what.symbol), {}, {}};
    for (int a = 0; a < 2; ++a) {
        const std::string part = a == 0 ? "s" : "t", place = a == 0 ? "x_d" : "y_d";
        const auto axis = static_cast<std::size_t>(a);
        why.inputs.push_back(Input::part(part, "",
                                         {fmt::format("{} = {} − x₁", part, place),
                                          {path(a, d), Input::constant("x₁", d.departure[axis] - in.fraction[axis], "cells",
                                                                       "place of the sample below or to the left")}}));
    }
    for (Index k = 0; k < 4; ++k)
        why.inputs.push_back(sample(what.symbol + numbered(k), From::before, what.field,
                                    sample_beyond(what.lattice, beside(in.corner, k % 2, k / 2))));
    return why;
}

AdvectionWhy::Terms AdvectionWhy::cubic_terms(const Carried& what, const GridPlace<2>& place) const {
    const auto stencil = interpolation_stencil<2>(what.old, place);
    Terms terms;
    for (const WeightedSample<2>& s : stencil.samples) {
        const std::string k = std::to_string(terms.size() + 1);
        terms.emplace_back(Input::constant("w" + k, s.weight, "", "weight of this sample in the limited cubic"),
                           sample("q" + k, From::before, what.field, sample_beyond(what.lattice, s.at)));
    }
    return terms;
}

// ----------------------------------------------------------------------------------------------------------- MacCormack

// What the first half of the step made of a sample, or of what a wall makes of it one step beyond.
Input AdvectionWhy::carried_sample(const Carried& what, std::string symbol, const SampleBeyond& at) const {
    const std::string unit = what.axis < 0 ? "" : "m/s";
    Input inside = Input::part("q̂", unit, interpolated(what, at.index));
    if (at.factor == 1 && at.offset == 0) {
        inside.symbol = std::move(symbol);
        return inside;
    }
    return Input::part(std::move(symbol), unit,
                       {at.factor < 0 ? "q = o − q̂   (mirrored about a wall)" : "q = o + q̂   (mirrored about two walls)",
                        {Input::constant("o", at.offset, unit, "twice the velocity of the wall"), std::move(inside)}});
}

// q̃: the result of the first half, carried back again.
Input AdvectionWhy::carried_back(const Carried& what, Index index) const {
    const Departure<2> forth = advection_.departure(what.lattice.place(what.lattice.coordinates(index)), -dt_);
    const Surrounding in = surrounding(what.lattice, forth.departure);
    Terms terms;
    for (Index k = 0; k < 4; ++k) {
        const auto along = [&](std::size_t a, Index high) { return high ? in.fraction[a] : 1 - in.fraction[a]; };
        terms.emplace_back(
            Input::constant("w" + std::to_string(k + 1), along(0, k % 2) * along(1, k / 2), "", "bilinear weight of this sample"),
            carried_sample(what, "q" + std::to_string(k + 1), sample_beyond(what.lattice, beside(in.corner, k % 2, k / 2))));
    }
    return Input::part(
        what.symbol + "̃", what.axis < 0 ? "" : "m/s",
        weighted_sum("q̃ = Σ_k w_k q_k, over the four samples around the place that it goes to", "w_k", "q_k", terms));
}

Explanation AdvectionWhy::corrected(const Carried& what, Index index) const {
    if (kept(what, index)) return interpolated(what, index);
    const Departure<2> back = advection_.departure(what.lattice.place(what.lattice.coordinates(index)), dt_);
    const auto [low, high] = what.old.range_around(back.departure);
    const std::string unit = what.axis < 0 ? "" : "m/s", hat = what.symbol + "̂", tilde = what.symbol + "̃";
    return {
        fmt::format("{0}′ = min(max({1} + ½ ({0} − {2}), low), high)", what.symbol, hat, tilde),
        {Input::part(hat, unit, interpolated(what, index)), sample(what.symbol, From::before, what.field, index),
         carried_back(what, index), Input::constant("low", low, unit, "smallest of the samples and walls around its departure"),
         Input::constant("high", high, unit, "largest of them")}};
}

}  // namespace pliant::grid2d
