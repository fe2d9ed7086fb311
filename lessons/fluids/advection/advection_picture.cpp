// The figure: the quantity on the grid, the path back of one cell, and its samples under a magnifying glass.
#include "advection_lesson.h"
#include "kits/grid2d/grid_picture.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::carrying {
namespace {

constexpr Real gap = 0.14;                                                  // m, between the panels of the schemes
constexpr Real glass_left = 1.08, glass_bottom = 0.18, glass_width = 0.66;  // m, of the magnifying glass

}  // namespace

void AdvectionLesson::draw(Scene& scene) const {
    if (compare) {
        draw_all_schemes(scene);
        write_notes(scene);
        return;
    }
    grid2d::draw_field(scene, *this, *grid_);
    if (scene.show_arrows) grid2d::draw_velocity(scene, *grid_, advection_->flow(), 1.2, 12);
    scene.box(position(0, 0), position(1, 1), flow().periodic() ? Ink::rest : Ink::ground, flow().periodic() ? 2 : 4,
              flow().periodic());
    draw_path(scene);
    draw_magnifier(scene);
    write_notes(scene);
    scene.frame(position(-0.05, -0.07), position(1.8, 1.07));
}

// ------------------------------------------------------------------------------------------------- schemes side by side

void AdvectionLesson::draw_map(Scene& scene, const VecX& values, const Vec<2>& corner, std::string_view title,
                               bool chosen) const {
    GridMarks map;
    map.nx = map.ny = static_cast<int>(Index(resolution));
    map.lower = position<2>(corner);
    map.upper = position<2>(corner + Vec<2>(1, 1));
    map.values.resize(static_cast<std::size_t>(values.size()));
    std::ranges::transform(values, map.values.begin(), [](Real q) { return static_cast<float>(q); });
    map.pick.on = On::cell;
    scene.grids.push_back(std::move(map));
    scene.box(position<2>(corner), position<2>(corner + Vec<2>(1, 1)), chosen ? Ink::accent : Ink::rest, chosen ? 4 : 2);
    if (scene.show_labels)
        scene.label(position<2>(corner + Vec<2>(0.5, 1)), std::string(title), chosen ? Ink::accent : Ink::text, 0, -12);
}

void AdvectionLesson::draw_all_schemes(Scene& scene) const {
    const Real step = 1 + gap;
    const auto peak = [](std::string_view name, const VecX& q) { return fmt::format("{}: max {:.2f}", name, q.maxCoeff()); };
    draw_map(scene, exact_, {0, step}, peak("exact", exact_), false);
    draw_map(scene, rival_[0], {step, step}, peak("linear", rival_[0]), scheme == Scheme::linear);
    draw_map(scene, rival_[1], {0, 0}, peak("monotone cubic", rival_[1]), scheme == Scheme::monotone_cubic);
    draw_map(scene, rival_[2], {step, 0}, peak("MacCormack", rival_[2]), scheme == Scheme::mac_cormack);
    scene.frame(position(-0.06, -0.06), position(step + 1.06, step + 1.12));
}

// -------------------------------------------------------------------------------------------------- one cell's way back

void AdvectionLesson::draw_path(Scene& scene) const {
    const Index cell = selected();
    const Departure<2> d = departure_of(cell);
    const auto at = [this](const GridPlace<2>& x) { return position(dx() * x[0], dx() * x[1]); };
    const Position arrival = at(d.arrival), departure = at(d.free_departure);
    const bool midpoint = back_trace == BackTrace::midpoint;
    if (midpoint) {
        scene.line(arrival, at(d.free_middle), Ink::accent, 2, true);
        scene.points.push_back({.at = {at(d.free_middle)}, .ink = Ink::accent, .radius = 4});
    }
    scene.arrows.push_back({.from = {arrival}, .to = {departure}, .ink = Ink::accent, .width = 3});
    if (d.free_departure != d.departure) scene.points.push_back({.at = {at(d.departure)}, .ink = Ink::force, .radius = 5});
    scene.points.push_back(
        {.at = {arrival}, .ink = Ink::accent, .radius = 5, .pick = {.pickable = true, .on = On::handle, .first = 0}});
    if (!scene.show_labels) return;
    scene.label(arrival, "x", Ink::accent, -10, 14);
    const Real way = std::hypot(d.free_departure[0] - d.arrival[0], d.free_departure[1] - d.arrival[1]) * dx();
    if (way > 0.06) scene.labels.push_back({.at = departure, .text = "x_d", .ink = Ink::accent, .away_from = arrival});
    if (midpoint && way > 0.14) scene.label(at(d.free_middle), "x_m", Ink::accent, 0, 16);
}

// The samples around the departure place, enlarged, with their weights.
void AdvectionLesson::draw_magnifier(Scene& scene) const {
    const Index cell = selected();
    const GridPlace<2> place = departure_of(cell).departure;
    const PaddedField<2>& old = advection_->carried();
    const InterpolationStencil<2> stencil = interpolation_stencil<2>(old, place);
    const Index across = 4;
    const Real edge = glass_width / static_cast<Real>(across);
    const Counts<2> first{stencil.corner[0] - 1, stencil.corner[1] - 1};
    const auto shown = [&](Real i, Real j) { return position(glass_left + edge * i, glass_bottom + edge * j); };

    GridMarks map{.nx = static_cast<int>(across), .ny = static_cast<int>(across), .values = {}};
    map.lower = shown(0, 0);
    map.upper = shown(across, across);
    map.smooth = false;
    map.pick.on = On::cell;
    map.pick.pickable = false;
    // The quantity as it was when it was read; of another field what the picture shows.
    const std::vector<float> shown_values = scene.values(*this, On::cell);
    const bool of_quantity = scene.colour_by.field == "quantity" || shown_values.empty();
    for (Index j = 0; j < across; ++j)
        for (Index i = 0; i < across; ++i) {
            const Index c = sample_beyond(grid_->cells(), {first[0] + i, first[1] + j}).index;
            map.values.push_back(of_quantity ? static_cast<float>(previous_[c]) : shown_values[static_cast<std::size_t>(c)]);
        }
    scene.grids.push_back(std::move(map));
    for (int k = 0; k <= across; ++k) {
        scene.line(shown(k, 0), shown(k, across), Ink::edge, 1);
        scene.line(shown(0, k), shown(across, k), Ink::edge, 1);
    }
    scene.box(shown(0, 0), shown(across, across), Ink::accent, 2);
    const Real x = 1.5 + stencil.fraction[0], y = 1.5 + stencil.fraction[1];
    scene.points.push_back({.at = {shown(x, y)}, .ink = Ink::accent, .radius = 6});
    const Position corner = position(dx() * static_cast<Real>(first[0]), dx() * static_cast<Real>(first[1])),
                   opposite = position(dx() * static_cast<Real>(first[0] + across), dx() * static_cast<Real>(first[1] + across));
    scene.box(corner, opposite, Ink::accent, 1.5f);
    if (!scene.show_labels) return;
    const bool few = stencil.samples.size() <= 4;
    for (const WeightedSample<2>& s : stencil.samples) {
        if (s.weight == 0) continue;
        const Position middle = shown(static_cast<Real>(s.at[0] - first[0]) + 0.5, static_cast<Real>(s.at[1] - first[1]) + 0.5);
        scene.label(middle, fmt::format("{}{:.2f}", few ? "× " : "", s.weight), Ink::accent, 0, 9);
        scene.label(middle, fmt::format("{:.2f}", old.sample(s.at)), Ink::text, 0, -9);
    }
    scene.label(shown(0.5 * across, across), "samples at x_d: q × weight", Ink::text, 0, -14);
}

void AdvectionLesson::write_notes(Scene& scene) const {
    const std::string turns = fmt::format("t/T = {:.3g}", time() / flow().turn());
    if (compare) return scene.notes.push_back(fmt::format("CFL = {}, {}", format_quantity(cfl, "", 3), turns));
    scene.notes.push_back(fmt::format("Δx = {}, Δt = C Δx/U = {}", format_quantity(dx(), "m", 3), format_quantity(dt(), "s", 3)));
    scene.notes.push_back(turns);
    const Index cell = selected();
    const InterpolationStencil<2> stencil = interpolation_stencil<2>(advection_->carried(), departure_of(cell).departure);
    const Real correction = corrected() ? (previous_[cell] - returned_[cell]) / 2 : Real{0};
    std::string sum;
    Real value = 0;
    for (const WeightedSample<2>& s : stencil.samples) {
        value += s.weight * advection_->carried().sample(s.at);
        sum += fmt::format("{}{:.2f}·{:.2f}", sum.empty() ? "" : " + ", s.weight, advection_->carried().sample(s.at));
    }
    if (stencil.samples.size() > 4) sum = "Σ w q of 16 samples";
    scene.notes.push_back(fmt::format("q(x) = {} = {:.3f}", sum, value));
    if (corrected())
        scene.notes.push_back(fmt::format("correction {:+.3f}, within the samples: {:.3f}", correction, quantity_[cell]));
}

std::optional<UnstructuredGrid> AdvectionLesson::unstructured_grid() const { return grid2d::grid_of_cells(*grid_); }

}  // namespace pliant::carrying
