#include <pliant/math/error.h>
#include <pliant/mesh/simplex_elements.h>
#include <pliant/mesh/simplex_quadrature.h>
#include <pliant/solids/bem/space_boundary_elements.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace pliant {
namespace {

constexpr int most_quarterings = 8;  // quarterings of a triangle near the source
constexpr int duffy_points = 6;      // along each axis of a triangle that holds the source

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

Eigen::Matrix<Real, 6, 1> quadratic_shape(const Vec<3>& L) { return SimplexElements<2, 2>::shape(L); }

}  // namespace

SpaceBoundaryElements::SpaceBoundaryElements(Points<3> corners, Triangles triangles, const Lame& material, bool unbounded,
                                             BoundaryOrder order, const std::function<Vec<3>(const Vec<3>&)>& onto_surface)
    : order_(order),
      curved_(onto_surface != nullptr),
      triangles_(std::move(triangles)),
      shape_points_(std::move(corners)),
      shape_(6, triangles_.cols()),
      areas_(triangles_.cols()),
      kelvin_(material),
      system_(make_system(material, unbounded, onto_surface)) {}

BoundarySystem<3> SpaceBoundaryElements::make_system(const Lame& material, bool unbounded,
                                                     const std::function<Vec<3>(const Vec<3>&)>& onto_surface) {
    require_closed_surface(shape_points_, triangles_);
    bend(onto_surface);
    number_nodes();
    return {node_points_, elements(), material, unbounded};
}

// Middles of edges behind the corners, one for the two triangles that share an edge.
void SpaceBoundaryElements::bend(const std::function<Vec<3>(const Vec<3>&)>& onto_surface) {
    std::map<std::pair<int, int>, int> middles;
    std::vector<Vec<3>> added;
    const auto first = static_cast<int>(shape_points_.cols());
    for (Index t = 0; t < triangles_.cols(); ++t) {
        shape_.col(t).head<3>() = triangles_.col(t);
        for (int k = 0; k < 3; ++k) {
            const auto [i, j] = simplex_edges[static_cast<std::size_t>(k)];
            const int a = triangles_(i, t), b = triangles_(j, t);
            const auto [place, is_new] =
                middles.try_emplace({std::min(a, b), std::max(a, b)}, first + static_cast<int>(added.size()));
            if (is_new) {
                const Vec<3> straight = (shape_points_.col(a) + shape_points_.col(b)) / 2;
                added.push_back(curved_ ? onto_surface(straight) : straight);
            }
            shape_(3 + k, t) = place->second;
        }
    }
    shape_points_.conservativeResize(3, first + static_cast<Index>(added.size()));
    for (std::size_t k = 0; k < added.size(); ++k) shape_points_.col(first + static_cast<Index>(k)) = added[k];
}

// The corners, all points, or the middles of the triangles.
void SpaceBoundaryElements::number_nodes() {
    nodes_ = shape_;
    if (order_ == BoundaryOrder::quadratic) return void(node_points_ = shape_points_);
    if (order_ == BoundaryOrder::linear) return void(node_points_ = shape_points_.leftCols(triangles_.maxCoeff() + 1));
    node_points_.resize(3, triangles_.cols());
    for (Index t = 0; t < triangles_.cols(); ++t) nodes_(0, t) = static_cast<int>(t), node_points_.col(t) = middle(t);
}

std::vector<BoundarySystem<3>::Element> SpaceBoundaryElements::elements() {
    const SimplexRule<2> rule = simplex_rule<2>(curved_ ? 8 : 2);
    std::vector<BoundarySystem<3>::Element> list;
    for (Index t = 0; t < triangles_.cols(); ++t) {
        BoundarySystem<3>::Element e{.count = nodes_per_triangle()};
        for (int a = 0; a < e.count; ++a) e.nodes[static_cast<std::size_t>(a)] = nodes_(a, t);
        areas_[t] = 0;
        for (Index q = 0; q < rule.weights.size(); ++q) {
            const Real weight = rule.weights[q] * place(t, rule.barycentric.col(q)).area.norm() / 2;
            const Shape N = shape(rule.barycentric.col(q));
            e.products += weight * N * N.transpose();
            areas_[t] += weight;
        }
        list.push_back(e);
    }
    return list;
}

// Their first two columns: change of the point with the first and the second barycentric coordinate, the third making up for it.
Mat<3> SpaceBoundaryElements::tangents(Index triangle, const Vec<3>& L) const {
    const auto p = [&](int a) -> Vec<3> { return shape_points_.col(shape_(a, triangle)); };
    Mat<3> tangent = Mat<3>::Zero();
    if (!curved_) {
        tangent.col(0) = p(0) - p(2), tangent.col(1) = p(1) - p(2);
        return tangent;
    }
    const Vec<3> of_third = (4 * L[2] - 1) * p(2) + 4 * L[1] * p(4) + 4 * L[0] * p(5);
    tangent.col(0) = (4 * L[0] - 1) * p(0) + 4 * L[1] * p(3) + 4 * L[2] * p(5) - of_third;
    tangent.col(1) = (4 * L[1] - 1) * p(1) + 4 * L[0] * p(3) + 4 * L[2] * p(4) - of_third;
    return tangent;
}

SpaceBoundaryElements::Place SpaceBoundaryElements::place(Index triangle, const Vec<3>& L) const {
    const Mat<3> tangent = tangents(triangle, L);
    Place at{Vec<3>::Zero(), tangent.col(0).cross(tangent.col(1))};
    if (curved_) {
        const Shape N = quadratic_shape(L);
        for (int a = 0; a < 6; ++a) at.point += N[a] * shape_points_.col(shape_(a, triangle));
    } else {
        for (int a = 0; a < 3; ++a) at.point += L[a] * shape_points_.col(shape_(a, triangle));
    }
    return at;
}

SpaceBoundaryElements::Shape SpaceBoundaryElements::shape(const Vec<3>& L) const {
    Shape N = Shape::Zero();
    if (order_ == BoundaryOrder::constant) N[0] = 1;
    if (order_ == BoundaryOrder::linear) N.head<3>() = L;
    return order_ == BoundaryOrder::quadratic ? quadratic_shape(L) : N;
}

Vec<3> SpaceBoundaryElements::barycentric_of_node(int a) const {
    if (order_ == BoundaryOrder::constant) return Vec<3>::Constant(1.0 / 3);
    if (a < 3) return Vec<3>::Unit(a);
    const auto [i, j] = simplex_edges[static_cast<std::size_t>(a - 3)];
    return (Vec<3>::Unit(i) + Vec<3>::Unit(j)) / 2;
}

Vec<3> SpaceBoundaryElements::normal(Index triangle) const {
    return place(triangle, Vec<3>::Constant(1.0 / 3)).area.normalized();
}
Vec<3> SpaceBoundaryElements::normal_at_node(Index triangle, int a) const {
    return place(triangle, barycentric_of_node(a)).area.normalized();
}
Vec<3> SpaceBoundaryElements::middle(Index triangle) const { return place(triangle, Vec<3>::Constant(1.0 / 3)).point; }

// visit(barycentric coordinates, weight [m^2], r, n): sum of f × weight is the integral of f over the part, which takes this
// share of the triangle's coordinates.
template <class Visit>
void SpaceBoundaryElements::integrate(Index triangle, const Barycentric& part, Real share, const Vec<3>& X, int depth,
                                      Visit visit) const {
    Mat<3> corners;
    for (int a = 0; a < 3; ++a) corners.col(a) = place(triangle, part.col(a)).point;
    const TriangleNearness near = nearness(corners, X);
    if (near.distance < 0.7 * near.length && depth < most_quarterings) {
        for (int a = 0; a < 4; ++a) {
            Barycentric quarter;
            for (int b = 0; b < 3; ++b)
                quarter.col(b) =
                    a < 3 ? Vec<3>((part.col(a) + part.col(b)) / 2) : Vec<3>((part.col(b) + part.col((b + 1) % 3)) / 2);
            integrate(triangle, quarter, share / 4, X, depth + 1, visit);
        }
        return;
    }
    const SimplexRule<2>& rule = rule_for(near.distance / near.length);
    for (Index q = 0; q < rule.weights.size(); ++q) {
        const Vec<3> L = part * rule.barycentric.col(q);
        const Place at = place(triangle, L);
        const Real size = at.area.norm();
        visit(L, share * rule.weights[q] * size / 2, Vec<3>(at.point - X), Vec<3>(at.area / size));
    }
}

// Duffy's coordinates in each of the parts between the source and an edge: source + s ((1 - t) p + t q), whose Jacobian takes
// away what grows like 1/s; T is met by shape functions that vanish at the source [Duffy1982].
template <class Visit>
void SpaceBoundaryElements::integrate_own(Index triangle, const Vec<3>& source, const Vec<3>& X, Visit visit) const {
    static const GaussRule rule = gauss_legendre(duffy_points);
    for (int k = 0; k < 3; ++k) {
        const Real share = source[(k + 2) % 3];  // of the part beside the edge from corner k to the next
        if (share < 1e-12) continue;
        const Vec<3> p = Vec<3>::Unit(k) - source, q = Vec<3>::Unit((k + 1) % 3) - source;
        for (Index i = 0; i < rule.points.size(); ++i)
            for (Index j = 0; j < rule.points.size(); ++j) {
                const Real s = rule.points[i], t = rule.points[j];
                const Vec<3> L = source + s * ((1 - t) * p + t * q);
                const Place at = place(triangle, L);
                const Real size = at.area.norm();
                visit(L, rule.weights[i] * rule.weights[j] * s * share * size, Vec<3>(at.point - X), Vec<3>(at.area / size));
            }
    }
}

void SpaceBoundaryElements::assemble() {
    for (Index n = 0; n < system_.node_count(); ++n) assemble(n);
}

void SpaceBoundaryElements::integrate(Index node) {
    system_.begin_rows(node);
    for (Index t = 0; t < triangles_.cols(); ++t) integrate_beside(t, node);
}

void SpaceBoundaryElements::integrate_beside(Index triangle, Index node) {
    const int count = nodes_per_triangle(), own = own_of(triangle, node);
    std::array<Mat<3>, 6> T, U;
    T.fill(Mat<3>::Zero()), U.fill(Mat<3>::Zero());
    const Vec<3> X = system_.nodes().col(node);
    const auto add = [&](const Vec<3>& L, Real weight, const Vec<3>& r, const Vec<3>& n) {
        const Mat<3> traction = weight * kelvin_.traction(r, n), displacement = weight * kelvin_.displacement(r);
        const Shape N = shape(L);
        for (int a = 0; a < count; ++a)
            T[static_cast<std::size_t>(a)] += N[a] * traction, U[static_cast<std::size_t>(a)] += N[a] * displacement;
    };
    own < 0 ? integrate(triangle, Barycentric::Identity(), 1, X, 0, add)
            : integrate_own(triangle, barycentric_of_node(own), X, add);
    for (int a = 0; a < count; ++a) {
        if (a != own) system_.add_traction(node, nodes_(a, triangle), T[static_cast<std::size_t>(a)]);
        system_.add_displacement(node, system_.slot_of(triangle, a), U[static_cast<std::size_t>(a)]);
    }
}

int SpaceBoundaryElements::own_of(Index triangle, Index node) const {
    for (int a = 0; a < nodes_per_triangle(); ++a)
        if (nodes_(a, triangle) == node) return a;
    return -1;
}

std::vector<BoundaryIntegrationPoint<3>> SpaceBoundaryElements::integration_points(Index triangle, Index node) const {
    std::vector<BoundaryIntegrationPoint<3>> points;
    const Vec<3> X = system_.nodes().col(node);
    const auto add = [&](const Vec<3>& L, Real weight, const Vec<3>& r, const Vec<3>& n) {
        points.push_back({shape(L), weight, kelvin_.displacement(r), kelvin_.traction(r, n)});
    };
    const int own = own_of(triangle, node);
    own < 0 ? integrate(triangle, Barycentric::Identity(), 1, X, 0, add)
            : integrate_own(triangle, barycentric_of_node(own), X, add);
    return points;
}

InsideSums<3> SpaceBoundaryElements::inside_sums(const Vec<3>& X) const {
    InsideSums<3> sums{MatX::Zero(12, 3 * system_.slot_count()), MatX::Zero(12, 3 * system_.node_count())};
    for (Index k = 0; k < triangles_.cols(); ++k)
        integrate(k, Barycentric::Identity(), 1, X, 0, [&](const Vec<3>& L, Real weight, const Vec<3>& r, const Vec<3>& n) {
            const Shape N = shape(L);
            add_inside_terms(kelvin_, weight, r, n, [&](const auto& t, const auto& u) {
                for (int a = 0; a < nodes_per_triangle(); ++a) {
                    sums.of_traction.middleCols<3>(3 * system_.slot_of(k, a)) += N[a] * t;
                    sums.of_displacement.middleCols<3>(3 * nodes_(a, k)) += N[a] * u;
                }
            });
        });
    return sums;
}

// ----------------------------------------------------------------------------------------------------------- reading it off

Mat<3> SpaceBoundaryElements::boundary_stress(const BoundarySolution<3>& s, Index triangle) const {
    const Vec<3> L = Vec<3>::Constant(1.0 / 3), n = normal(triangle);
    // How the displacement changes along the tangents, then per metre within the plane that touches.
    Mat<3> along = Mat<3>::Zero(), tangent = tangents(triangle, L);
    tangent.col(2) = n;
    const auto u = [&](int a) -> Vec<3> { return s.displacement.col(nodes_(a, triangle)); };
    if (order_ == BoundaryOrder::linear)
        along.col(0) = u(0) - u(2), along.col(1) = u(1) - u(2);
    else
        along.col(0) = (u(0) - u(2) + 4 * (u(3) - u(4))) / 3, along.col(1) = (u(1) - u(2) + 4 * (u(3) - u(5))) / 3;
    const Mat<3> flat = Mat<3>::Identity() - n * n.transpose(), gradient = along * tangent.inverse() * flat;
    const Mat<3> strain = flat * (gradient + gradient.transpose()) * flat / 2;
    Vec<3> t = Vec<3>::Zero();
    const Shape N = shape(L);
    for (int a = 0; a < nodes_per_triangle(); ++a) t += N[a] * s.traction.col(system_.slot_of(triangle, a));
    const Real mu = kelvin_.shear_modulus(), lambda = 2 * mu * kelvin_.poisson_ratio() / (1 - 2 * kelvin_.poisson_ratio());
    const Real across = (t.dot(n) - lambda * strain.trace()) / (lambda + 2 * mu);
    const Vec<3> shear = flat * t;
    return 2 * mu * strain + lambda * (strain.trace() + across) * flat + t.dot(n) * n * n.transpose() + shear * n.transpose() +
           n * shear.transpose();
}

Vec<3> SpaceBoundaryElements::displacement(const BoundarySolution<3>& s, const Vec<3>& X) const {
    return inside_sums(X).displacement(s);
}

Mat<3> SpaceBoundaryElements::stress(const BoundarySolution<3>& s, const Vec<3>& X) const { return inside_sums(X).stress(s); }

}  // namespace pliant
