// Places inside a body: rings about a hole, or a lattice within an outline with triangles between.
#include "body.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace pliant::bem {
namespace {

constexpr int ring_count = 8, section_points = 24;

// From the wall along x to the end of what is drawn.
std::pair<Real, Real> section_of(const BodyPlan& plan) {
    switch (plan.setting) {
        case Setting::plate_with_hole:
            return {plan.hole[0], plan.half_sizes[0]};
        case Setting::ring:
            return {plan.inner, plan.outer};
        case Setting::cavity_3d:
            return {plan.inner, 4 * plan.inner};
        default:
            return {plan.hole[0], plan.hole[0] + 3 * plan.hole.maxCoeff()};
    }
}

// Nearest element that lies in this direction from the middle, and where along it.
OnBoundary outer_at(const Body& body, const Vec<2>& direction) {
    const auto& elements = body.curve().elements();
    for (Index k = 0; k < body.element_count() && !body.on_inner(k); ++k) {
        const BoundaryElement& e = elements[static_cast<std::size_t>(k)];
        const Vec<2> p = e.shape[0], q = e.shape[2];
        const Real from = direction.x() * p.y() - direction.y() * p.x(), to = direction.x() * q.y() - direction.y() * q.x();
        if (from > 0 || to <= 0 || direction.dot(p + q) < 0) continue;
        return {k, std::clamp<Real>(-1 + 2 * from / (from - to), -1, 1)};
    }
    return {};
}

Vec<2> direction_of(Real angle) { return {std::cos(angle), std::sin(angle)}; }

// Angles of the spokes; a corner of the plate draws the nearest one to it.
std::vector<Real> spoke_angles(const BodyPlan& plan) {
    const int count = std::clamp(2 * plan.elements, 24, 64);
    std::vector<Real> angles;
    for (int k = 0; k < count; ++k) angles.push_back(2 * std::numbers::pi * k / count);
    if (plan.setting != Setting::plate_with_hole) return angles;
    const Real corner = std::atan2(plan.half_sizes[1] / plan.hole[1], plan.half_sizes[0] / plan.hole[0]);
    for (const Real a : {corner, std::numbers::pi - corner, std::numbers::pi + corner, 2 * std::numbers::pi - corner})
        *std::ranges::min_element(angles, {}, [a](Real x) { return std::abs(x - a); }) = a;
    return angles;
}

void add_rings(const Body& body, InsideMesh& mesh) {
    const BodyPlan& plan = body.plan();
    const bool open = plan.setting == Setting::hole;
    const Vec<2> wall = plan.setting == Setting::ring ? Vec<2>::Constant(plan.inner) : plan.hole;
    const auto angles = spoke_angles(plan);
    const auto spokes = static_cast<int>(angles.size());
    const Real way = section_of(plan).second - section_of(plan).first;
    const Real near = std::clamp(0.25 * wall.maxCoeff() * 2 * std::numbers::pi / plan.elements / way, 0.01, 0.2);
    // Corner (ring, spoke) is number ring × spokes + spoke: the wall, the rings, and the outer boundary.
    for (int ring = -1; ring <= ring_count; ++ring) {
        if (open && ring == ring_count) break;
        const int nearest = std::clamp(ring, 0, ring_count - 1);
        const Real t =
            near + (1 - (open ? 1 : 2) * near) * std::pow(static_cast<Real>(nearest) / (ring_count - 1), open ? 1.6 : 1.3);
        for (int k = 0; k < spokes; ++k) {
            const Real angle = angles[static_cast<std::size_t>(k)];
            const Vec<2> from = wall.cwiseProduct(direction_of(angle));
            const OnBoundary edge = open ? OnBoundary{} : outer_at(body, from);
            const Vec<2> to =
                open ? Vec<2>(from + 2 * wall.maxCoeff() * direction_of(angle)) : Vec<2>(body.place(edge).head<2>());
            InsideMesh::Corner corner{nearest * spokes + k, {}};
            if (ring < 0) corner.edge = body.inner_at(angle);
            if (ring == ring_count) corner.edge = edge;
            if (ring == nearest) mesh.particles.push_back(in_three(Vec<2>(from + t * (to - from))));
            mesh.corners.push_back(corner);
            if (ring < 0) continue;
            const int row = (ring + 1) * spokes, below = ring * spokes, next = (k + 1) % spokes;
            mesh.triangles.push_back({below + k, row + k, row + next});
            mesh.triangles.push_back({below + k, row + next, below + next});
        }
    }
}

// --- triangles between scattered points [Bowyer1981; Watson1981] ---
struct Circle {
    Vec<2> centre;
    Real square;
};
Circle circle_through(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    const Vec<2> p = b - a, q = c - a;
    const Real twice = 2 * (p.x() * q.y() - p.y() * q.x());
    const Vec<2> centre(q.y() * p.squaredNorm() - p.y() * q.squaredNorm(), p.x() * q.squaredNorm() - q.x() * p.squaredNorm());
    return {a + centre / twice, (centre / twice).squaredNorm()};
}

std::vector<std::array<int, 3>> delaunay(std::vector<Vec<2>> points, Real size) {
    const auto count = static_cast<int>(points.size());
    const Vec<2> middle = points[0];
    for (const Vec<2>& far : {Vec<2>(-1, -1), Vec<2>(1, -1), Vec<2>(0, 1)}) points.emplace_back(middle + 30 * size * far);
    std::vector<std::array<int, 3>> triangles{{count, count + 1, count + 2}};
    const auto at = [&](int n) { return points[static_cast<std::size_t>(n)]; };
    for (int n = 0; n < count; ++n) {
        std::set<std::pair<int, int>> rim;
        std::erase_if(triangles, [&](const std::array<int, 3>& t) {
            const Circle circle = circle_through(at(t[0]), at(t[1]), at(t[2]));
            if ((at(n) - circle.centre).squaredNorm() >= circle.square) return false;
            for (std::size_t k = 0; k < 3; ++k)
                if (!rim.erase({t[(k + 1) % 3], t[k]})) rim.insert({t[k], t[(k + 1) % 3]});
            return true;
        });
        for (const auto& [a, b] : rim) triangles.push_back({a, b, n});
    }
    std::erase_if(triangles, [&](const auto& t) { return std::ranges::any_of(t, [&](int n) { return n >= count; }); });
    return triangles;
}

void add_lattice(const Body& body, InsideMesh& mesh) {
    const Vec<3> low = body.nodes.rowwise().minCoeff(), high = body.nodes.rowwise().maxCoeff();
    const Real h = std::sqrt((high - low).head<2>().prod()) / 18;
    // A hair off the regular lattice, so that no four points lie on a circle.
    for (Real row = 0, y = low.y() + 0.37 * h; y < high.y(); y += 0.87 * h, ++row)
        for (Real x = low.x() + (std::fmod(row, 2) == 0 ? 0.31 : 0.81) * h; x < high.x(); x += h) {
            const Vec<3> X(x + 0.01 * h * std::sin(3 * row + 5 * x / h), y, 0);
            if (!body.contains(X) || body.distance(X) < 0.2) continue;
            mesh.corners.push_back({static_cast<Index>(mesh.particles.size()), {}});
            mesh.particles.push_back(X);
        }
    if (mesh.particles.empty()) return;
    std::vector<Vec<2>> places;
    for (const Vec<3>& X : mesh.particles) places.emplace_back(X.head<2>());
    for (Index k = 0; k < body.element_count(); ++k)
        for (int part = 0; part < 4; ++part) {
            const OnBoundary edge{k, -1 + 0.5 * part};
            const Vec<3> X = body.place(edge);
            const auto nearest =
                std::ranges::min_element(mesh.particles, {}, [&](const Vec<3>& Y) { return (X - Y).squaredNorm(); });
            mesh.corners.push_back({nearest - mesh.particles.begin(), edge});
            places.emplace_back(X.head<2>());
        }
    for (const auto& t : delaunay(places, (high - low).norm())) {
        Vec<2> middle = Vec<2>::Zero();
        for (const int n : t) middle += places[static_cast<std::size_t>(n)] / 3;
        if (body.contains(in_three(middle))) mesh.triangles.push_back(t);
    }
}

}  // namespace

InsideMesh inside_mesh(const Body& body) {
    InsideMesh mesh;
    const BodyPlan& plan = body.plan();
    if (plan.inside && plan.setting == Setting::outline) add_lattice(body, mesh);
    if (plan.inside && plan.setting != Setting::outline) {
        if (!body.in_space()) add_rings(body, mesh);
        mesh.section_first = static_cast<Index>(mesh.particles.size()), mesh.section_count = section_points;
        const auto [from, to] = section_of(plan);
        // Not nearer to the wall, or to the outer boundary, than numbers are good for.
        const Real apart = plan.setting == Setting::cavity_3d ? 0.1 * from : 0.3 * std::numbers::pi * from / plan.elements;
        const Real end = plan.setting == Setting::hole || body.in_space() ? to : to - std::min(apart, 0.2 * (to - from));
        const Real start = from + std::min(apart, 0.2 * (to - from));
        for (int k = 0; k < section_points; ++k)
            mesh.particles.emplace_back(start + (end - start) * std::pow(k / (section_points - 1.0), 1.5), 0, 0);
    }
    mesh.particles.emplace_back(Vec<3>::Zero());
    return mesh;
}

}  // namespace pliant::bem
