#include <pliant/math/error.h>
#include <pliant/mesh/simplex_quadrature.h>
#include <pliant/solids/follower_pressure.h>
#include <Eigen/Geometry>

#include <fmt/format.h>

namespace pliant {
namespace {

// Slopes of the shape functions of a facet along its edges from corner 0, one row per node.
template <int Size, int Order>
MatX facet_slopes(const Vec<Size + 1>& l) {
    constexpr int nodes = simplex_nodes(Size, Order);
    Eigen::Matrix<Real, nodes, Size + 1> by_coordinate;
    by_coordinate.setZero();
    for (int a = 0; a <= Size; ++a) by_coordinate(a, a) = Order == 1 ? 1 : 4 * l[a] - 1;
    for (int k = 0; k < nodes - (Size + 1); ++k) {
        const auto [a, b] = simplex_edges[static_cast<std::size_t>(k)];
        by_coordinate(Size + 1 + k, a) = 4 * l[b];
        by_coordinate(Size + 1 + k, b) = 4 * l[a];
    }
    MatX slopes(nodes, Size);
    for (int k = 0; k < Size; ++k) slopes.col(k) = by_coordinate.col(k + 1) - by_coordinate.col(0);
    return slopes;
}

// Outward area per area of the reference facet, which has a half in space.
template <int Dim>
Vec<Dim> area_vector(const Eigen::Matrix<Real, Dim, Dim - 1>& tangents) {
    if constexpr (Dim == 2)
        return {tangents(1, 0), -tangents(0, 0)};
    else
        return tangents.col(0).cross(tangents.col(1)) / 2;
}

}  // namespace

template <int Dim>
template <int Order>
FollowerPressure<Dim>::FollowerPressure(const SimplexElements<Dim, Order>& elements, const FacetSet& facets, Real pressure_in)
    : pressure(pressure_in), facets_(elements.facets().rows(), static_cast<Index>(facets.size())) {
    for (std::size_t f = 0; f < facets.size(); ++f) facets_.col(static_cast<Index>(f)) = elements.facets().col(facets[f]);
    // The shape function, and the slopes of the Dim - 1 tangents.
    const SimplexRule<Dim - 1> rule = simplex_rule<Dim - 1>(Order + (Order - 1) * (Dim - 1));
    weights_.resize(facets_.rows(), rule.weights.size());
    for (Index q = 0; q < rule.weights.size(); ++q) {
        const Vec<Dim> l = rule.barycentric.col(q);
        weights_.col(q) = rule.weights[q] * simplex_shape<Dim - 1, Order>(l);
        shapes_.push_back(facet_slopes<Dim - 1, Order>(l));
    }
}

template <int Dim>
void FollowerPressure<Dim>::add_forces(PointsIn<Dim> x, PointsOut<Dim> force) const {
    for (Index f = 0; f < facets_.cols(); ++f)
        for (Index q = 0; q < weights_.cols(); ++q) {
            Eigen::Matrix<Real, Dim, Dim - 1> tangents;
            tangents.setZero();
            const MatX& slopes = shapes_[static_cast<std::size_t>(q)];
            for (Index a = 0; a < facets_.rows(); ++a) tangents += x.col(facets_(a, f)) * slopes.row(a);
            const Vec<Dim> push = -pressure * area_vector<Dim>(tangents);
            for (Index a = 0; a < facets_.rows(); ++a) force.col(facets_(a, f)) += weights_(a, q) * push;
        }
}

template <int Dim>
Index solve_under_pressure(NewtonEquilibrium<Dim>& newton, const FollowerPressure<Dim>& pressure, const Points<Dim>& rest,
                           const Points<Dim>& u0, const Points<Dim>& force, const DisplacementConstraints<Dim>& constraints,
                           Real tolerance, Index most) {
    Points<Dim> pressing = Points<Dim>::Zero(Dim, rest.cols()), next = pressing;
    pressure.add_forces(rest + u0, pressing);
    newton.begin(u0, force + pressing, constraints);
    Real change = 0;
    for (Index k = 1; k <= most; ++k) {
        newton.solve();
        newton.require_convergence();
        next.setZero();
        pressure.add_forces(rest + newton.displacement(), next);
        change = (next - pressing).norm();
        if (change <= tolerance * next.norm()) return k;
        change /= next.norm();
        pressing = next;
        newton.begin(Points<Dim>(newton.displacement()), force + pressing, constraints);
    }
    Failure failure;
    failure.kind = FailureKind::not_converged;
    failure.field = "pressure";
    failure.what = fmt::format("the pressure and the shape do not settle: after {} equilibria the force still changes by {:.3g}",
                               most, change);
    failure.limit = fmt::format("{:.3g}: let the pressure grow in smaller steps", tolerance);
    failure.value = change;
    failure.bound = tolerance;
    throw Diverged(failure);
}

#define PLIANT_INSTANTIATE(Dim)                                                                                            \
    template class FollowerPressure<Dim>;                                                                                  \
    template FollowerPressure<Dim>::FollowerPressure(const SimplexElements<Dim, 1>&, const FacetSet&, Real);               \
    template FollowerPressure<Dim>::FollowerPressure(const SimplexElements<Dim, 2>&, const FacetSet&, Real);               \
    template Index solve_under_pressure(NewtonEquilibrium<Dim>&, const FollowerPressure<Dim>&, const Points<Dim>&,         \
                                        const Points<Dim>&, const Points<Dim>&, const DisplacementConstraints<Dim>&, Real, \
                                        Index)
PLIANT_INSTANTIATE(2);
PLIANT_INSTANTIATE(3);
#undef PLIANT_INSTANTIATE

}  // namespace pliant
