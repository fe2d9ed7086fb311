// How each number of a step came about: the path back, the samples and their weights, the correction.
#include "fluids/flow/advection_why.h"
#include "advection_lesson.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace pliant::carrying {
namespace {

using From = Input::From;
using Values = std::span<const Real>;

// left = Σ w q_k over the samples that count at a place, in a field that held `values` when it was read.
Explanation weighted_samples(const std::string& left, const PaddedField<2>& values, const GridPlace<2>& place, From from,
                             std::string_view name) {
    std::vector<std::pair<Input, Input>> terms;
    for (const WeightedSample<2>& s : interpolation_stencil<2>(values, place).samples) {
        if (s.weight == 0) continue;
        const std::string k = std::to_string(terms.size() + 1);
        terms.emplace_back(Input::constant("w" + k, s.weight, "", "weight of this sample"),
                           flow::sample("q" + k, from, name, flow::sample_beyond(values.lattice(), s.at)));
    }
    return weighted_sum(left + " = Σ w q, over the samples around the departure place", terms);
}

// The smallest or the largest of the four samples around a place.
Input end_of_range(bool high, const PaddedField<2>& values, const GridPlace<2>& place, From from, std::string_view name) {
    const Counts<2> corner = values.coordinates(values.locate(place).position);
    const std::string symbol = high ? "high" : "low";
    Explanation why{
        fmt::format("{} = {}(q1, q2, q3, q4)   (the samples around the departure place)", symbol, high ? "max" : "min"),
        {},
        [high](Values v) { return high ? *std::ranges::max_element(v) : *std::ranges::min_element(v); }};
    for (Index k = 0; k < 4; ++k)
        why.inputs.push_back(flow::sample(fmt::format("q{}", k + 1), from, name,
                                          flow::sample_beyond(values.lattice(), {corner[0] + k % 2, corner[1] + k / 2})));
    return Input::part(symbol, "", std::move(why));
}

Explanation limited(Input forward, Input old, Input returned, Input low, Input high) {
    return {"q′ = clamp(q̂ + ½ (q_old − q̃), low, high)",
            {std::move(forward), std::move(old), std::move(returned), std::move(low), std::move(high)},
            [](Values v) { return std::min(std::max(v[0] + (v[1] - v[2]) / 2, v[3]), v[4]); }};
}

}  // namespace

Input AdvectionLesson::step() const {
    return Input::part("Δt", "s",
                       {"Δt = C Δx / U",
                        {Input::of(cfl), Input::constant("Δx", dx(), "m", "edge of a cell"),
                         Input::constant("U", top_speed, "m/s", "speed of the fastest fluid")},
                        [](Values v) { return v[0] * v[1] / v[2]; }});
}

// The velocity of the flow on a face, so that no cell has a divergence.
Explanation AdvectionLesson::why_on_face(int axis, Index face) const {
    const GridPlace<2> at = grid_->faces(axis).place(grid_->faces(axis).coordinates(face));
    const Vec<2> x = dx() * Vec<2>(at[0], at[1]), half = dx() / 2 * Vec<2>::Unit(1 - axis);
    const auto end = [&](const char* symbol, const Vec<2>& place) {
        return Input::constant(symbol, flow().stream_function(place), "m²/s",
                               "stream function of the flow at this end of the face");
    };
    Input edge = Input::part(
        "Δx", "m", {"Δx = L / n", {Input::constant("L", 1, "m", "width of the box"), Input::of(resolution)}, [](Values v) {
                        return v[0] / v[1];
                    }});
    const auto slope = [](Values v) { return (v[0] - v[1]) / v[2]; };
    if (axis == 0)
        return {"u = (ψ_above − ψ_below) / Δx", {end("ψ_above", x + half), end("ψ_below", x - half), std::move(edge)}, slope};
    return {"v = (ψ_left − ψ_right) / Δx", {end("ψ_left", x - half), end("ψ_right", x + half), std::move(edge)}, slope};
}

Explanation AdvectionLesson::why_velocity(Index cell, int component) const {
    return flow::GridWhy(*grid_, step()).cell_velocity(cell, component);
}

// -------------------------------------------------------------------------------------------------------------- the path

Explanation AdvectionLesson::why_middle(Index cell, int component) const {
    const Departure<2> d = advection_->departure(grid_->cells().place(grid_->cells().coordinates(cell)), dt());
    const std::string x = axis_name(component);
    const auto a = static_cast<std::size_t>(component);
    Input here = Input::constant(x, dx() * d.arrival[a], "m", "centre of the cell");
    if (back_trace == BackTrace::euler)
        return {fmt::format("{0}_m = {0}   (Euler's method takes the velocity here)", x), {std::move(here)}, [](Values v) {
                    return v[0];
                }};
    Explanation why{fmt::format("{0}_m = {0} − ½ Δt u", x),
                    {std::move(here), step(), Input::now("u", "velocity", cell, component)},
                    [](Values v) { return v[0] - v[1] * v[2] / 2; }};
    return moved_into_box(std::move(why), d.free_middle[a], d.middle[a]);
}

// The velocity that the whole step is taken with.
Input AdvectionLesson::carrying_speed(Index cell, int component, std::string symbol) const {
    if (back_trace == BackTrace::euler) return Input::now(symbol, "velocity", cell, component);
    const Departure<2> d = advection_->departure(grid_->cells().place(grid_->cells().coordinates(cell)), dt());
    return Input::part(symbol, "m/s", flow::interpolated(symbol, grid_->faces(component), flow::face_field(component), d.middle));
}

Explanation AdvectionLesson::why_way(Index cell) const {
    return {"d = √(u_m² + v_m²) Δt / Δx",
            {carrying_speed(cell, 0, "u_m"), carrying_speed(cell, 1, "v_m"), step(),
             Input::constant("Δx", dx(), "m", "edge of a cell")},
            [](Values v) { return std::hypot(v[0], v[1]) * v[2] / v[3]; }};
}

Explanation AdvectionLesson::why_departure(Index cell, int component) const {
    const Departure<2> d = advection_->departure(grid_->cells().place(grid_->cells().coordinates(cell)), dt());
    const std::string x = axis_name(component);
    const auto a = static_cast<std::size_t>(component);
    Explanation why{
        fmt::format("{0}_d = {0} − Δt u_m", x),
        {Input::constant(x, dx() * d.arrival[a], "m", "centre of the cell"), step(), carrying_speed(cell, component, "u_m")},
        [](Values v) { return v[0] - v[1] * v[2]; }};
    return moved_into_box(std::move(why), d.free_departure[a], d.departure[a]);
}

// A path that leaves the box goes on at the other side of a periodic one, and ends at the wall of another.
Explanation AdvectionLesson::moved_into_box(Explanation why, Real free, Real place) const {
    if (free == place) return why;
    if (!flow().periodic())
        return {why.formula.substr(0, why.formula.find(" = ")) + " = wall   (the path leaves the box: the nearest point of it)",
                {Input::constant("wall", dx() * place, "m", "edge of the box")},
                [](Values v) { return v[0]; }};
    why.formula += " + P";
    why.inputs.push_back(
        Input::constant("P", dx() * std::round(place - free), "m", "whole widths of the box, which is periodic"));
    const auto path = why.evaluate;
    why.evaluate = [path](Values v) { return path(v.first(v.size() - 1)) + v.back(); };
    return why;
}

// -------------------------------------------------------------------------------------------- interpolation, correction

// How far the departure place is beyond the lower sample, in cells.
Input AdvectionLesson::why_fraction(Index cell, int axis, Index sample) const {
    const std::string symbol = axis == 0 ? "s" : "t", place = std::string(axis_name(axis)) + "_d";
    return Input::part(symbol, "",
                       {fmt::format("{} = {} / Δx − c", symbol, place),
                        {Input::now(place, "departure", cell, axis), Input::constant("Δx", dx(), "m", "edge of a cell"),
                         Input::constant("c", static_cast<Real>(sample) + Real(0.5), "cells", "place of the lower sample")},
                        [](Values v) { return v[0] / v[1] - v[2]; }});
}

Explanation AdvectionLesson::why_interpolated(Index cell) const {
    const Departure<2> d = advection_->departure(grid_->cells().place(grid_->cells().coordinates(cell)), dt());
    if (settings(scheme).interpolation != Interpolation::linear)
        return weighted_samples("q′", advection_->carried(), d.departure, From::before, "quantity");
    const InterpolationStencil<2> stencil = interpolation_stencil<2>(advection_->carried(), d.departure);
    std::vector<std::pair<Input, Input>> terms;
    for (std::size_t k = 0; k < 4; ++k) {
        const WeightedSample<2>& s = stencil.samples[k];
        if (s.weight == 0) continue;
        const bool right = k & 1, above = k & 2;
        const std::string symbol = fmt::format("w{}", k + 1);
        Explanation weight{fmt::format("{} = {} {}", symbol, right ? "s" : "(1 − s)", above ? "t" : "(1 − t)"),
                           {why_fraction(cell, 0, stencil.corner[0]), why_fraction(cell, 1, stencil.corner[1])},
                           [right, above](Values v) { return (right ? v[0] : 1 - v[0]) * (above ? v[1] : 1 - v[1]); }};
        terms.emplace_back(
            Input::part(symbol, "", std::move(weight)),
            flow::sample(fmt::format("q{}", k + 1), From::before, "quantity", flow::sample_beyond(grid_->cells(), s.at)));
    }
    return weighted_sum("q′ = Σ w q, over the samples around the departure place", terms);
}

Explanation AdvectionLesson::why_corrected(Index cell) const {
    const Departure<2> d = advection_->departure(grid_->cells().place(grid_->cells().coordinates(cell)), dt());
    const auto end = [&](bool high) { return end_of_range(high, advection_->carried(), d.departure, From::now, "previous"); };
    return limited(Input::before("q̂", "quantity", cell), Input::now("q_old", "previous", cell), Input::now("q̃", "returned", cell),
                   end(false), end(true));
}

Explanation AdvectionLesson::why_returned(Index cell) const {
    const Departure<2> ahead = advection_->departure(grid_->cells().place(grid_->cells().coordinates(cell)), -dt());
    return weighted_samples("q̃", advection_->forward(), ahead.departure, From::before, "quantity");
}

Explanation AdvectionLesson::why_rival(std::size_t k, Index cell) const {
    return flow::AdvectionWhy(*grid_, *rivals_[k], dt(), step()).quantity(scheme_fields[k], cell);
}

// ---------------------------------------------------------------------------------------------------- what is exact

Explanation AdvectionLesson::why_exact(Index cell) const {
    const Real r = shape().distance(origin_of(cell));
    if (blob == Blob::slotted_disc)
        return fixed_value(exact_[cell] == 1 ? "q_exact = 1   (the fluid here was in the disc at first)"
                                             : "q_exact = 0   (the fluid here was not in the disc at first)",
                           exact_[cell]);
    if (blob == Blob::hill && r >= radius)
        return fixed_value("q_exact = 0   (the fluid here was beyond the edge of the hill at first)", 0);
    const bool smooth = blob == Blob::smooth;
    return {smooth ? "q_exact = exp(−2 r² / R²)" : "q_exact = ½ (1 + cos(π r / R))",
            {Input::constant("r", r, "m", "how far the fluid here was from the middle of the blob at first"), Input::of(radius)},
            [smooth](Values v) {
                const Real s = v[0] / v[1];
                return smooth ? std::exp(-2 * s * s) : (1 + std::cos(std::numbers::pi * s)) / 2;
            },
            smooth ? std::function<std::string(Values)>(
                         [](Values v) { return fmt::format("exp(−2 · {:.6g}² / {:.6g}²)", v[0], v[1]); })
                   : std::function<std::string(Values)>(
                         [](Values v) { return fmt::format("½ (1 + cos(π · {:.6g} / {:.6g}))", v[0], v[1]); })};
}

}  // namespace pliant::carrying
