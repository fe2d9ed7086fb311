// What the lesson shows and measures: fields and probes.
#include "advection_lesson.h"

#include "fluids/flow/flow_fields.h"

#include <algorithm>
#include <cmath>

namespace pliant::carrying {
namespace {

using Values = std::span<const Real>;

constexpr Real largest_value = 10;  // no scheme makes a value beyond 1, and no flow is faster in m/s
constexpr Real longest_way = 1e4;   // cells

Input cell_area(Real dx) { return Input::constant("A", dx * dx, "m²", "area of a cell"); }

}  // namespace

void AdvectionLesson::declare_fields() {
    state = {state_array("quantity", "1", quantity_), state_array("linear", "1", rival_[0]),
             state_array("cubic", "1", rival_[1]),    state_array("mac_cormack", "1", rival_[2]),
             state_array("origin", "m", origin_),     state_array("elapsed", "s", elapsed_)};
    const auto on_cells = [this](std::string_view name, std::string_view symbol, const VecX& values, std::string_view help) {
        Field f = scalar_field(name, symbol, "", On::cell, values, help);
        f.bound = [] { return largest_value; };
        fields.push_back(std::move(f));
        return &fields.back();
    };
    const auto vectors = [this](std::string_view name, std::string_view symbol, std::string_view unit, const Points<2>& values,
                                std::string_view help) {
        fields.push_back({.name = name,
                          .symbol = symbol,
                          .unit = unit,
                          .on = On::cell,
                          .rank = Rank::vector,
                          .components = 2,
                          .view = [&values] { return flow::numbers(values); },
                          .help = help,
                          .bound = [] { return largest_value; }});
    };
    on_cells("quantity", "q", quantity_, "what is carried: smoke, dye, a temperature; without a unit, between 0 and 1 at first");
    on_cells("exact", "q_exact", exact_, "the blob where the flow takes it, at the centres of the cells");
    on_cells("error", "e", error_, "q − q_exact");
    for (std::size_t k = 0; k < 3; ++k) {
        constexpr std::array<std::string_view, 3> help{"the quantity as linear interpolation carries it",
                                                       "the quantity as monotone cubic interpolation carries it",
                                                       "the quantity as MacCormack's limited correction carries it"};
        on_cells(scheme_fields[k], "q", rival_[k], help[k])->used = [this] { return bool(compare); };
    }
    on_cells("previous", "q_old", previous_, "the quantity at the start of the step");
    on_cells("returned", "q̃", returned_, "the carried quantity carried back again: MacCormack compares it with the start")->used =
        [this] { return corrected(); };
    vectors("velocity", "u", "m/s", centre_velocity_, "at cell centres, the mean of the two faces across each axis");
    vectors("middle", "x_m", "m", middle_, "where the fluid that arrives at a cell was half a step ago");
    vectors("departure", "x_d", "m", departure_, "where the fluid that arrives at a cell was one step ago");
    fields.push_back(scalar_field("way", "d", "cells", On::cell, way_, "length of the path back, in cells"));
    fields.back().bound = [] { return longest_way; };
    for (int a = 0; a < 2; ++a)
        fields.push_back({.name = flow::face_field(a),
                          .symbol = a == 0 ? "u" : "v",
                          .unit = "m/s",
                          .on = a == 0 ? On::x_face : On::y_face,
                          .view = [this, a] { return flow::numbers(velocity_[a]); },
                          .help = a == 0 ? "x component of the velocity, where it is stored: on the upright faces of the cells"
                                         : "y component of the velocity, where it is stored: on the level faces of the cells",
                          .bound = [] { return largest_value; }});
}

// ---------------------------------------------------------------------------------------------------------------- probes

void AdvectionLesson::declare_probes() {
    // Of a blob that no cell's centre lies in there is nothing to compare.
    const auto of_seen_blob = [this](Real known) {
        return [this, known](Real) { return first_variance_ > 0 ? std::optional(known) : std::nullopt; };
    };
    probes = {
        {.name = "turns",
         .symbol = "t/T",
         .help = "turns done: whole rotations, or metres of the translation or of the fastest fluid in the vortex",
         .value = [this] { return time() / flow().turn(); },
         .explain =
             [this] {
                 return Explanation{"t/T = t₁ / T",
                                    {Input::constant("t₁", time(), "s", "time since the start"),
                                     Input::constant("T", flow().turn(), "s", "time of one turn")},
                                    [](Values v) { return v[0] / v[1]; }};
             }},
        {.name = "peak",
         .symbol = "max q",
         .help = "the largest value anywhere. No scheme makes it grow",
         .value = [this] { return quantity_.maxCoeff(); },
         .exact = of_seen_blob(1),
         .explain = [this] { return why_peak(); }},
        {.name = "lowest",
         .symbol = "min q",
         .help = "the smallest value anywhere. No scheme makes it fall",
         .value = [this] { return quantity_.minCoeff(); }},
        {.name = "mass",
         .symbol = "M",
         .unit = "m²",
         .help =
             "Σ q Δx²: how much there is of the quantity. The continuous equation keeps it; reading values along paths does not",
         .value = [this] { return quantity_.sum() * dx() * dx(); },
         .explain = [this] { return why_mass(); }},
        {.name = "variance_left",
         .symbol = "V/V₀",
         .help = "Σ q² over what it was at first: as the kinetic energy, if q were a velocity. The flow keeps it; interpolation "
                 "loses it",
         .value = [this]() -> std::optional<Real> {
             if (first_variance_ == 0) return std::nullopt;
             return variance(quantity_) / first_variance_;
         },
         .exact = of_seen_blob(1),
         .explain = [this] { return why_variance_left(); }},
        {.name = "loss_per_turn",
         .symbol = "λ",
         .help = "part of Σ q² that is lost in one turn, 1 − (V/V₀)^(T/t)",
         .value = [this] { return loss_per_turn(); },
         .exact = [of_seen_blob](Real t) { return t > 0 ? of_seen_blob(0)(t) : std::nullopt; },
         .explain =
             [] {
                 return Explanation{"λ = 1 − V^(1/N)",
                                    {Input::now("V", "variance_left", 0), Input::now("N", "turns", 0)},
                                    [](Values v) { return 1 - std::pow(v[0], 1 / v[1]); }};
             }},
        {.name = "difference",
         .symbol = "E",
         .help = "Σ|q − q_exact| over Σ q_exact: 0 is exact, 2 is a blob in the wrong place",
         .value = [this]() -> std::optional<Real> {
             const Real all = exact_.lpNorm<1>();
             if (all == 0) return std::nullopt;
             return error_.lpNorm<1>() / all;
         },
         .exact = [this](Real) { return exact_.isZero(0) ? std::nullopt : std::optional<Real>(0); }},
        {.name = "correction",
         .symbol = "max|½(q_old − q̃)|",
         .help = "the largest correction that MacCormack's step asks for, before it is limited",
         .value = [this]() -> std::optional<Real> {
             if (!corrected()) return std::nullopt;
             return (previous_ - returned_).lpNorm<Eigen::Infinity>() / 2;
         }}};
}

Real AdvectionLesson::variance(const VecX& q) const { return q.squaredNorm() * dx() * dx(); }

std::optional<Real> AdvectionLesson::loss_per_turn() const {
    if (time() == 0 || first_variance_ == 0) return std::nullopt;
    return 1 - std::pow(variance(quantity_) / first_variance_, flow().turn() / time());
}

Explanation AdvectionLesson::why_peak() const {
    Index at = 0;
    quantity_.maxCoeff(&at);
    return {"max q = q   (the largest of all cells)", {Input::now("q", "quantity", at)}, [](Values v) { return v[0]; }};
}

Explanation AdvectionLesson::why_mass() const {
    std::vector<Input> terms;
    for (Index c = 0; c < quantity_.size(); ++c)
        if (quantity_[c] != 0) terms.push_back(Input::now("q", "quantity", c));
    return {"M = A S",
            {cell_area(dx()), Input::part("S", "", sum_of("S = Σ q, over the cells", std::move(terms)))},
            [](Values v) { return v[0] * v[1]; }};
}

Explanation AdvectionLesson::why_variance_left() const {
    std::vector<std::pair<Input, Input>> terms;
    for (Index c = 0; c < quantity_.size(); ++c)
        if (quantity_[c] != 0) terms.emplace_back(Input::now("q", "quantity", c), Input::now("q", "quantity", c));
    return {"V/V₀ = A S / W",
            {cell_area(dx()), Input::part("S", "", weighted_sum("S = Σ q q, over the cells", terms)),
             Input::constant("W", first_variance_, "m²", "A Σ q² at first")},
            [](Values v) { return v[0] * v[1] / v[2]; }};
}

}  // namespace pliant::carrying
