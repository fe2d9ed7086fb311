#include "render/picking.h"

#include <algorithm>
#include <limits>

namespace pliant::viewer {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

Vec<3> point(const Position& p) { return {p[0], p[1], p[2]}; }

Position middle(const Position& a, const Position& b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}; }

// Keeps the candidate that is nearest to the eye among those within reach, with some weight for the distance on the screen.
struct Best {
    std::optional<Picked> picked;
    float score = std::numeric_limits<float>::max();
    void offer(float candidate, const Picked& p) {
        if (candidate < score) score = candidate, picked = p;
    }
};

float distance_to_segment(const Vector2f& p, const Vector2f& a, const Vector2f& b) {
    const Vector2f d = b - a;
    const float length = d.squaredNorm();
    const float t = length > 0 ? std::clamp((p - a).dot(d) / length, 0.f, 1.f) : 0;
    return (p - a - t * d).norm();
}

bool inside(const Vector2f& p, const Vector2f& a, const Vector2f& b, const Vector2f& c) {
    const auto side = [&](const Vector2f& u, const Vector2f& v) { return (v - u).x() * (p - u).y() - (v - u).y() * (p - u).x(); };
    const float x = side(a, b), y = side(b, c), z = side(c, a);
    return (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
}

std::optional<Picked> pick_point(const Scene& scene, const Projection& projection, const Vector2f& at, float reach) {
    Best best;
    for (const PointMarks& marks : scene.points) {
        if (!marks.pick.pickable) continue;
        for (std::size_t i = 0; i < marks.at.size(); ++i) {
            const Vector3f p = projection.pixel(marks.at[i]);
            const float distance = (p.head<2>() - at).norm();
            if (p.z() < 1 && distance <= reach + marks.radius)
                best.offer(distance / reach + 40 * p.z(), {marks.pick.on, marks.pick.id(i), point(marks.at[i])});
        }
    }
    return best.picked;
}

std::optional<Picked> pick_line(const Scene& scene, const Projection& projection, const Vector2f& at, float reach) {
    Best best;
    for (const LineMarks& marks : scene.lines) {
        if (!marks.pick.pickable) continue;
        for (std::size_t i = 0; i + 1 < marks.ends.size(); i += 2) {
            const Vector3f a = projection.pixel(marks.ends[i]), b = projection.pixel(marks.ends[i + 1]);
            const float distance = distance_to_segment(at, a.head<2>(), b.head<2>());
            if (a.z() < 1 && b.z() < 1 && distance <= reach)
                best.offer(distance / reach + 20 * (a.z() + b.z()),
                           {marks.pick.on, marks.pick.id(i / 2), point(middle(marks.ends[i], marks.ends[i + 1]))});
        }
    }
    return best.picked;
}

std::optional<Picked> pick_triangle(const Scene& scene, const Projection& projection, const Vector2f& at) {
    Best best;
    for (const TriangleMarks& marks : scene.triangles) {
        if (!marks.pick.pickable) continue;
        for (std::size_t t = 0; t < marks.triangles.size(); ++t) {
            const auto corner = [&](std::size_t k) { return marks.corners[static_cast<std::size_t>(marks.triangles[t][k])]; };
            const Vector3f a = projection.pixel(corner(0)), b = projection.pixel(corner(1)), c = projection.pixel(corner(2));
            if (!inside(at, a.head<2>(), b.head<2>(), c.head<2>())) continue;
            const Vec<3> centre = (point(corner(0)) + point(corner(1)) + point(corner(2))) / 3;
            best.offer(a.z() + b.z() + c.z(), {marks.pick.on, marks.pick.id(t), centre});
        }
    }
    return best.picked;
}

std::optional<Picked> pick_cell(const Scene& scene, const Projection& projection, const Vector2f& at) {
    for (const GridMarks& g : scene.grids) {
        if (!g.pick.pickable || g.nx == 0 || g.ny == 0) continue;
        const Vec<3> p = projection.at_depth_of(at, point(g.lower));
        const Real i = (p.x() - g.lower[0]) / (g.upper[0] - g.lower[0]) * g.nx,
                   j = (p.y() - g.lower[1]) / (g.upper[1] - g.lower[1]) * g.ny;
        if (i < 0 || j < 0 || i >= g.nx || j >= g.ny) continue;
        return Picked{g.pick.on,
                      g.pick.id(static_cast<std::size_t>(i) + static_cast<std::size_t>(j) * static_cast<std::size_t>(g.nx)), p};
    }
    return std::nullopt;
}

}  // namespace

std::optional<Picked> pick(const Scene& scene, const Projection& projection, const Vector2f& at, float reach) {
    if (auto p = pick_point(scene, projection, at, reach)) return p;
    if (auto p = pick_line(scene, projection, at, reach)) return p;
    if (auto p = pick_triangle(scene, projection, at)) return p;
    return pick_cell(scene, projection, at);
}

}  // namespace pliant::viewer
