// Mass matrices of finite elements.
#pragma once
#include <pliant/mesh/simplex_elements.h>

namespace pliant {

// What each node has of the mass, kg (in 2D per metre of thickness), with the shares of SimplexElements::lumped_shares().
// density: kg/m^3. Throws Refused for a density that is not positive and finite.
template <int Dim, int Order>
VecX lumped_mass(const SimplexElements<Dim, Order>& elements, Real density);

// The consistent one: integrals of the products of two shape functions, for each component of a node alike; kg. With the pattern
// of ElementAssembly, which is that of the stiffness.
template <int Dim, int Order>
SparseMatrix consistent_mass(const SimplexElements<Dim, Order>& elements, Real density);

}  // namespace pliant
