// Interpolation spreads a blob as a viscosity would: what is measured of it, what theory says, the profiles, and when to doubt.
#include "advection_lesson.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::carrying {
namespace {

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

// About the place where the middle of the blob should be; 0 where nothing is left.
Real AdvectionLesson::second_moment(const VecX& q) const {
    const Vec<2> centre = exact_centre();
    const Real all = q.sum();
    if (all == 0) return 0;
    Real sum = 0;
    for (Index c = 0; c < q.size(); ++c) sum += q[c] * shortest_way(centre_of(c), centre, flow().periodic()).squaredNorm();
    return sum / all;
}

// The mean of both axes: s(1 − s)Δx²/(2Δt) along each.
Real AdvectionLesson::viscosity_at(Real courant, Real edge) const {
    const Vec<2> u = flow().velocity({0.5, 0.5}) / SteadyFlow::top_speed;
    return (spreading(courant * u[0]) + spreading(courant * u[1])) / 2 * edge * SteadyFlow::top_speed / courant;
}

void AdvectionLesson::viscosity_curve(Real edge, Curve& curve) const {
    curve = {};
    for (int k = 1; k <= 160; ++k) {
        const Real courant = largest_drawn * k / 160;
        curve.position.push_back(courant);
        curve.value.push_back(viscosity_at(courant, edge));
    }
}

Explanation AdvectionLesson::why_theory() const {
    const Vec<2> u = flow().velocity({0.5, 0.5}) / SteadyFlow::top_speed;
    const auto fraction = [&](int a) {
        const Real cells = std::abs(cfl * u[a]);
        return Input::constant(
            a == 0 ? "s" : "r", cells - std::floor(cells), "",
            a == 0 ? "fraction of a cell crossed per step along x" : "fraction of a cell crossed per step along y");
    };
    return {"ν_theory = (s (1 − s) + r (1 − r)) Δx² / (4 Δt)",
            {fraction(0), fraction(1), Input::constant("Δx", dx(), "m", "edge of a cell"), step()}};
}

// ------------------------------------------------------------------------------------------------------------ the curves

// Along the row of cells through the middle of the exact blob.
void AdvectionLesson::profile(const VecX& q, Curve& curve) const {
    curve = {};
    if (q.size() == 0) return;
    const Real y = exact_centre()[1] - (flow().periodic() ? std::floor(exact_centre()[1]) : Real{0});
    const Index row = std::clamp<Index>(static_cast<Index>(y / dx()), 0, resolution - 1);
    grid2d::sample_centres(curve, resolution, dx(), [&](Index i) { return q[i + resolution * row]; });
}

void AdvectionLesson::declare_lines() {
    const auto rival = [this](std::size_t k, std::string_view name) {
        return CompareCurve{.name = name, .sample = [this, k](Curve& curve) {
                                profile(rival_[k].size() == quantity_.size() && rival_[k] == quantity_ ? VecX() : rival_[k],
                                        curve);
                            }};
    };
    lines = {line_of("profile", "", "x", "m", "the quantity along the row of cells through the middle of the exact blob",
                     [this](Curve& curve) { profile(quantity_, curve); })
                 .against("exact", [this](Curve& curve) { profile(exact_, curve); })
                 .measures("q")
                 .beside({rival(0, "linear"), rival(1, "monotone cubic"), rival(2, "MacCormack")}),
             line_of("viscosity_of_cfl", "m²/s", "CFL", "",
                     "what linear interpolation adds in a translation, by theory, at each Courant number, with these cells and "
                     "with half as large ones; the point is measured now",
                     [this](Curve& curve) { viscosity_curve(dx(), curve); })
                 .measures("ν")
                 .when([this] { return field == FlowKind::translation; })
                 .beside({{.name = "measured",
                           .sample =
                               [this](Curve& curve) {
                                   const auto nu = measured_viscosity();
                                   curve = nu && cfl <= largest_drawn ? Curve{{cfl}, {*nu}} : Curve{};
                               },
                           .points = true},
                          {.name = "Δx/2", .sample = [this](Curve& curve) { viscosity_curve(dx() / 2, curve); }}})};
}

// -------------------------------------------------------------------------------------------- assumptions and laws

void AdvectionLesson::declare_checks() {
    const auto limit = [this] { return back_trace == BackTrace::euler ? largest_turn_of_euler : largest_turn; };
    assumptions = {assumption_of(
                       "path resolved", "rad", [this] { return turn_of_step(); }, limit, "ω Δt ≤ 0.5 (midpoint), 0.05 (Euler)",
                       "still stable, but the path back is a chord or a tangent of the true one: the blob comes to a wrong place")
                       .otherwise("path not resolved")
                       .when([this] { return field != FlowKind::translation; })
                       .mended_by([this, limit] {
                           Fix slower = fix_by(cfl, rounded_down(cfl * limit() / turn_of_step()));
                           slower.label.replace(0, 1, "CFL");
                           return slower;
                       }),
                   assumption_of(
                       "blob resolved", "cells", [] { return fewest_cells; }, [this] { return radius * resolution.value(); },
                       "6 ≤ R/Δx", "the blob is a few cells wide: interpolation flattens it within a turn, whatever the scheme")
                       .otherwise("blob too small for the grid")
                       .mended_by([this]() -> std::optional<Fix> {
                           const Real cells = std::ceil(fewest_cells / radius - 1e-9);
                           return cells > 320 ? std::nullopt : std::optional(fix_by(resolution, cells));
                       }),
                   assumption_of(
                       "spread by interpolation", "m²", [this] { return second_moment(quantity_) - first_moment_; },
                       [this] { return radius * radius / 4; }, "growth of the mean square distance ≤ R²/4",
                       "the scheme has spread the blob as a viscosity would: what is seen is the grid's, not the flow's")
                       .otherwise("spread by interpolation")
                       .when([this] { return field != FlowKind::vortex; })
                       .mended_by([this]() -> std::optional<Fix> {
                           if (scheme != Scheme::mac_cormack)
                               return Fix{
                                   "MacCormack, from the start",
                                   {{"advection_scheme", "mac_cormack"}, {"resolution", std::to_string(Index(resolution))}}};
                           return Fix{"CFL = 1", {{"cfl", "1"}}};
                       })};
    conserved = {{"peak", Law::never_grows, [] { return 1e-12; }},
                 {"mass", Law::constant, [] { return 1e-10; },
                  [this] { return field == FlowKind::translation && scheme == Scheme::linear; }}};
}

}  // namespace pliant::carrying
