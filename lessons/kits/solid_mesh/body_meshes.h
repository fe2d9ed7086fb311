// The meshes of lessons about elastic bodies. Each has the sets "fixed" and "loaded" of boundary facets.
#pragma once
#include "solid.h"

namespace pliant::solid_mesh {

// A box with its left face fixed and its right face loaded, every cell cut into six tetrahedra [Kuhn1960].
SimplexMesh<3> beam_mesh(const Vec<3>& size, const std::array<int, 3>& cells);
// A rectangle with its left edge fixed and its right one loaded, cut like a chessboard: its diagonals alternate.
SimplexMesh<2> panel_mesh(const Vec<2>& size, int cells_x, int cells_y);
// Cook's membrane [Cook1974], 48 m long; fixed at its left edge, loaded at its right one.
SimplexMesh<2> cook_mesh(int cells_x, int cells_y);
// The unit square, fixed at all edges; nothing is loaded.
SimplexMesh<2> square_mesh(int cells_x, int cells_y);

}  // namespace pliant::solid_mesh
