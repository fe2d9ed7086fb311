// A pressure on the surface of a deforming body: it stays normal to it and acts on the area that there is now.
#pragma once
#include <pliant/solids/fem_loads.h>
#include <pliant/solids/newton_equilibrium.h>
#include <pliant/solids/springs.h>

namespace pliant {

template <int Dim>
class FollowerPressure {
public:
    // Facets of elements of either order; what the elements are is copied.
    template <int Order>
    FollowerPressure(const SimplexElements<Dim, Order>& elements, const FacetSet& facets, Real pressure);

    Real pressure = 0;  // Pa, inward where positive

    // Adds -p times the integral of each shape function over the outward area at positions x [m], N; on curved facets by a rule
    // that is exact. In 2D per metre of thickness.
    void add_forces(PointsIn<Dim> x, PointsOut<Dim> force) const;

private:
    Eigen::MatrixXi facets_;    // nodes, one column each
    std::vector<MatX> shapes_;  // of each point of the rule: slopes of the shape functions along the facet, one column each, and
    MatX weights_;              // values × weight, one column each
};

// Static equilibrium under constant forces [N] and the pressure, from u0 [m]: what the pressure does at one equilibrium loads the
// next one, until that changes it by no more than `tolerance`, relative. Throws Diverged as require_convergence does, or when
// `most` equilibria do not suffice: the pressure then has to grow in smaller steps, or the body buckles. Returns how many it
// took.
template <int Dim>
Index solve_under_pressure(NewtonEquilibrium<Dim>& newton, const FollowerPressure<Dim>& pressure, const Points<Dim>& rest,
                           const Points<Dim>& u0, const Points<Dim>& force, const DisplacementConstraints<Dim>& constraints,
                           Real tolerance = 1e-8, Index most = 100);

}  // namespace pliant
