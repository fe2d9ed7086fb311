#include <pliant/solids/bem/log_quadrature.h>
#include <pliant/solids/bem/plane_boundary_elements.h>

#include <fmt/format.h>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pliant {
namespace {

constexpr int singular_points = 16;  // of an element that holds the source, on each side of it
constexpr Real far_beyond = 4;       // in diagonals of the curve
constexpr int deepest = 24;          // halvings of an element near the source

// Points that are enough for an element at a distance of so many lengths: the error falls as ρ^(-2 points), ρ the ellipse through
// the source about the element.
struct Enough {
    Real distance;
    int points;
};
constexpr std::array<Enough, 3> enough{{{4, 4}, {1.5, 6}, {0.75, 10}}};

const GaussRule& gauss(int points) {
    static const GaussRule four = gauss_legendre(4), six = gauss_legendre(6), ten = gauss_legendre(10);
    return points == 4 ? four : points == 6 ? six : ten;
}

// Distance from X to a part of an element, and the length of that part; both good to a few tenths.
struct Nearness {
    Real distance, length;
};
Nearness nearness(const BoundaryElement& e, const Vec<2>& X, Real from, Real to) {
    const Vec<2> a = e.point(from), m = e.point((from + to) / 2), b = e.point(to);
    const auto to_piece = [&](const Vec<2>& p, const Vec<2>& q) {
        const Vec<2> d = q - p;
        const Real s = std::clamp((X - p).dot(d) / d.squaredNorm(), Real{0}, Real{1});
        return (p + s * d - X).norm();
    };
    return {std::min(to_piece(a, m), to_piece(m, b)), (m - a).norm() + (b - m).norm()};
}

std::vector<BoundarySystem<2>::Element> elements_of(const BoundaryCurve& curve) {
    std::vector<BoundarySystem<2>::Element> list;
    const GaussRule& rule = gauss(10);
    for (const BoundaryElement& e : curve.elements()) {
        BoundarySystem<2>::Element element{.nodes = {e.nodes[0], e.nodes[1], e.nodes[2], -1, -1, -1}, .count = e.count};
        for (Index q = 0; q < rule.points.size(); ++q) {
            const Real xi = 2 * rule.points[q] - 1;
            element.products.topLeftCorner<3, 3>() +=
                2 * rule.weights[q] * e.tangent(xi).norm() * e.values(xi) * e.values(xi).transpose();
        }
        list.push_back(element);
    }
    return list;
}

// Which node of an element it is; -1 for none.
int own_of(const BoundaryElement& e, Index node) {
    for (int a = 0; a < e.count; ++a)
        if (e.nodes[static_cast<std::size_t>(a)] == node) return a;
    return -1;
}

}  // namespace

PlaneBoundaryElements::PlaneBoundaryElements(const BoundaryCurve& curve, const Lame& material)
    : curve_(&curve),
      material_(material),
      kelvin_(material, far_beyond * (curve.nodes().rowwise().maxCoeff() - curve.nodes().rowwise().minCoeff()).norm()),
      system_(curve.nodes(), elements_of(curve), material, curve.unbounded()) {}

// visit(xi, weight [m], r, n): sum of f × weight is the integral of f over the part.
template <class Visit>
void PlaneBoundaryElements::integrate(const BoundaryElement& e, const Vec<2>& X, Real from, Real to, int depth,
                                      Visit visit) const {
    const Nearness near = nearness(e, X, from, to);
    for (const Enough& k : enough) {
        if (near.distance < k.distance * near.length && !(k.points == 10 && depth == deepest)) continue;
        const GaussRule& rule = gauss(k.points);
        for (Index q = 0; q < rule.points.size(); ++q) {
            const Real xi = from + (to - from) * rule.points[q];
            visit(xi, (to - from) * rule.weights[q] * e.tangent(xi).norm(), Vec<2>(e.point(xi) - X), e.normal(xi));
        }
        return;
    }
    const Real half = (from + to) / 2;
    integrate(e, X, from, half, depth + 1, visit);
    integrate(e, X, half, to, depth + 1, visit);
}

void PlaneBoundaryElements::assemble() {
    for (Index n = 0; n < curve_->node_count(); ++n) assemble(n);
}

void PlaneBoundaryElements::integrate(Index node) {
    system_.begin_rows(node);
    for (Index k = 0; k < static_cast<Index>(curve_->elements().size()); ++k) integrate_beside(k, node);
}

void PlaneBoundaryElements::integrate_beside(Index element, Index node) {
    const BoundaryElement& e = curve_->elements()[static_cast<std::size_t>(element)];
    const int own = own_of(e, node);
    const auto add = [&](const Vec<3>& N, const Mat<2>& U, const Mat<2>& T) {
        for (int a = 0; a < e.count; ++a) {
            if (a != own) system_.add_traction(node, e.nodes[static_cast<std::size_t>(a)], N[a] * T);
            system_.add_displacement(node, system_.slot_of(element, a), N[a] * U);
        }
    };
    if (own >= 0)
        return integrate_own(e, own, curve_->nodes().col(node),
                             [&](Real xi, Real weight, Real log_part, const Mat<2>& U, const Mat<2>& T) {
                                 add(e.values(xi), weight * U + log_part * Mat<2>::Identity(), weight * T);
                             });
    integrate(e, curve_->nodes().col(node), -1, 1, 0, [&](Real xi, Real weight, const Vec<2>& r, const Vec<2>& n) {
        add(e.values(xi), weight * kelvin_.displacement(r), weight * kelvin_.traction(r, n));
    });
}

// The parts of the element at either side of the source: U is log_factor() ln(1/t) I, t from 0 at the source to 1 at the end, and
// what is smooth; T is met by shape functions that vanish at the source. visit(xi, weight, log_part, smooth U, T)
template <class Visit>
void PlaneBoundaryElements::integrate_own(const BoundaryElement& e, int own, const Vec<2>& X, Visit visit) const {
    static const LogRule rule = log_rule(singular_points);
    const Real source = e.at[static_cast<std::size_t>(own)];
    for (const Real end : {Real{-1}, Real{1}}) {
        const Real side = end - source;
        if (side == 0) continue;
        for (Index q = 0; q < rule.points.size(); ++q) {
            const Real t = rule.points[q], xi = source + side * t;
            const Real stretch = std::abs(side) * e.tangent(xi).norm();
            const Vec<2> r = e.point(xi) - X;
            const Mat<2> smooth = kelvin_.displacement(r) + kelvin_.log_factor() * std::log(t) * Mat<2>::Identity();
            visit(xi, stretch * rule.weights[q], stretch * rule.log_weights[q] * kelvin_.log_factor(), smooth,
                  kelvin_.traction(r, e.normal(xi)));
        }
    }
}

std::vector<BoundaryIntegrationPoint<2>> PlaneBoundaryElements::integration_points(Index element, Index node) const {
    const BoundaryElement& e = curve_->elements()[static_cast<std::size_t>(element)];
    std::vector<BoundaryIntegrationPoint<2>> points;
    const auto add = [&](Real xi, Real weight, Real log_part, const Mat<2>& U, const Mat<2>& T) {
        points.push_back({Eigen::Matrix<Real, 6, 1>::Zero(), weight, U, T, log_part});
        points.back().shape.head<3>() = e.values(xi);
    };
    if (const int own = own_of(e, node); own >= 0)
        integrate_own(e, own, curve_->nodes().col(node), add);
    else
        integrate(e, curve_->nodes().col(node), -1, 1, 0, [&](Real xi, Real weight, const Vec<2>& r, const Vec<2>& n) {
            add(xi, weight, 0, kelvin_.displacement(r), kelvin_.traction(r, n));
        });
    return points;
}

InsideSums<2> PlaneBoundaryElements::inside_sums(const Vec<2>& X) const {
    InsideSums<2> sums{MatX::Zero(6, 2 * system_.slot_count()), MatX::Zero(6, 2 * system_.node_count())};
    for (Index k = 0; k < static_cast<Index>(curve_->elements().size()); ++k) {
        const BoundaryElement& e = curve_->elements()[static_cast<std::size_t>(k)];
        integrate(e, X, -1, 1, 0, [&](Real xi, Real weight, const Vec<2>& r, const Vec<2>& n) {
            const Vec<3> N = e.values(xi);
            add_inside_terms(kelvin_, weight, r, n, [&](const auto& t, const auto& u) {
                for (int a = 0; a < e.count; ++a) {
                    sums.of_traction.middleCols<2>(2 * system_.slot_of(k, a)) += N[a] * t;
                    sums.of_displacement.middleCols<2>(2 * e.nodes[static_cast<std::size_t>(a)]) += N[a] * u;
                }
            });
        });
    }
    return sums;
}

// ----------------------------------------------------------------------------------------------------------- reading it off

Vec<2> PlaneBoundaryElements::traction_at(const Solution& s, Index element, Real xi) const {
    const BoundaryElement& e = curve_->elements()[static_cast<std::size_t>(element)];
    const Vec<3> N = e.values(xi);
    Vec<2> t = Vec<2>::Zero();
    for (int a = 0; a < e.count; ++a) t += N[a] * s.traction.col(system_.slot_of(element, a));
    return t;
}

Vec<2> PlaneBoundaryElements::boundary_displacement(const Solution& s, Index element, Real xi) const {
    const BoundaryElement& e = curve_->elements()[static_cast<std::size_t>(element)];
    const Vec<3> N = e.values(xi);
    Vec<2> u = Vec<2>::Zero();
    for (int a = 0; a < e.count; ++a) u += N[a] * s.displacement.col(e.nodes[static_cast<std::size_t>(a)]);
    return u;
}

Mat<2> PlaneBoundaryElements::boundary_stress(const Solution& s, Index element, Real xi) const {
    const auto& elements = curve_->elements();
    const BoundaryElement& e = elements[static_cast<std::size_t>(element)];
    const Vec<2> along = e.tangent(xi), tangent = along.normalized(), normal = e.normal(xi), t = traction_at(s, element, xi);
    // Change of the displacement along the boundary; of constant elements from the neighbours.
    Vec<2> slope = Vec<2>::Zero();
    if (e.count == 1) {
        const int before = elements[static_cast<std::size_t>(e.before)].nodes[0],
                  after = elements[static_cast<std::size_t>(e.after)].nodes[0];
        const Real way = (curve_->nodes().col(e.nodes[0]) - curve_->nodes().col(before)).norm() +
                         (curve_->nodes().col(after) - curve_->nodes().col(e.nodes[0])).norm();
        slope = (s.displacement.col(after) - s.displacement.col(before)) / way;
    } else {
        const Vec<3> slopes = e.slopes(xi);
        for (int a = 0; a < e.count; ++a)
            slope += slopes[a] / along.norm() * s.displacement.col(e.nodes[static_cast<std::size_t>(a)]);
    }
    const Real stretch = slope.dot(tangent), pull = t.dot(normal), shear = t.dot(tangent);
    const Real stiff = material_.lambda + 2 * material_.mu;
    const Real hoop = stiff * stretch + material_.lambda * (pull - material_.lambda * stretch) / stiff;
    return pull * normal * normal.transpose() + hoop * tangent * tangent.transpose() +
           shear * (normal * tangent.transpose() + tangent * normal.transpose());
}

Vec<2> PlaneBoundaryElements::displacement(const Solution& s, const Vec<2>& X) const { return inside_sums(X).displacement(s); }

Mat<2> PlaneBoundaryElements::stress(const Solution& s, const Vec<2>& X) const { return inside_sums(X).stress(s); }

Real PlaneBoundaryElements::distance(const Vec<2>& X) const {
    Real least = std::numeric_limits<Real>::infinity();
    for (const BoundaryElement& e : curve_->elements()) {
        const Nearness near = nearness(e, X, -1, 1);
        least = std::min(least, near.distance / near.length);
    }
    return least;
}

}  // namespace pliant
