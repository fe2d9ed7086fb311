#include "grid_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pliant::grid2d {
namespace {

constexpr Real longest_arrow = 1.8;  // in spacings; faster fluid has arrows of this length

}  // namespace

void draw_field(Scene& scene, const Lesson& lesson, const StaggeredGrid<2>& grid) {
    const Field* field = lesson.find_field(scene.colour_by.field);
    const On on = field && (field->on == On::x_face || field->on == On::y_face) ? field->on : On::cell;
    const Lattice<2>& lattice = on == On::x_face ? grid.faces(0) : on == On::y_face ? grid.faces(1) : grid.cells();
    const auto corner = [&](Real beyond_x, Real beyond_y) {
        return position((lattice.offset[0] - 0.5 + beyond_x) * grid.dx(), (lattice.offset[1] - 0.5 + beyond_y) * grid.dx());
    };
    GridMarks map;
    map.nx = static_cast<int>(lattice.count[0]);
    map.ny = static_cast<int>(lattice.count[1]);
    map.lower = corner(0, 0);
    map.upper = corner(static_cast<Real>(map.nx), static_cast<Real>(map.ny));
    map.pick.on = on;
    map.values = scene.values(lesson, on);
    if (map.values.empty()) map.values.assign(static_cast<std::size_t>(lattice.size()), 0.0f);
    scene.grids.push_back(std::move(map));
}

void draw_solids(Scene& scene, const StaggeredGrid<2>& grid) {
    TriangleMarks squares{.corners = {}, .triangles = {}, .ink = Ink::ground};
    for (Index c = 0; c < grid.cells().size(); ++c) {
        if (grid.is_fluid(c)) continue;
        const Counts<2> at = grid.cells().coordinates(c);
        const int first = static_cast<int>(squares.corners.size());
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            squares.corners.push_back(
                position(static_cast<Real>(at[0] + x) * grid.dx(), static_cast<Real>(at[1] + y) * grid.dx()));
        squares.triangles.push_back({first, first + 1, first + 2});
        squares.triangles.push_back({first, first + 2, first + 3});
    }
    scene.triangles.push_back(std::move(squares));
}

void draw_velocity(Scene& scene, const StaggeredGrid<2>& grid, const VelocitySampler<2>& flow, Real speed, Index most,
                   const std::function<bool(const Vec<2>&)>& shown) {
    const Counts<2>& cells = grid.cell_counts();
    const Real dx = grid.dx(), longer = static_cast<Real>(std::max(cells[0], cells[1]));
    const Real apart = std::max(Real(1), longer / static_cast<Real>(most)) * dx, scale = apart / speed;
    std::array<Index, 2> count;
    for (int a = 0; a < 2; ++a)
        count[static_cast<std::size_t>(a)] =
            std::max<Index>(1, static_cast<Index>(std::lround(static_cast<Real>(cells[a]) * dx / apart)));
    ArrowMarks arrows{.from = {}, .to = {}, .ink = Ink::velocity, .width = 1.6f};
    for (Index j = 0; j < count[1]; ++j) {
        for (Index i = 0; i < count[0]; ++i) {
            const Vec<2> x{(static_cast<Real>(i) + 0.5) / static_cast<Real>(count[0]) * static_cast<Real>(cells[0]) * dx,
                           (static_cast<Real>(j) + 0.5) / static_cast<Real>(count[1]) * static_cast<Real>(cells[1]) * dx};
            if (shown && !shown(x)) continue;
            const GridPlace<2> u = flow.at({x[0] / dx, x[1] / dx});
            Vec<2> arrow = scale * Vec<2>(u[0], u[1]);
            const Real length = arrow.norm();
            if (length < 0.05 * apart) continue;
            if (length > longest_arrow * apart) arrow *= longest_arrow * apart / length;
            arrows.from.push_back(position<2>(x - 0.5 * arrow));
            arrows.to.push_back(position<2>(x + 0.5 * arrow));
        }
    }
    scene.arrows.push_back(std::move(arrows));
}

namespace {

struct Corner {
    Vec<2> at;
    Real distance;
};

// φ at the corners of the cells: the mean of the cells around, as far as there are any.
Real at_corner(const Lattice<2>& cells, const VecX& distance, Index i, Index j) {
    Real sum = 0;
    for (const Index y : {j - 1, j})
        for (const Index x : {i - 1, i})
            sum +=
                distance[cells.index({std::clamp<Index>(x, 0, cells.count[0] - 1), std::clamp<Index>(y, 0, cells.count[1] - 1)})];
    return sum / 4;
}

Vec<2> crossing(const Corner& a, const Corner& b) { return a.at + a.distance / (a.distance - b.distance) * (b.at - a.at); }

// The part of a triangle with φ < 0, as a polygon of up to four corners; the side on the surface goes to `line`.
int clipped(const std::array<Corner, 3>& triangle, std::array<Vec<2>, 4>& polygon, LineMarks& line) {
    int count = 0, crossed = 0;
    std::array<Vec<2>, 2> ends;
    for (std::size_t k = 0; k < 3; ++k) {
        const Corner &here = triangle[k], &next = triangle[(k + 1) % 3];
        if (here.distance < 0) polygon[static_cast<std::size_t>(count++)] = here.at;
        if ((here.distance < 0) == (next.distance < 0)) continue;
        const Vec<2> x = crossing(here, next);
        polygon[static_cast<std::size_t>(count++)] = x;
        ends[static_cast<std::size_t>(crossed++)] = x;
    }
    if (crossed == 2)
        for (const Vec<2>& end : ends) line.ends.push_back(position<2>(end));
    return count;
}

void add_polygon(TriangleMarks& marks, const std::array<Vec<2>, 4>& polygon, int count) {
    const int first = static_cast<int>(marks.corners.size());
    for (int k = 0; k < count; ++k) marks.corners.push_back(position<2>(polygon[static_cast<std::size_t>(k)]));
    for (int k = 2; k < count; ++k) marks.triangles.push_back({first, first + k - 1, first + k});
}

}  // namespace

void draw_liquid(Scene& picture, const StaggeredGrid<2>& grid, const VecX& distance, const std::vector<float>& values) {
    const Lattice<2>& cells = grid.cells();
    const Real dx = grid.dx();
    TriangleMarks water{.corners = {}, .triangles = {}, .ink = Ink::body, .pick = {.pickable = true, .on = On::cell}};
    LineMarks surface{.ends = {}, .ink = Ink::edge, .width = 2};
    const auto corner = [&](Index i, Index j) {
        return Corner{{static_cast<Real>(i) * dx, static_cast<Real>(j) * dx}, at_corner(cells, distance, i, j)};
    };
    for (Index c = 0; c < cells.size(); ++c) {
        const Index i = c % cells.count[0], j = c / cells.count[0];
        const std::array<Corner, 4> corners{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
        if (std::ranges::none_of(corners, [](const Corner& k) { return k.distance < 0; })) continue;
        const auto add = [&](const std::array<Vec<2>, 4>& polygon, int count) {
            const std::size_t before = water.triangles.size();
            add_polygon(water, polygon, count);
            for (std::size_t t = before; t < water.triangles.size(); ++t) {
                water.pick.ids.push_back(c);
                if (!values.empty()) water.values.push_back(values[static_cast<std::size_t>(c)]);
            }
        };
        std::array<Vec<2>, 4> polygon;
        if (std::ranges::all_of(corners, [](const Corner& k) { return k.distance < 0; })) {
            for (std::size_t k = 0; k < 4; ++k) polygon[k] = corners[k].at;
            add(polygon, 4);
            continue;
        }
        for (const auto& triangle :
             {std::array{corners[0], corners[1], corners[2]}, std::array{corners[0], corners[2], corners[3]}})
            if (const int count = clipped(triangle, polygon, surface); count > 2) add(polygon, count);
    }
    picture.triangles.push_back(std::move(water));
    picture.lines.push_back(std::move(surface));
}

UnstructuredGrid grid_of_cells(const StaggeredGrid<2>& grid) {
    const Counts<2>& n = grid.cell_counts();
    return regular_grid(Vec<3>::Zero(), Vec<3>::Constant(grid.dx()), n[0], n[1], 0, {On::cell});
}

}  // namespace pliant::grid2d
