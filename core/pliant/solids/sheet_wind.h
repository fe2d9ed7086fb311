// The drag of moving air on a sheet of triangles.
#pragma once
#include <pliant/mesh/lattice.h>
#include <pliant/solids/springs.h>

namespace pliant {

struct Air {
    Vec<3> velocity = Vec<3>::Zero();  // m/s, of the wind
    Real density = 1.2;                // kg/m^3
    Real drag = 1;                     // coefficient of the pressure on a plate, >= 0
};

// Each triangle feels 1/2 rho c A (u . n)|u . n| n, with u = wind - mean velocity of its nodes, area A and unit normal n: the air
// presses on what stands across it and slides along the rest [Ling1996]. A third of it acts on each node, linearised as
//   f_i = C_i (wind - v_i),   C_i = sum over its triangles of (rho c / 6) A |u . n| n n^T,
// so that an implicit step can take C_i from its start and v_i from its end, and no wind is too strong for it. drag: C_i, N s/m,
// one per node. Triangles without area feel nothing.
void wind_drag(const std::vector<NodeTriple>& triangles, const Air& air, PointsIn<3> x, PointsIn<3> v, std::vector<Mat<3>>& drag);

// What one triangle adds to C_i of each of its corners a, b, c (columns), with velocities in the columns of v.
Mat<3> triangle_drag(const Air& air, const Mat<3>& corners, const Mat<3>& v);

}  // namespace pliant
