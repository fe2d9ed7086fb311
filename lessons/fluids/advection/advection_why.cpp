// How each number of a step came about: the path back, the samples and their weights, the correction.
#include "kits/grid2d/advection_why.h"
#include "advection_lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::carrying {
namespace {

using From = Input::From;

// The smallest or the largest of the four samples around a place.
Input end_of_range(bool high, const PaddedField<2>& values, const GridPlace<2>& place, From from, std::string_view name) {
    const Counts<2> corner = values.coordinates(values.locate(place).position);
    const std::string symbol = high ? "high" : "low";
    Explanation why{
        fmt::format("{} = {}(q1, q2, q3, q4)   (the samples around the departure place)", symbol, high ? "max" : "min"), {}};
    for (Index k = 0; k < 4; ++k)
        why.inputs.push_back(grid2d::sample(fmt::format("q{}", k + 1), from, name,
                                            sample_beyond(values.lattice(), {corner[0] + k % 2, corner[1] + k / 2})));
    return Input::part(symbol, "", std::move(why));
}

}  // namespace

Explanation weighted_samples(const std::string& left, const PaddedField<2>& values, const GridPlace<2>& place, From from,
                             std::string_view name) {
    std::vector<std::pair<Input, Input>> terms;
    for (const WeightedSample<2>& s : interpolation_stencil<2>(values, place).samples) {
        if (s.weight == 0) continue;
        const std::string k = std::to_string(terms.size() + 1);
        terms.emplace_back(Input::constant("w" + k, s.weight, "", "weight of this sample"),
                           grid2d::sample("q" + k, from, name, sample_beyond(values.lattice(), s.at)));
    }
    return weighted_sum(left + " = Σ_k w_k q_k, over the samples around the departure place", "w_k", "q_k", terms);
}

Input AdvectionLesson::step() const {
    return part("Δt = C Δx / U", {cfl, Input::constant("Δx", dx(), "m", "edge of a cell"),
                                  Input::constant("U", SteadyFlow::top_speed, "m/s", "speed of the fastest fluid")});
}

// The velocity of the flow on a face, so that no cell has a divergence.
Explanation AdvectionLesson::why_on_face(int axis, Index face) const {
    const GridPlace<2> at = grid_->faces(axis).place(grid_->faces(axis).coordinates(face));
    const Vec<2> x = dx() * Vec<2>(at[0], at[1]), half = dx() / 2 * Vec<2>::Unit(1 - axis);
    const auto end = [&](const char* symbol, const Vec<2>& place) {
        return Input::constant(symbol, flow().stream_function(place), "m²/s",
                               "stream function of the flow at this end of the face");
    };
    Input edge = Input::part("Δx", "m", {"Δx = L / n", {Input::constant("L", 1, "m", "width of the box"), resolution}});
    if (axis == 0) return {"u = (ψ_above − ψ_below) / Δx", {end("ψ_above", x + half), end("ψ_below", x - half), std::move(edge)}};
    return {"v = (ψ_left − ψ_right) / Δx", {end("ψ_left", x - half), end("ψ_right", x + half), std::move(edge)}};
}

// -------------------------------------------------------------------------------------------------------------- the path

Explanation AdvectionLesson::why_middle(Index cell, int component) const {
    const Departure<2> d = departure_of(cell);
    const auto a = static_cast<std::size_t>(component);
    const std::string x = axis_name(component);
    const Input here = Input::constant(x, dx() * d.arrival[a], "m", "centre of the cell");
    if (back_trace == BackTrace::euler) return {fmt::format("{0}_m = {0}   (Euler's method takes the velocity here)", x), {here}};
    return moved_into_box({fmt::format("{0}_m = {0} − ½ Δt u", x), {here, step(), Input::now("u", "velocity", cell, component)}},
                          d.free_middle[a], d.middle[a]);
}

// The velocity that the whole step is taken with.
Input AdvectionLesson::carrying_speed(Index cell, int component, std::string symbol) const {
    if (back_trace == BackTrace::euler) return Input::now(symbol, "velocity", cell, component);
    const Departure<2> d = departure_of(cell);
    return Input::part(symbol, "m/s",
                       grid2d::interpolated(symbol, grid_->faces(component), grid2d::face_field(component), d.middle));
}

Explanation AdvectionLesson::why_departure(Index cell, int component) const {
    const Departure<2> d = departure_of(cell);
    const auto a = static_cast<std::size_t>(component);
    const std::string x = axis_name(component);
    return moved_into_box(
        {fmt::format("{0}_d = {0} − Δt u_m", x),
         {Input::constant(x, dx() * d.arrival[a], "m", "centre of the cell"), step(), carrying_speed(cell, component, "u_m")}},
        d.free_departure[a], d.departure[a]);
}

// A path that leaves the box goes on at the other side of a periodic one, and ends at the wall of another.
Explanation AdvectionLesson::moved_into_box(Explanation why, Real free, Real place) const {
    if (free == place) return why;
    if (!flow().periodic())
        return {why.formula.substr(0, why.formula.find(" = ")) + " = wall   (the path leaves the box: the nearest point of it)",
                {Input::constant("wall", dx() * place, "m", "edge of the box")}};
    why.formula += " + P";
    why.inputs.push_back(
        Input::constant("P", dx() * std::round(place - free), "m", "whole widths of the box, which is periodic"));
    return why;
}

// -------------------------------------------------------------------------------------------- interpolation, correction

// How far the departure place is beyond the lower sample, in cells.
Input AdvectionLesson::why_fraction(Index cell, int axis, Index sample) const {
    const std::string symbol = axis == 0 ? "s" : "t", place = std::string(axis_name(axis)) + "_d";
    return Input::part(symbol, "",
                       {fmt::format("{} = {} / Δx − c", symbol, place),
                        {Input::now(place, "departure", cell, axis), Input::constant("Δx", dx(), "m", "edge of a cell"),
                         Input::constant("c", static_cast<Real>(sample) + Real(0.5), "cells", "place of the lower sample")}});
}

Explanation AdvectionLesson::why_interpolated(Index cell) const {
    const Departure<2> d = departure_of(cell);
    if (scheme == grid2d::Carrying::monotone_cubic)
        return weighted_samples("q′", advection_->carried(), d.departure, From::before, "quantity");
    const InterpolationStencil<2> stencil = interpolation_stencil<2>(advection_->carried(), d.departure);
    std::vector<std::pair<Input, Input>> terms;
    for (std::size_t k = 0; k < 4; ++k) {
        const WeightedSample<2>& s = stencil.samples[k];
        if (s.weight == 0) continue;
        const bool right = k & 1, above = k & 2;
        const std::string symbol = fmt::format("w{}", k + 1);
        Explanation weight{fmt::format("{} = {} {}", symbol, right ? "s" : "(1 − s)", above ? "t" : "(1 − t)"),
                           {why_fraction(cell, 0, stencil.corner[0]), why_fraction(cell, 1, stencil.corner[1])}};
        terms.emplace_back(
            Input::part(symbol, "", std::move(weight)),
            grid2d::sample(fmt::format("q{}", k + 1), From::before, "quantity", sample_beyond(grid_->cells(), s.at)));
    }
    return weighted_sum("q′ = Σ_k w_k q_k, over the samples around the departure place", "w_k", "q_k", terms);
}

Explanation AdvectionLesson::why_corrected(Index cell) const {
    const Departure<2> d = departure_of(cell);
    const auto end = [&](bool high) { return end_of_range(high, advection_->carried(), d.departure, From::now, "previous"); };
    return {"q′ = min(max(q̂ + ½ (q_old − q̃), low), high)",
            {Input::before("q̂", "quantity", cell), Input::now("q_old", "previous", cell), Input::now("q̃", "returned", cell),
             end(false), end(true)}};
}

// ---------------------------------------------------------------------------------------------------- what is exact

Explanation AdvectionLesson::why_exact(Index cell) const {
    const Real r = shape().distance(origin_of(cell));
    if (blob == BlobKind::slotted_disc)
        return fixed_value(exact_[cell] == 1 ? "q_exact = 1   (the fluid here was in the disc at first)"
                                             : "q_exact = 0   (the fluid here was not in the disc at first)");
    if (blob == BlobKind::hill && r >= radius)
        return fixed_value("q_exact = 0   (the fluid here was beyond the edge of the hill at first)");
    return {blob == BlobKind::smooth ? "q_exact = exp(−2 r² / R²)" : "q_exact = ½ (1 + cos(π r / R))",
            {Input::constant("r", r, "m", "how far the fluid here was from the middle of the blob at first"), radius}};
}

}  // namespace pliant::carrying
