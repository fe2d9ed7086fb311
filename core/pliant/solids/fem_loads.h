// Forces on the nodes that do the same work as distributed loads: each node takes the load weighted by its shape function
// [Hughes2000 §2.9]. All add to `force` (Dim × nodes, N; in 2D per metre of thickness).
#pragma once
#include <pliant/mesh/simplex_mesh.h>

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

}  // namespace pliant
