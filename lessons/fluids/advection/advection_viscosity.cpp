// Interpolation spreads a blob as a viscosity would: what is measured of it, what theory says, the profiles, and when to doubt.
#include "advection_lesson.h"

#include <pliant/text/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace pliant::carrying {
namespace {

using Values = std::span<const Real>;

constexpr Real largest_turn = 0.5;  // rad per step, beyond which the midpoint rule is off by more than a hundredth of the way
constexpr Real largest_turn_of_euler = 0.05;
constexpr Real largest_drawn = 4;  // Courant number
constexpr Real fewest_cells = 6;   // in the blob's radius

// What linear interpolation loses per step in one direction, as a fraction of Δx²: s(1 − s)/2, with s the fraction of a cell that
// the path ends beyond a sample.
Real spreading(Real cells) {
    const Real s = std::abs(cells) - std::floor(std::abs(cells));
    return s * (1 - s) / 2;
}

}  // namespace

Vec<2> AdvectionLesson::exact_centre() const { return flow().before(shape().centre, -time()); }

// About the place where the middle of the blob should be; 0 where nothing is left.
Real AdvectionLesson::second_moment(const VecX& q) const {
    const Vec<2> centre = exact_centre();
    const Real all = q.sum();
    if (all == 0) return 0;
    Real sum = 0;
    for (Index c = 0; c < q.size(); ++c) sum += q[c] * shortest(centre_of(c), centre, flow().periodic()).squaredNorm();
    return sum / all;
}

// A viscosity ν makes the mean square distance grow by 4 ν t in a plane, by 2 ν t along each axis.
std::optional<Real> AdvectionLesson::measured_viscosity() const {
    if (time() == 0 || field == Flow::vortex || quantity_.sum() == 0) return std::nullopt;
    return (second_moment(quantity_) - first_moment_) / (4 * time());
}

// The mean of both axes: s(1 − s)Δx²/(2Δt) along each.
Real AdvectionLesson::viscosity_at(Real courant, Real edge) const {
    const Vec<2> u = flow().velocity({0.5, 0.5}) / top_speed;
    return (spreading(courant * u[0]) + spreading(courant * u[1])) / 2 * edge * top_speed / courant;
}

void AdvectionLesson::viscosity_curve(Real edge, Curve& curve) const {
    curve.position.clear();
    curve.value.clear();
    for (int k = 1; k <= 160; ++k) {
        const Real courant = largest_drawn * k / 160;
        curve.position.push_back(courant);
        curve.value.push_back(viscosity_at(courant, edge));
    }
}

std::optional<Real> AdvectionLesson::interpolation_viscosity() const {
    if (field != Flow::translation) return std::nullopt;
    return viscosity_at(cfl, dx());
}

void AdvectionLesson::declare_viscosity_probes() {
    probes.push_back(
        {.name = "measured_viscosity",
         .symbol = "ν_measured",
         .unit = "m²/s",
         .help = "the viscosity that would spread the blob as much as the scheme does: growth of the mean square distance "
                 "from its middle over 4t",
         .value = [this] { return measured_viscosity(); },
         .exact = [this](Real t) -> std::optional<Real> {
             if (t == 0 || field == Flow::vortex || first_variance_ == 0) return std::nullopt;
             return Real{0};
         },
         .explain =
             [this] {
                 return Explanation{"ν_measured = (m − m₀) / (4 t)",
                                    {Input::constant("m", second_moment(quantity_), "m²", "mean square distance now"),
                                     Input::constant("m₀", first_moment_, "m²", "mean square distance at first"),
                                     Input::constant("t", time(), "s", "time since the start")},
                                    [](Values v) { return (v[0] - v[1]) / (4 * v[2]); }};
             }});
    probes.push_back(
        {.name = "theory_viscosity",
         .symbol = "ν_theory",
         .unit = "m²/s",
         .help = "of linear interpolation in a translation: s(1 − s)Δx²/(2Δt) along each axis, mean of both; s: the fraction "
                 "of a cell crossed per step",
         .value = [this] { return interpolation_viscosity(); },
         .explain = [this] { return why_theory(); }});
}

Explanation AdvectionLesson::why_theory() const {
    const Vec<2> u = flow().velocity({0.5, 0.5}) / top_speed;
    const auto fraction = [&](int a) {
        const Real cells = std::abs(cfl * u[a]);
        return Input::constant(
            a == 0 ? "s" : "r", cells - std::floor(cells), "",
            a == 0 ? "fraction of a cell crossed per step along x" : "fraction of a cell crossed per step along y");
    };
    return {"ν_theory = (s (1 − s) + r (1 − r)) Δx² / (4 Δt)",
            {fraction(0), fraction(1), Input::constant("Δx", dx(), "m", "edge of a cell"), step()},
            [](Values v) { return (v[0] * (1 - v[0]) + v[1] * (1 - v[1])) * v[2] * v[2] / (4 * v[3]); }};
}

// ------------------------------------------------------------------------------------------------------------ the curves

// Along the row of cells through the middle of the exact blob.
void AdvectionLesson::profile(const VecX& q, Curve& curve) const {
    curve.position.clear();
    curve.value.clear();
    if (q.size() == 0) return;
    const Real y = exact_centre()[1] - (flow().periodic() ? std::floor(exact_centre()[1]) : Real{0});
    const Index row = std::clamp<Index>(static_cast<Index>(y / dx()), 0, resolution - 1);
    for (Index i = 0; i < resolution; ++i) {
        curve.position.push_back((static_cast<Real>(i) + Real(0.5)) * dx());
        curve.value.push_back(q[i + resolution * row]);
    }
}

std::vector<std::string_view> AdvectionLesson::first_plots() const {
    if (field == Flow::translation) return {"profile", "viscosity_of_cfl", "variance_left"};
    return {"profile", "variance_left", "difference"};
}

void AdvectionLesson::declare_lines() {
    const auto rival = [this](std::size_t k, std::string_view name) {
        return CompareCurve{.name = name, .sample = [this, k](Curve& curve) {
                                profile(rival_[k].size() == quantity_.size() && rival_[k] == quantity_ ? VecX() : rival_[k],
                                        curve);
                            }};
    };
    lines = {{.name = "profile",
              .position_name = "x",
              .position_unit = "m",
              .help = "the quantity along the row of cells through the middle of the exact blob",
              .sample = [this](Curve& curve) { profile(quantity_, curve); },
              .reference = [this](Curve& curve) { profile(exact_, curve); },
              .value_name = "q",
              .others = {rival(0, "linear"), rival(1, "monotone cubic"), rival(2, "MacCormack")}},
             {.name = "viscosity_of_cfl",
              .unit = "m²/s",
              .position_name = "CFL",
              .help = "what linear interpolation adds in a translation, by theory, at each Courant number, with these cells and "
                      "with half as large ones; the point is measured now",
              .sample = [this](Curve& curve) { viscosity_curve(dx(), curve); },
              .value_name = "ν",
              .used = [this] { return field == Flow::translation; },
              .others = {{.name = "measured",
                          .sample =
                              [this](Curve& curve) {
                                  curve.position.clear();
                                  curve.value.clear();
                                  const auto nu = measured_viscosity();
                                  if (!nu || cfl > largest_drawn) return;
                                  curve.position.push_back(cfl);
                                  curve.value.push_back(*nu);
                              },
                          .points = true},
                         {.name = "Δx/2", .sample = [this](Curve& curve) { viscosity_curve(dx() / 2, curve); }}}}};
}

// -------------------------------------------------------------------------------------------- assumptions and laws

Real AdvectionLesson::turn_of_step() const {
    const Real rate = field == Flow::vortex ? 2 * std::numbers::pi * top_speed : 2 * top_speed;  // of the middle, rad/s
    return rate * dt();
}

void AdvectionLesson::declare_checks() {
    const auto limit = [this] { return back_trace == BackTrace::euler ? largest_turn_of_euler : largest_turn; };
    assumptions = {
        {.name = "path resolved",
         .unit = "rad",
         .value = [this] { return turn_of_step(); },
         .limit = limit,
         .formula = "ω Δt ≤ 0.5 (midpoint), 0.05 (Euler)",
         .broken = "still stable, but the path back is a chord or a tangent of the true one: the blob comes to a wrong place",
         .used = [this] { return field != Flow::translation; },
         .fix =
             [this, limit] {
                 const Real most = rounded_down(cfl * limit() / turn_of_step());
                 return Fix{fmt::format("CFL = {}", format_quantity(most, "")), {{"cfl", format_exact(most)}}};
             }},
        {.name = "blob resolved",
         .unit = "cells",
         .value = [] { return fewest_cells; },
         .limit = [this] { return radius * static_cast<Real>(Index(resolution)); },
         .formula = "6 ≤ R/Δx",
         .broken = "the blob is a few cells wide: interpolation flattens it within a turn, whatever the scheme",
         .fix = [this]() -> std::optional<Fix> {
             const auto cells = static_cast<Index>(std::ceil(fewest_cells / radius - 1e-9));
             if (cells > 320) return std::nullopt;
             return Fix{fmt::format("n = {}", cells), {{"resolution", std::to_string(cells)}}};
         }},
        {.name = "spread by interpolation",
         .unit = "m²",
         .value = [this] { return second_moment(quantity_) - first_moment_; },
         .limit = [this] { return radius * radius / 4; },
         .formula = "growth of the mean square distance ≤ R²/4",
         .broken = "the scheme has spread the blob as a viscosity would: what is seen is the grid's, not the flow's",
         .used = [this] { return field != Flow::vortex; },
         .fix = [this]() -> std::optional<Fix> {
             if (scheme != Scheme::mac_cormack)
                 return Fix{"MacCormack, from the start",
                            {{"scheme", "mac_cormack"}, {"resolution", std::to_string(Index(resolution))}}};
             return Fix{"CFL = 1", {{"cfl", "1"}}};
         }}};
    conserved = {{.probe = "peak", .law = Law::never_grows, .tolerance = [] { return 1e-12; }},
                 {.probe = "mass",
                  .law = Law::constant,
                  .tolerance = [] { return 1e-10; },
                  .expected = [this] { return field == Flow::translation && scheme == Scheme::linear; }}};
}

}  // namespace pliant::carrying
