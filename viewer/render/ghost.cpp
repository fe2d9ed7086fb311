#include "render/ghost.h"

#include <Eigen/Geometry>

#include "render/moving_parts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr float line_width = 1.2f, point_radius = 2;  // px
constexpr float flat = 0.9f;                          // cosine between triangles whose common edge is no outline
constexpr int contours = 5;

using Edge = std::pair<Position, Position>;

Eigen::Vector3f vector(const Position& p) { return {p[0], p[1], p[2]}; }

// The edges of a surface where it ends or bends.
void outline(const TriangleMarks& marks, std::vector<Position>& ends) {
    std::map<Edge, std::vector<Eigen::Vector3f>> normals;
    for (const auto& t : marks.triangles) {
        const auto corner = [&](std::size_t k) { return marks.corners[static_cast<std::size_t>(t[k % 3])]; };
        const Eigen::Vector3f a = vector(corner(0)), normal = (vector(corner(1)) - a).cross(vector(corner(2)) - a).normalized();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax({corner(k), corner(k + 1)});
            normals[{low, high}].push_back(normal);
        }
    }
    for (const auto& [edge, sides] : normals)
        if (sides.size() != 2 || std::abs(sides[0].dot(sides[1])) < flat) ends.push_back(edge.first), ends.push_back(edge.second);
}

// The lines of equal value through the middles of the cells, by marching squares. A saddle is cut one way.
void contour(const GridMarks& g, float level, std::vector<Position>& ends) {
    const auto value = [&](int i, int j) { return g.values[static_cast<std::size_t>(i + j * g.nx)]; };
    const auto place = [&](float i, float j) {
        return Position{g.lower[0] + (i + 0.5f) / static_cast<float>(g.nx) * (g.upper[0] - g.lower[0]),
                        g.lower[1] + (j + 0.5f) / static_cast<float>(g.ny) * (g.upper[1] - g.lower[1]), g.lower[2]};
    };
    constexpr int around[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    for (int j = 0; j + 1 < g.ny; ++j)
        for (int i = 0; i + 1 < g.nx; ++i) {
            std::vector<Position> cuts;
            for (int side = 0; side < 4; ++side) {
                const auto& [ai, aj] = around[side];
                const auto& [bi, bj] = around[side + 1];
                const float a = value(i + ai, j + aj) - level, b = value(i + bi, j + bj) - level;
                if ((a < 0) == (b < 0)) continue;
                const float t = a / (a - b);
                cuts.push_back(place(static_cast<float>(i + ai) + t * static_cast<float>(bi - ai),
                                     static_cast<float>(j + aj) + t * static_cast<float>(bj - aj)));
            }
            ends.insert(ends.end(), cuts.begin(), cuts.end());
        }
}

void all_contours(const GridMarks& g, std::vector<Position>& ends) {
    if (g.values.empty()) return;
    const auto [low, high] = std::ranges::minmax(g.values);
    for (int k = 1; k <= contours && high > low; ++k)
        contour(g, low + (high - low) * (static_cast<float>(k) - 0.5f) / contours, ends);
}

template <class Mark>
void put_first(std::vector<Mark>& marks, const std::vector<Mark>& first) {
    marks.insert(marks.begin(), first.begin(), first.end());
}

}  // namespace

Scene ghost_of(const Scene& scene) {
    Scene ghost;
    ghost.frame(scene.lower, scene.upper);
    LineMarks solid{.ends = {}, .ink = Ink::rest, .width = line_width},
        dashed{.ends = {}, .ink = Ink::rest, .width = line_width, .dashed = true};
    for (const GridMarks& g : scene.grids) all_contours(g, solid.ends);
    for (const TriangleMarks& t : scene.triangles)
        if (moves(t.ink)) outline(t, solid.ends);
    // Where there is an outline, what lies inside it would hide the picture of now.
    const bool outlined = !solid.ends.empty();
    for (const LineMarks& l : scene.lines)
        if (moves(l.ink) && !outlined) dashed.ends.insert(dashed.ends.end(), l.ends.begin(), l.ends.end());
    ghost.lines = {std::move(solid), std::move(dashed)};
    for (const PointMarks& p : scene.points)
        if (moves(p.ink) && !outlined)
            ghost.points.push_back({.at = p.at, .ink = Ink::rest, .radius = std::min(p.radius, point_radius)});
    return ghost;
}

void lay_under(Scene& picture, const Scene& ghost) {
    put_first(picture.lines, ghost.lines);
    put_first(picture.points, ghost.points);
}

}  // namespace pliant::viewer
