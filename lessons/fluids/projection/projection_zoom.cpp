// The cell that is selected, drawn large beside the field: where velocity and pressure are stored, and the fluxes that add up to
// its divergence.
#include "projection.h"

#include <pliant/lesson/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace pliant::projection {
namespace {

constexpr Real edge = 0.3;             // of a cell in the zoom, m of the picture
const Vec<2> lower_corner{1.2, 0.06};  // of three by three cells
constexpr Real longest = 0.2;          // of an arrow there
constexpr std::array<const char*, 4> names{"u_left", "u_right", "v_below", "v_above"};

std::string number(Real value, std::string_view unit = "") { return format_quantity(value, unit, 3); }

// Middle of a cell of the three by three, counted from the middle one.
Vec<2> middle_of(const Vec<2>& corner, int i, int j) { return corner + edge * Vec<2>(i + 1.5, j + 1.5); }

void arrow_through(Scene& scene, const Vec<2>& middle, int axis, Real length, Ink ink) {
    if (std::abs(length) < 0.01) return;
    const Vec<2> half = 0.5 * length * Vec<2>::Unit(axis);
    scene.arrows.push_back({.from = {position<2>(middle - half)}, .to = {position<2>(middle + half)}, .ink = ink, .width = 3.5f});
}

}  // namespace

void Projection::draw_zoom(Scene& scene) const {
    const Counts<2> at = grid_->cells().coordinates(selected_cell());
    LineMarks mesh{.ends = {}, .ink = Ink::edge, .width = 2};
    TriangleMarks solid{.corners = {}, .triangles = {}, .ink = Ink::ground, .opacity = 0.7f};
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            Index cell = selected_cell();
            if (i != 0) cell = grid_->cells().neighbour(at, 0, i);
            if (cell >= 0 && j != 0) cell = grid_->cells().neighbour(grid_->cells().coordinates(cell), 1, j);
            const Vec<2> low = middle_of(lower_corner, i, j) - Vec<2>::Constant(edge / 2);
            const auto corner = [&](int x, int y) { return position<2>(low + edge * Vec<2>(x, y)); };
            if (cell < 0 || !grid_->is_fluid(cell)) {
                const int first = static_cast<int>(solid.corners.size());
                for (const auto& c : {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}) solid.corners.push_back(c);
                solid.triangles.push_back({first, first + 1, first + 2});
                solid.triangles.push_back({first, first + 2, first + 3});
                continue;
            }
            for (const auto& [a, b] : {std::pair{corner(0, 0), corner(1, 0)},
                                       {corner(1, 0), corner(1, 1)},
                                       {corner(1, 1), corner(0, 1)},
                                       {corner(0, 1), corner(0, 0)}})
                mesh.ends.push_back(a), mesh.ends.push_back(b);
            scene.points.push_back({.at = {position<2>(middle_of(lower_corner, i, j))}, .ink = Ink::text, .radius = 3});
            if (scene.show_labels && (i == 0 || j == 0))
                scene.label(position<2>(middle_of(lower_corner, i, j)), "p = " + number(pressure_[cell]), Ink::text, 0, 14);
        }
    }
    scene.triangles.push_back(std::move(solid));
    scene.lines.push_back(std::move(mesh));
    const Vec<2> low = middle_of(lower_corner, 0, 0) - Vec<2>::Constant(edge / 2);
    scene.box(position<2>(low), position<2>(low + Vec<2>::Constant(edge)), Ink::accent, 4);
    if (!grid_->is_fluid(selected_cell())) return;
    if (staggered())
        zoom_staggered(scene, lower_corner);
    else
        zoom_collocated(scene, lower_corner);
}

// The four faces of the cell, each with the component that it stores.
void Projection::zoom_staggered(Scene& scene, const Vec<2>& corner) const {
    const Counts<2> at = grid_->cells().coordinates(selected_cell());
    std::array<Real, 4> u{};
    for (int k = 0; k < 4; ++k) {
        Counts<2> face = at;
        face[k / 2] = (face[k / 2] + k % 2) % grid_->faces(k / 2).count[k / 2];
        u[static_cast<std::size_t>(k)] = velocity_[k / 2][grid_->faces(k / 2).index(face)];
    }
    const Real fastest = std::max(std::abs(*std::ranges::max_element(u, {}, [](Real x) { return std::abs(x); })), Real(1e-300));
    for (int k = 0; k < 4; ++k) {
        const Vec<2> middle = middle_of(corner, 0, 0) + (k % 2 ? 0.5 : -0.5) * edge * Vec<2>::Unit(k / 2);
        const Real value = u[static_cast<std::size_t>(k)];
        arrow_through(scene, middle, k / 2, longest * value / fastest, Ink::velocity);
        scene.points.push_back({.at = {position<2>(middle)}, .ink = Ink::velocity, .radius = 4});
        if (scene.show_labels)
            scene.label(position<2>(middle), number(value), Ink::velocity, k < 2 ? 0.f : 30.f, k < 2 ? -16.f : 0.f);
    }
    const Real d = (u[1] - u[0] + u[3] - u[2]) / dx();
    if (!scene.show_labels) return;
    scene.label(position<2>(middle_of(corner, 0, 1) + Vec<2>(0, 0.5 * edge)),
                fmt::format("cell ({}, {}): velocity on faces, pressure in cells", at[0], at[1]), Ink::text, 0, -16);
    scene.label(position<2>(middle_of(corner, 0, -1) - Vec<2>(0, 0.5 * edge)),
                fmt::format("∇·u = ({} − {} + {} − {}) / Δx = {}", as_factor(u[1]), as_factor(u[0]), as_factor(u[3]),
                            as_factor(u[2]), number(std::abs(d) * dx() < 1e-12 * fastest ? 0 : d, "1/s")),
                Ink::accent, 0, 18);
}

// The four cells beside it: its own velocity takes no part.
void Projection::zoom_collocated(Scene& scene, const Vec<2>& corner) const {
    const Index cell = selected_cell();
    const Counts<2> at = grid_->cells().coordinates(cell);
    std::array<Real, 4> u{};
    for (int k = 0; k < 4; ++k) {
        const Index n = grid_->cells().neighbour(at, k / 2, k % 2 ? 1 : -1);
        u[static_cast<std::size_t>(k)] = n >= 0 ? centre_(k / 2, n) : -centre_(k / 2, cell);
    }
    const Real fastest = std::max(std::abs(*std::ranges::max_element(u, {}, [](Real x) { return std::abs(x); })), Real(1e-300));
    for (int k = 0; k < 4; ++k) {
        const Vec<2> middle = middle_of(corner, 0, 0) + (k % 2 ? 1 : -1) * edge * Vec<2>::Unit(k / 2);
        const Real value = u[static_cast<std::size_t>(k)];
        arrow_through(scene, middle, k / 2, longest * value / fastest, Ink::velocity);
        if (scene.show_labels) scene.label(position<2>(middle), number(value), Ink::velocity, k < 2 ? 0.f : 30.f, -16.f);
    }
    const Real d = (u[1] - u[0] + u[3] - u[2]) / (2 * dx());
    if (!scene.show_labels) return;
    scene.label(position<2>(middle_of(corner, 0, 1) + Vec<2>(0, 0.5 * edge)),
                fmt::format("cell ({}, {}): both in cells, differences over 2 Δx", at[0], at[1]), Ink::text, 0, -16);
    scene.label(position<2>(middle_of(corner, 0, -1) - Vec<2>(0, 0.5 * edge)),
                fmt::format("∇·u = ({} − {} + {} − {}) / (2 Δx) = {}", as_factor(u[1]), as_factor(u[0]), as_factor(u[3]),
                            as_factor(u[2]), number(std::abs(d) * dx() < 1e-12 * fastest ? 0 : d, "1/s")),
                Ink::accent, 0, 18);
}

}  // namespace pliant::projection
