// A disc cut into triangles.
#pragma once
#include <pliant/mesh/simplex_mesh.h>

namespace pliant {

// Triangles between so many concentric rings around `centre` [m]: ring k has 6 k nodes, evenly spaced from the direction of x on,
// and node 0 is the centre. Throws Refused for a radius that is not positive and finite, or less than one ring.
SimplexMesh<2> disc_mesh(Real radius, int rings, const Vec<2>& centre = Vec<2>::Zero());

}  // namespace pliant
