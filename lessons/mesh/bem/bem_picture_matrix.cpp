// H and G beside the body: every node with every node, as far as the rows are filled.
#include "bem.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant::bem {
namespace {

constexpr Index most_blocks = 48;  // along a side, of what is drawn; each stands for the largest entry in it
struct Shade {
    Real above;  // of the largest entry
    float opacity;
};
constexpr std::array<Shade, 4> shades{{{0.25, 1.0f}, {0.08, 0.62f}, {0.02, 0.36f}, {0, 0.16f}}};

struct Panel {
    Real left, top, height;
    Index rows, columns;
    Real width() const { return height * static_cast<Real>(columns) / static_cast<Real>(rows); }
};

// In shades of one ink.
void draw_blocks(Scene& scene, const VecX& entries, const Panel& panel, Index filled, Ink ink) {
    const Index step = (panel.rows + most_blocks - 1) / most_blocks;
    const Real largest = entries.cwiseAbs().maxCoeff(), cell = panel.height / static_cast<Real>(panel.rows);
    if (!(largest > 0)) return;
    std::array<TriangleMarks, shades.size()> marks;
    for (std::size_t s = 0; s < shades.size(); ++s)
        marks[s] = {.corners = {}, .triangles = {}, .ink = ink, .opacity = shades[s].opacity};
    for (Index i = 0; i < filled; i += step)
        for (Index j = 0; j < panel.columns; j += step) {
            const Index down = std::min(step, filled - i), across = std::min(step, panel.columns - j);
            Real size = 0;
            for (Index r = i; r < i + down; ++r)
                size = std::max(size, entries.segment(r * panel.columns + j, across).cwiseAbs().maxCoeff());
            const auto shade = static_cast<std::size_t>(
                std::ranges::find_if(shades, [&](const Shade& s) { return size >= s.above * largest; }) - shades.begin());
            TriangleMarks& m = marks[shade];
            const auto corner = [&](Index r, Index c) {
                m.corners.push_back(position(panel.left + cell * static_cast<Real>(c), panel.top - cell * static_cast<Real>(r)));
            };
            const int first = static_cast<int>(m.corners.size());
            corner(i, j), corner(i + down, j), corner(i + down, j + across), corner(i, j + across);
            m.triangles.push_back({first, first + 1, first + 2}), m.triangles.push_back({first, first + 2, first + 3});
        }
    for (TriangleMarks& m : marks) scene.triangles.push_back(std::move(m));
}

// By the colours of the field, entry by entry.
void draw_entries(Scene& scene, std::vector<float> values, const Panel& panel, On on) {
    GridMarks grid{.nx = static_cast<int>(panel.columns),
                   .ny = static_cast<int>(panel.rows),
                   .lower = position(panel.left, panel.top - panel.height),
                   .upper = position(panel.left + panel.width(), panel.top),
                   .values = {},
                   .smooth = false,
                   .pick = {true, on, 0, {}}};
    // Rows run down in a matrix, and up in a grid.
    for (Index i = panel.rows - 1; i >= 0; --i)
        for (Index j = 0; j < panel.columns; ++j) {
            grid.values.push_back(values[static_cast<std::size_t>(i * panel.columns + j)]);
            grid.pick.ids.push_back(i * panel.columns + j);
        }
    scene.grids.push_back(std::move(grid));
}

}  // namespace

Real BemLesson::matrix_room() const { return 0.95; }

void BemLesson::draw_matrices(Scene& scene) const {
    if (in_space() || !shows_matrices()) return;
    const View v = view();
    const Real side = (v.upper - v.lower).maxCoeff(), middle = 0.5 * (v.lower.y() + v.upper.y()), height = 0.46 * side;
    const Index rows = body_->unknowns();
    Real top = middle + height + 0.04 * side;
    for (const auto& [entries, name, on] : {std::tuple{&H_, "H", On::cell}, std::tuple{&G_, "G", On::face}}) {
        Panel panel{v.upper.x() + 0.2 * side, top, height, rows, entries->size() / rows};
        if (panel.width() > 0.7 * side) panel.height *= 0.7 * side / panel.width();
        const auto filled = static_cast<Index>(tally_[source]) * body_->dimension();
        if (scene.colour_by.field == name)
            draw_entries(scene, scene.values(*this, on), panel, on);
        else
            draw_blocks(scene, *entries, panel, filled, *name == 'H' ? Ink::velocity : Ink::force);
        scene.box(position(panel.left, top - panel.height), position(panel.left + panel.width(), top), Ink::rest);
        if (scene.show_labels)
            scene.label(position(panel.left + panel.width() / 2, top),
                        fmt::format("{}: {} × {}", name, panel.rows, panel.columns), Ink::text, 0, -12);
        if (filled > 0 && filled < rows) {
            const Real y = top - panel.height * static_cast<Real>(filled) / static_cast<Real>(rows);
            scene.line(position(panel.left, y), position(panel.left + panel.width(), y), Ink::accent, 3);
        }
        top -= panel.height + 0.1 * side;
    }
}

}  // namespace pliant::bem
