#include <pliant/math/error.h>
#include <pliant/mesh/simplex_quadrature.h>
#include <pliant/solids/bem/space_boundary_elements.h>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace pliant {
namespace {

constexpr int most_quarterings = 8;  // quarterings of a triangle near the source
constexpr int duffy_points = 6;      // along each axis of a triangle that holds the source

Points<3> area_vectors(const Points<3>& nodes, const SpaceBoundaryElements::Triangles& triangles) {
    Points<3> areas(3, triangles.cols());
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
        areas.col(t) = (q - p).cross(r - p) / 2;
        const Real longest = std::max({(q - p).norm(), (r - p).norm(), (r - q).norm()});
        if (!(areas.col(t).norm() > 1e-14 * longest * longest))
            throw Refused(fmt::format("triangle {} of the surface has no area", t));
    }
    for (const auto& [edge, t] : runs)
        if (!runs.contains({edge.second, edge.first}))
            throw Refused(fmt::format("the surface is not closed: the edge from node {} to node {} belongs to triangle {} alone",
                                      edge.first, edge.second, t));
    return areas;
}

std::vector<BoundarySystem<3>::Element> elements_of(const SpaceBoundaryElements::Triangles& triangles, const Points<3>& areas) {
    std::vector<BoundarySystem<3>::Element> list;
    for (Index t = 0; t < triangles.cols(); ++t) {
        const Mat<3> products = areas.col(t).norm() / 12 * (Mat<3>::Ones() + Mat<3>::Identity());
        list.push_back({.nodes = {triangles(0, t), triangles(1, t), triangles(2, t)}, .count = 3, .products = products});
    }
    return list;
}

// Distance from X to a triangle, good to a few tenths, and its longest edge.
struct TriangleNearness {
    Real distance, length;
};
TriangleNearness nearness(const Mat<3>& corners, const Vec<3>& X) {
    const Vec<3> centre = corners.rowwise().mean();
    Real distance = (centre - X).norm(), length = 0;
    for (int a = 0; a < 3; ++a) {
        const Vec<3> p = corners.col(a), d = corners.col((a + 1) % 3) - p;
        const Real s = std::clamp((X - p).dot(d) / d.squaredNorm(), Real{0}, Real{1});
        distance = std::min({distance, (p + s * d - X).norm(), ((p + d / 2 + centre) / 2 - X).norm()});
        length = std::max(length, d.norm());
    }
    return {distance, length};
}

// Degrees that are enough at a distance of so many lengths.
const SimplexRule<2>& rule_for(Real lengths) {
    static const SimplexRule<2> near = simplex_rule<2>(9), middle = simplex_rule<2>(5), far = simplex_rule<2>(3);
    return lengths > 5 ? far : lengths > 2 ? middle : near;
}

Vec<3> barycentric(const Mat<3>& corners, const Vec<3>& X) {
    const Vec<3> p = corners.col(0), u = corners.col(1) - p, v = corners.col(2) - p, w = X - p;
    const Real uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w), determinant = uu * vv - uv * uv;
    const Real s = (vv * uw - uv * vw) / determinant, t = (uu * vw - uv * uw) / determinant;
    return {1 - s - t, s, t};
}

}  // namespace

SpaceBoundaryElements::SpaceBoundaryElements(Points<3> nodes, Triangles triangles, const Lame& material, bool unbounded)
    : triangles_(std::move(triangles)),
      areas_(area_vectors(nodes, triangles_)),
      kelvin_(material),
      system_(std::move(nodes), elements_of(triangles_, areas_), material, unbounded) {}

SpaceBoundaryElements::Corners SpaceBoundaryElements::corners(Index triangle) const {
    Corners c;
    for (int a = 0; a < 3; ++a) c.col(a) = system_.nodes().col(triangles_(a, triangle));
    return c;
}

// visit(shape functions of the whole triangle, weight [m^2], r): sum of f × weight is the integral of f over the part.
template <class Visit>
void SpaceBoundaryElements::integrate(const Corners& whole, const Corners& part, Real area, const Vec<3>& X, int depth,
                                      Visit visit) const {
    const TriangleNearness near = nearness(part, X);
    if (near.distance < 0.7 * near.length && depth < most_quarterings) {
        for (int a = 0; a < 4; ++a) {
            Corners quarter;
            for (int b = 0; b < 3; ++b)
                quarter.col(b) =
                    a < 3 ? Vec<3>((part.col(a) + part.col(b)) / 2) : Vec<3>((part.col(b) + part.col((b + 1) % 3)) / 2);
            integrate(whole, quarter, area / 4, X, depth + 1, visit);
        }
        return;
    }
    const SimplexRule<2>& rule = rule_for(near.distance / near.length);
    for (Index q = 0; q < rule.weights.size(); ++q) {
        const Vec<3> point = part * rule.barycentric.col(q);
        visit(depth == 0 ? Vec<3>(rule.barycentric.col(q)) : barycentric(whole, point), area * rule.weights[q],
              Vec<3>(point - X));
    }
}

void SpaceBoundaryElements::assemble() {
    for (Index n = 0; n < system_.node_count(); ++n) assemble(n);
}

void SpaceBoundaryElements::assemble(Index node) {
    system_.begin_rows(node);
    for (Index t = 0; t < triangles_.cols(); ++t) {
        int own = -1;
        for (int a = 0; a < 3; ++a)
            if (triangles_(a, t) == node) own = a;
        own < 0 ? integrate_beside(t, node) : integrate_own(t, own, node);
    }
    system_.end_rows(node);
}

void SpaceBoundaryElements::integrate_beside(Index triangle, Index node) {
    const Corners whole = corners(triangle);
    const Vec<3> n = normal(triangle);
    std::array<Mat<3>, 3> T, U;
    T.fill(Mat<3>::Zero()), U.fill(Mat<3>::Zero());
    integrate(whole, whole, area(triangle), system_.nodes().col(node), 0, [&](const Vec<3>& N, Real weight, const Vec<3>& r) {
        const Mat<3> traction = weight * kelvin_.traction(r, n), displacement = weight * kelvin_.displacement(r);
        for (int a = 0; a < 3; ++a)
            T[static_cast<std::size_t>(a)] += N[a] * traction, U[static_cast<std::size_t>(a)] += N[a] * displacement;
    });
    for (int a = 0; a < 3; ++a) {
        system_.add_traction(node, triangles_(a, triangle), T[static_cast<std::size_t>(a)]);
        system_.add_displacement(node, system_.slot_of(triangle, a), U[static_cast<std::size_t>(a)]);
    }
}

// Duffy's coordinates: X + s ((1 - t) p + t q) with the edges p and q from the source, whose Jacobian 2 area s takes away what
// grows like 1/s; T is met by shape functions that vanish at the source [Duffy1982].
void SpaceBoundaryElements::integrate_own(Index triangle, int own, Index node) {
    static const GaussRule rule = gauss_legendre(duffy_points);
    const Corners c = corners(triangle);
    const Vec<3> p = c.col((own + 1) % 3) - c.col(own), q = c.col((own + 2) % 3) - c.col(own), n = normal(triangle);
    for (Index i = 0; i < rule.points.size(); ++i)
        for (Index j = 0; j < rule.points.size(); ++j) {
            const Real s = rule.points[i], t = rule.points[j],
                       weight = rule.weights[i] * rule.weights[j] * 2 * area(triangle) * s;
            const Vec<3> r = s * ((1 - t) * p + t * q);
            const Mat<3> T = weight * kelvin_.traction(r, n), U = weight * kelvin_.displacement(r);
            Vec<3> N;
            N[own] = 1 - s, N[(own + 1) % 3] = s * (1 - t), N[(own + 2) % 3] = s * t;
            for (int a = 0; a < 3; ++a) {
                system_.add_displacement(node, system_.slot_of(triangle, a), N[a] * U);
                if (a != own) system_.add_traction(node, triangles_(a, triangle), N[a] * T);
            }
        }
}

Vec<3> SpaceBoundaryElements::displacement(const BoundarySolution<3>& s, const Vec<3>& X) const {
    Vec<3> u = Vec<3>::Zero();
    for (Index k = 0; k < triangles_.cols(); ++k)
        integrate(corners(k), corners(k), area(k), X, 0, [&](const Vec<3>& N, Real weight, const Vec<3>& r) {
            const Mat<3> of_traction = weight * kelvin_.displacement(r), of_motion = weight * kelvin_.traction(r, normal(k));
            for (int a = 0; a < 3; ++a)
                u += N[a] *
                     (of_traction * s.traction.col(system_.slot_of(k, a)) - of_motion * s.displacement.col(triangles_(a, k)));
        });
    return u;
}

Mat<3> SpaceBoundaryElements::stress(const BoundarySolution<3>& s, const Vec<3>& X) const {
    Mat<3> sigma = Mat<3>::Zero();
    for (Index k = 0; k < triangles_.cols(); ++k)
        integrate(corners(k), corners(k), area(k), X, 0, [&](const Vec<3>& N, Real weight, const Vec<3>& r) {
            Vec<3> t = Vec<3>::Zero(), u = Vec<3>::Zero();
            for (int a = 0; a < 3; ++a)
                t += N[a] * s.traction.col(system_.slot_of(k, a)), u += N[a] * s.displacement.col(triangles_(a, k));
            sigma += weight * (kelvin_.stress_of_traction(r, t) - kelvin_.stress_of_displacement(r, normal(k), u));
        });
    return sigma;
}

}  // namespace pliant
