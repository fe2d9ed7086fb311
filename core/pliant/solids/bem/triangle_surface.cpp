#include <pliant/math/error.h>
#include <pliant/solids/bem/triangle_surface.h>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pliant {

void require_closed_surface(const Points<3>& nodes, const SurfaceTriangles& triangles) {
    std::map<std::pair<int, int>, Index> runs;  // of each edge in each direction
    for (Index t = 0; t < triangles.cols(); ++t) {
        for (int a = 0; a < 3; ++a) {
            const int from = triangles(a, t), to = triangles((a + 1) % 3, t);
            if (from < 0 || from >= nodes.cols())
                throw Refused(fmt::format("triangle {} names node {}, but there are {}, counted from 0", t, from, nodes.cols()));
            if (!runs.try_emplace({from, to}, t).second)
                throw Refused(fmt::format(
                    "triangles {} and {} run along the edge from node {} to node {} in the same direction: turn one of them over",
                    runs[{from, to}], t, from, to));
        }
        const Vec<3> p = nodes.col(triangles(0, t)), q = nodes.col(triangles(1, t)), r = nodes.col(triangles(2, t));
        const Vec<3> area = (q - p).cross(r - p) / 2;
        const Real longest = std::max({(q - p).norm(), (r - p).norm(), (r - q).norm()});
        if (!(area.norm() > 1e-14 * longest * longest)) throw Refused(fmt::format("triangle {} of the surface has no area", t));
    }
    for (const auto& [edge, t] : runs)
        if (!runs.contains({edge.second, edge.first}))
            throw Refused(fmt::format("the surface is not closed: the edge from node {} to node {} belongs to triangle {} alone",
                                      edge.first, edge.second, t));
}

SphereSurface sphere_surface(int parts, bool from_inside) {
    const Real golden = (1 + std::sqrt(5.0)) / 2;
    const std::array<Vec<3>, 12> tops{{{-1, golden, 0},
                                       {1, golden, 0},
                                       {-1, -golden, 0},
                                       {1, -golden, 0},
                                       {0, -1, golden},
                                       {0, 1, golden},
                                       {0, -1, -golden},
                                       {0, 1, -golden},
                                       {golden, 0, -1},
                                       {golden, 0, 1},
                                       {-golden, 0, -1},
                                       {-golden, 0, 1}}};
    constexpr std::array<std::array<std::size_t, 3>, 20> faces{
        {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
         {3, 9, 4},  {3, 4, 2}, {3, 2, 6}, {3, 6, 8},  {3, 8, 9},   {4, 9, 5}, {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
    // Corners are known by their shares of the tops, so that faces share those of their edges.
    std::map<std::array<int, 12>, int> numbers;
    std::vector<Vec<3>> corners;
    std::vector<Eigen::Vector3i> triangles;
    for (const auto& face : faces) {
        const auto corner = [&](int i, int j) {
            const std::array<int, 3> share{parts - i - j, i, j};
            std::array<int, 12> key{};
            Vec<3> place = Vec<3>::Zero();
            for (std::size_t a = 0; a < 3; ++a) key[face[a]] = share[a], place += share[a] * tops[face[a]];
            const auto [found, is_new] = numbers.try_emplace(key, static_cast<int>(corners.size()));
            if (is_new) corners.push_back(place.normalized());
            return found->second;
        };
        for (int i = 0; i < parts; ++i)
            for (int j = 0; i + j < parts; ++j) {
                triangles.emplace_back(corner(i, j), corner(i + 1, j), corner(i, j + 1));
                if (i + j + 1 < parts) triangles.emplace_back(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
            }
    }
    SphereSurface s{Points<3>(3, static_cast<Index>(corners.size())), SurfaceTriangles(3, static_cast<Index>(triangles.size()))};
    for (std::size_t n = 0; n < corners.size(); ++n) s.corners.col(static_cast<Index>(n)) = corners[n];
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        s.triangles.col(static_cast<Index>(t)) = triangles[t];
        if (from_inside) std::swap(s.triangles(1, static_cast<Index>(t)), s.triangles(2, static_cast<Index>(t)));
    }
    return s;
}

}  // namespace pliant
