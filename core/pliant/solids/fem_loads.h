// Forces on the nodes that do the same work as distributed loads: each node takes the load weighted by its shape function
// [Hughes2000 §2.9]. All add to `force` (Dim × nodes, N; in 2D per metre of thickness).
#pragma once
#include <pliant/mesh/simplex_elements.h>

#include <functional>

namespace pliant {

using FacetSet = std::vector<Index>;  // boundary facets of a mesh

// Traction [Pa], a force per rest area.
template <int Dim>
void add_traction(const SimplexMesh<Dim>& mesh, const FacetSet& facets, const Vec<Dim>& traction, Points<Dim>& force);

// Pressure [Pa] that pushes inward where positive.
template <int Dim>
void add_pressure(const SimplexMesh<Dim>& mesh, const FacetSet& facets, Real pressure, Points<Dim>& force);

// The traction stress · n of a uniform stress [Pa], n the outward normal of each facet.
template <int Dim>
void add_boundary_stress(const SimplexMesh<Dim>& mesh, const FacetSet& facets, const Mat<Dim>& stress, Points<Dim>& force);

// Loads that vary with the rest position X [m], as a polynomial of at most the given degree: traction [Pa] on facets, and force
// per volume [N/m^3] in all elements. Other functions are integrated with the rule that is exact for that degree.
template <int Dim>
using LoadFunction = std::function<Vec<Dim>(const Vec<Dim>& X)>;
template <int Dim>
void add_traction(const SimplexMesh<Dim>& mesh, const FacetSet& facets, const LoadFunction<Dim>& traction, int degree,
                  Points<Dim>& force);
template <int Dim>
void add_body_force(const SimplexMesh<Dim>& mesh, const LoadFunction<Dim>& force_density, int degree, Points<Dim>& force);

// The same on elements of either order; `force` has a column for each of their nodes. On those of second order a constant
// traction gives nothing to the corners of a triangle and a third to the middle of each edge, and on an edge a sixth to the ends.
template <int Dim, int Order>
void add_traction(const SimplexElements<Dim, Order>& elements, const FacetSet& facets, const Vec<Dim>& traction,
                  Points<Dim>& force);
template <int Dim, int Order>
void add_pressure(const SimplexElements<Dim, Order>& elements, const FacetSet& facets, Real pressure, Points<Dim>& force);
template <int Dim, int Order>
void add_boundary_stress(const SimplexElements<Dim, Order>& elements, const FacetSet& facets, const Mat<Dim>& stress,
                         Points<Dim>& force);
template <int Dim, int Order>
void add_traction(const SimplexElements<Dim, Order>& elements, const FacetSet& facets, const LoadFunction<Dim>& traction,
                  int degree, Points<Dim>& force);
template <int Dim, int Order>
void add_body_force(const SimplexElements<Dim, Order>& elements, const LoadFunction<Dim>& force_density, int degree,
                    Points<Dim>& force);

// Shares of the nodes of a facet in a load that is constant over it; they sum to 1.
template <int Dim, int Order>
Vec<simplex_nodes(Dim - 1, Order)> facet_shares() {
    Vec<simplex_nodes(Dim - 1, Order)> shares;
    if constexpr (Order == 1)
        shares.setConstant(Real{1} / Dim);
    else if constexpr (Dim == 2)
        shares << Real{1} / 6, Real{1} / 6, Real{2} / 3;
    else
        shares << 0, 0, 0, Real{1} / 3, Real{1} / 3, Real{1} / 3;
    return shares;
}

}  // namespace pliant
