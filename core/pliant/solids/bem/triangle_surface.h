// Surfaces of triangles.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

using SurfaceTriangles = Eigen::Matrix<int, 3, Eigen::Dynamic>;  // numbers of corners, anticlockwise seen from outside the body

// Throws Refused, naming the triangle, for one without area, a corner out of range, or an edge that does not belong to two
// triangles that run along it in opposite directions.
void require_closed_surface(const Points<3>& corners, const SurfaceTriangles& triangles);

struct SphereSurface {
    Points<3> corners;  // on the sphere of radius 1 m about the origin
    SurfaceTriangles triangles;
};
// An icosahedron whose edges are cut into so many parts: 20 parts² triangles. from_inside: the body lies around it, so that the
// triangles run anticlockwise as the wall of a cavity is seen.
SphereSurface sphere_surface(int parts, bool from_inside);

}  // namespace pliant
