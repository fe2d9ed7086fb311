// Quadrature on segments, triangles and tetrahedra.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

// Points in barycentric coordinates (Dim + 1 numbers per column, which sum to 1) and weights that sum to 1, so that the integral
// of f over a simplex is volume × sum of weight × f(point). All points lie inside and all weights are positive.
template <int Dim>
struct SimplexRule {
    Points<Dim + 1> barycentric;
    VecX weights;
};

// Exact for polynomials up to `degree`: Gauss points of a cube, collapsed onto the simplex [Stroud1971]. Throws Refused for
// a degree outside [0, 30].
template <int Dim>
SimplexRule<Dim> simplex_rule(int degree);

// Gauss-Legendre points and weights on [0, 1]; exact up to degree 2 count - 1.
struct GaussRule {
    VecX points, weights;
};
GaussRule gauss_legendre(int count);

}  // namespace pliant
