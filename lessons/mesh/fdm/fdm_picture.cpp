// The body on its grid, deformed, with its supports, its load and what it is compared to.
#include "fdm.h"
#include "kits/linear_body/linear_body_picture.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::fdm {
namespace {

// Of the rod in the picture, in lengths: its thickness, the height of its axis and that of the curve above it for a strain of the
// start over the whole length.
constexpr Real thickness = 0.09, rod_low = -0.3, curve_height = 0.3;
constexpr Index most_nodes_drawn = 1200, few_nodes = 150;

Position place(const FdmLesson& l, Index node) { return l.node_place(node); }

Position between(const Position& a, const Position& b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, 0}; }

// Every sample is drawn as the quarter of its cell that lies at its corner.
void draw_quarters(const FdmLesson& l, Scene& picture) {
    TriangleMarks quarters{.corners = {}, .triangles = {}, .ink = Ink::body};
    quarters.pick = {.pickable = true, .on = On::element};
    const std::vector<float> on_nodes = picture.values(l, On::node), on_samples = picture.values(l, On::element);
    const ElasticGrid<2>& grid = l.grid();
    for (Index s = 0; s < grid.sample_count(); ++s) {
        const Index here = grid.node_of(s), beside = grid.neighbour_of(s, 0), above = grid.neighbour_of(s, 1);
        const auto [i, j] = grid.place_of(here);
        const int right = grid.step_of(s, 0) > 0 ? 1 : -1, up = grid.step_of(s, 1) > 0 ? 1 : -1;
        const Index across = grid.node_at({i + right, j + up});
        const Position a = place(l, here), b = place(l, beside), c = place(l, above), d = place(l, across);
        const int first = static_cast<int>(quarters.corners.size());
        quarters.corners.insert(quarters.corners.end(), {a, between(a, b), between(between(a, d), between(b, c)), between(a, c)});
        quarters.triangles.push_back({first, first + 1, first + 2});
        quarters.triangles.push_back({first, first + 2, first + 3});
        quarters.pick.ids.insert(quarters.pick.ids.end(), {s, s});
        if (!on_samples.empty()) quarters.values.insert(quarters.values.end(), 2, on_samples[static_cast<std::size_t>(s)]);
        if (!on_nodes.empty()) {
            const auto v = [&](Index node) { return on_nodes[static_cast<std::size_t>(node)]; };
            quarters.values.insert(
                quarters.values.end(),
                {v(here), (v(here) + v(beside)) / 2, (v(here) + v(beside) + v(above) + v(across)) / 4, (v(here) + v(above)) / 2});
        }
    }
    picture.triangles.push_back(std::move(quarters));
}

void draw_grid(const FdmLesson& l, Scene& picture) {
    const ElasticGrid<2>& grid = l.grid();
    const bool fine = grid.node_count() > most_nodes_drawn, coarse = grid.node_count() <= few_nodes;
    LineMarks lines{.ends = {}, .ink = Ink::edge, .width = fine ? 0.5f : 1.0f};
    PointMarks nodes{.at = {},
                     .ink = Ink::body,
                     .radius = fine     ? 1.0f
                               : coarse ? 3.0f
                                        : 2.0f,
                     .pick = {.pickable = true, .on = On::node}};
    nodes.values = picture.values(l, On::node);
    PointMarks held{.at = {}, .ink = Ink::fixed, .radius = fine ? 2.0f : coarse ? 3.5f : 3.0f};
    for (Index k = 0; k < grid.node_count(); ++k) {
        nodes.at.push_back(place(l, k));
        const bool across_alone = l.is(GridShape::disc) && grid.place_of(k)[0] != grid.place_of(k)[1];
        if (l.problem_->supports().prescribed(k, 0) && (!across_alone || l.problem_->supports().prescribed(k, 1)))
            held.at.push_back(place(l, k));
    }
    // Each edge once: from the cells' corners with steps onwards, and from the far sides.
    for (Index s = 0; s < grid.sample_count(); ++s)
        for (int axis = 0; axis < 2; ++axis)
            if (grid.step_of(s, axis) > 0)
                for (const Index end : {grid.node_of(s), grid.neighbour_of(s, axis)}) lines.ends.push_back(place(l, end));
    picture.lines.push_back(std::move(lines));
    if (!fine || l.is(GridShape::block)) picture.points.push_back(std::move(nodes));
    picture.points.push_back(std::move(held));
}

void draw_load(const FdmLesson& l, Scene& picture) {
    if (!picture.show_arrows || !l.loaded()) return;
    const Points<2>& b = l.problem_->force_density();
    const Real largest = std::sqrt(b.colwise().squaredNorm().maxCoeff());
    if (largest == 0) return;
    const Real longest = 0.12 * l.length;
    const int n = static_cast<int>(Index(l.resolution)), every = std::max(1, (l.is(GridShape::disc) ? 2 * n : n) / 5);
    for (Index k = 0; k < b.cols(); ++k) {
        const auto [i, j] = l.grid().place_of(k);
        if ((i - every / 2) % every != 0 || (j - every / 2) % every != 0) continue;
        const Vec<2> arrow = longest / largest * b.col(k);
        const Position from = place(l, k);
        const bool leaves = l.is(GridShape::block) && from[1] + arrow.y() < 0;
        if (arrow.norm() < 0.3 * longest || leaves) continue;
        picture.arrow(from, position(from[0] + arrow.x(), from[1] + arrow.y()), Ink::force);
    }
}

// The circle that the stairs stand for, at rest and as the exact solution has it.
void draw_circle(const FdmLesson& l, Scene& picture) {
    constexpr int pieces = 96;
    const bool linear = l.linear() && l.solved();
    const Real swollen = linear ? l.length + l.magnification() * l.body().exact({l.length, 0}).x() : Real{l.length};
    LineMarks pairs{.ends = {}, .ink = Ink::accent, .width = 2};
    for (int k = 0; k < pieces; ++k)
        for (const int end : {k, k + 1}) {
            const Real angle = 2 * std::numbers::pi * end / pieces;
            pairs.ends.push_back(position(swollen * std::cos(angle), swollen * std::sin(angle)));
        }
    picture.lines.push_back(std::move(pairs));
    picture.label(position(0, swollen), linear ? "exact rim" : "the circle", Ink::accent, 0, -14);
}

// ----------------------------------------------------------------------------------------------------------------- rod

// Displacement over the rod, and that of the continuum.
void draw_rod_curve(const FdmLesson& l, Scene& picture) {
    const Real L = l.length, size = std::abs(l.start_strain) * L, up = size > 0 ? curve_height * L / size : Real{0};
    const auto height = [&](Real u) { return std::clamp(up * u, -1.3 * curve_height * L, 1.3 * curve_height * L) + 0.25 * L; };
    picture.line(position(0, 0.25 * L), position(L, 0.25 * L), Ink::rest, 1);
    picture.line(position(0, height(-size)), position(0, height(size)), Ink::ground, 4);
    for (const Real value : {-size, Real{0}, size})
        picture.label(position(0, height(value)), format_quantity(value, "m", 2), Ink::text, -36, 0);
    picture.label(position(0, height(size)), "u along the rod", Ink::text, 54, -12);
    LineMarks curve{.ends = {}, .ink = Ink::velocity, .width = 2.5f};
    PointMarks points{.at = {}, .ink = Ink::velocity, .radius = l.resolution > 60 ? 2.0f : 3.5f};
    for (int i = 0; i <= l.resolution; ++i) {
        const Index k = l.grid().node_at({i, 0});
        const Position here = position(l.grid().positions()(0, k), height(l.displacement_(0, k)));
        if (i > 0) curve.ends.push_back(points.at.back()), curve.ends.push_back(here);
        points.at.push_back(here);
    }
    picture.lines.push_back(std::move(curve));
    picture.points.push_back(std::move(points));
    if (!l.has_exact()) return;
    constexpr int pieces = 120;
    LineMarks exact{.ends = {}, .ink = Ink::accent, .width = 2};
    for (int k = 0; k < pieces; ++k)
        if (k / 3 % 2 == 0)
            for (const int end : {k, k + 1}) {
                const Real s = L * end / pieces;
                exact.ends.push_back(position(s, height(l.released().displacement(s, l.clock_[FdmLesson::elapsed]))));
            }
    picture.lines.push_back(std::move(exact));
}

void write_notes(const FdmLesson& l, Scene& picture) {
    const auto text = [](Real x, const char* unit) { return format_quantity(x, unit, 3); };
    if (l.magnification() != 1)
        picture.notes.push_back(fmt::format("displacements are drawn {} times as large", text(l.magnification(), "")));
    if (l.is(GridShape::disc))
        picture.notes.push_back(fmt::format("the grid has {} of the disc's area",
                                            text(l.grid().volumes().sum() / (std::numbers::pi * l.length * l.length), "")));
    if (!l.moves()) return;
    const Real limit = l.longest_step();
    if (limit == 0)
        picture.notes.push_back(fmt::format("Δt = {}: unstable at every Δt", text(l.dt, "s")));
    else if (std::isfinite(limit))
        picture.notes.push_back(
            fmt::format("Δt = {} {} {}, the stability limit", text(l.dt, "s"), l.dt <= limit ? "≤" : ">", text(limit, "s")));
}

}  // namespace

Position FdmLesson::node_place(Index node) const {
    const Vec<2> X = grid().positions().col(node), u = magnification() * displacement_.col(node);
    if (!is(GridShape::rod)) return position<2>(X + u);
    return position(X.x() + u.x(), (rod_low + thickness * grid().place_of(node)[1]) * length + u.y());
}

// By what the load or the start would come to; the block is drawn, and pulled, as it is.
Real FdmLesson::magnification() const {
    if (is(GridShape::rod)) return linear_body::magnification_for(std::abs(start_strain));
    if (!is(GridShape::disc)) return 1;
    const Real size = std::abs(body_force) * length / (8 * material().mu);
    return linear_body::magnification_for(size);
}

void FdmLesson::draw(Scene& picture) const {
    const Real L = length;
    draw_quarters(*this, picture);
    draw_grid(*this, picture);
    if (is(GridShape::rod)) {
        picture.line(position(0, (rod_low - 0.05) * L), position(0, (rod_low + thickness + 0.05) * L), Ink::ground, 6);
        draw_rod_curve(*this, picture);
        picture.frame(position(-0.14 * L, -0.78 * L), position(1.3 * L, 0.68 * L));
    } else if (is(GridShape::disc)) {
        draw_circle(*this, picture);
        picture.frame(position(-1.2 * L, -1.2 * L), position(2.45 * L, 1.2 * L));
    } else {
        if (is(GridShape::block)) {
            picture.line(position(-0.1 * L, 0), position(1.1 * L, 0), Ink::ground, 5);
            picture.box(position(0, 0), position(L, L), Ink::rest, 1, true);
        }
        picture.frame(position(-0.12 * L, -0.08 * L), position(1.82 * L, 1.12 * L));
    }
    draw_load(*this, picture);
    if (pulled()) {
        const Position held = place(*this, hand_.node);
        const Vec<2> to = grid().positions().col(hand_.node) + magnification() * hand_.target;
        picture.arrow(held, position<2>(to), Ink::accent);
    }
    draw_stencil(picture);
    write_notes(*this, picture);
}

}  // namespace pliant::fdm
