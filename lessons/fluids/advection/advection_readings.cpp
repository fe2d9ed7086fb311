// What the lesson shows and measures: fields and probes.
#include "advection_lesson.h"

#include <algorithm>
#include <cmath>

namespace pliant::carrying {
namespace {

constexpr Real largest_value = 10;  // no scheme makes a value beyond 1, and no flow is faster in m/s
constexpr Real longest_way = 1e4;   // cells

}  // namespace

void AdvectionLesson::declare_fields() {
    state = {state_array("quantity", "1", quantity_), state_array("linear", "1", rival_[0]),
             state_array("cubic", "1", rival_[1]),    state_array("mac_cormack", "1", rival_[2]),
             state_array("origin", "m", origin_),     state_array("elapsed", "s", elapsed_)};
    const auto velocity = [this]() -> const FaceField<2>& { return velocity_; };
    const auto compared = [this] { return bool(compare); };
    fields = {
        scalar_field("quantity", "q", "", On::cell, quantity_,
                     "what is carried: smoke, dye, a temperature; without a unit, between 0 and 1 at first"),
        scalar_field("exact", "q_exact", "", On::cell, exact_, "the blob where the flow takes it, at the centres of the cells"),
        scalar_field("error", "e", "", On::cell, error_, "q − q_exact").of_both_signs(),
        scalar_field("linear", "q", "", On::cell, rival_[0], "the quantity as linear interpolation carries it").when(compared),
        scalar_field("cubic", "q", "", On::cell, rival_[1], "the quantity as monotone cubic interpolation carries it")
            .when(compared),
        scalar_field("mac_cormack", "q", "", On::cell, rival_[2], "the quantity as MacCormack's limited correction carries it")
            .when(compared),
        scalar_field("previous", "q_old", "", On::cell, previous_, "the quantity at the start of the step"),
        scalar_field("returned", "q̃", "", On::cell, returned_,
                     "the carried quantity carried back again: MacCormack compares it with the start")
            .when([this] { return corrected(); }),
        plane_vector_field("velocity", "u", "m/s", On::cell, centre_velocity_,
                           "at cell centres, the mean of the two faces across each axis"),
        plane_vector_field("middle", "x_m", "m", On::cell, middle_, "where the fluid that arrives at a cell was half a step ago"),
        plane_vector_field("departure", "x_d", "m", On::cell, departure_,
                           "where the fluid that arrives at a cell was one step ago"),
        scalar_field("way", "d", "cells", On::cell, way_, "length of the path back, in cells"),
        grid2d::stored_velocity(0, velocity, largest_value),
        grid2d::stored_velocity(1, velocity, largest_value)};
    for (Field& f : fields) f = f.stops_at(f.name == "way" ? longest_way : largest_value);
}

// ---------------------------------------------------------------------------------------------------------------- probes

void AdvectionLesson::declare_probes() {
    // Of a blob that no cell's centre lies in there is nothing to compare.
    const auto seen = [this] { return first_variance_ > 0; };
    const auto elapsed_input = [this](const char* symbol) {
        return Input::constant(symbol, time(), "s", "time since the start");
    };
    const auto cell_area = [this] { return Input::constant("A", dx() * dx(), "m²", "area of a cell"); };
    const auto filled_cells = [this] {
        std::vector<Index> filled;
        for (Index c = 0; c < quantity_.size(); ++c)
            if (quantity_[c] != 0) filled.push_back(c);
        return filled;
    };
    probes = {
        probe_of("turns", "t/T", "",
                 "turns done: whole rotations, or metres of the translation or of the fastest fluid in the vortex")
            .formula(*this, "t/T = t₁ / T",
                     {Input::live("t₁", "s", "time since the start", [this] { return time(); }),
                      Input::live("T", "s", "time of one turn", [this] { return flow().turn(); })}),
        probe_of(
            "peak", "max q", "", "the largest value anywhere. No scheme makes it grow", [this] { return quantity_.maxCoeff(); },
            [this]() -> Explanation {
                Index at = 0;
                quantity_.maxCoeff(&at);
                return {"max q = q   (the largest of all cells)", {Input::now("q", "quantity", at)}};
            })
            .exactly([seen](Real) { return seen() ? std::optional<Real>(1) : std::nullopt; }),
        probe_of("lowest", "min q", "", "the smallest value anywhere. No scheme makes it fall",
                 [this] { return quantity_.minCoeff(); }),
        probe_of(
            "mass", "M", "m²",
            "Σ q Δx²: how much there is of the quantity. The continuous equation keeps it; reading values along paths does not",
            [this] { return quantity_.sum() * dx() * dx(); },
            [filled_cells, cell_area]() -> Explanation {
                std::vector<Input> terms;
                for (const Index c : filled_cells()) terms.push_back(Input::now("q", "quantity", c));
                if (terms.empty()) return fixed_value("M = 0: the quantity is 0 everywhere");
                terms = family_of("q_c", std::move(terms));
                terms.push_back(cell_area());
                return {"M = A Σ_c q_c", std::move(terms)};
            }),
        probe_of(
            "variance_left", "V/V₀", "",
            "Σ q² over what it was at first: as the kinetic energy, if q were a velocity. The flow keeps it; interpolation "
            "loses it",
            [this] { return variance(quantity_) / first_variance_; },
            [filled_cells, cell_area, this]() -> Explanation {
                std::vector<Input> inputs{cell_area(), Input::constant("W", first_variance_, "m²", "A Σ q² at first")};
                for (const Index c : filled_cells()) inputs.push_back(Input::now("q", "quantity", c).in("q_c"));
                if (inputs.size() == 2) return fixed_value("V/V₀ = 0: the quantity is 0 everywhere");
                return {"V/V₀ = A Σ_c q_c² / W", std::move(inputs)};
            })
            .exactly([](Real) { return Real{1}; })
            .when(seen),
        probe_of("loss_per_turn", "λ", "", "part of Σ q² that is lost in one turn, 1 − (V/V₀)^(T/t)")
            .formula(*this, "λ = 1 − V^(1/N)", {Input::now("V", "variance_left", 0), Input::now("N", "turns", 0)})
            .when([this] { return time() > 0 && first_variance_ > 0; })
            .exactly([seen](Real t) { return t > 0 && seen() ? std::optional<Real>(0) : std::nullopt; }),
        probe_of("difference", "E", "", "Σ|q − q_exact| over Σ q_exact: 0 is exact, 2 is a blob in the wrong place",
                 [this] { return error_.lpNorm<1>() / exact_.lpNorm<1>(); })
            .exactly([](Real) { return Real{0}; })
            .when([this] { return !exact_.isZero(0); }),
        probe_of("correction", "max|½(q_old − q̃)|", "",
                 "the largest correction that MacCormack's step asks for, before it is limited",
                 [this] { return (previous_ - returned_).lpNorm<Eigen::Infinity>() / 2; })
            .when([this] { return corrected(); }),
        probe_of(
            "measured_viscosity", "ν_measured", "m²/s",
            "the viscosity that would spread the blob as much as the scheme does: growth of the mean square distance "
            "from its middle over 4t",
            [this] { return measured_viscosity(); },
            [this, elapsed_input]() -> Explanation {
                return {"ν_measured = (m − m₀) / (4 t)",
                        {Input::constant("m", second_moment(quantity_), "m²", "mean square distance now"),
                         Input::constant("m₀", first_moment_, "m²", "mean square distance at first"), elapsed_input("t")}};
            })
            .exactly([this, seen](Real t) {
                return t > 0 && field != FlowKind::vortex && seen() ? std::optional<Real>(0) : std::nullopt;
            }),
        probe_of(
            "theory_viscosity", "ν_theory", "m²/s",
            "of linear interpolation in a translation: s(1 − s)Δx²/(2Δt) along each axis, mean of both; s: the fraction "
            "of a cell crossed per step",
            [this] { return viscosity_at(cfl, dx()); }, [this] { return why_theory(); })
            .when([this] { return field == FlowKind::translation; })};
}

}  // namespace pliant::carrying
