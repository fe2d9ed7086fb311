// A box cut into cells, and every cell into simplices.
#pragma once
#include <pliant/mesh/simplex_mesh.h>

#include <array>

namespace pliant {

enum class CellSplit {
    // Neighbouring cells are mirror images of each other, so that no direction is preferred: 2 triangles with alternating
    // diagonals, or 5 tetrahedra (four corners cut off around a regular one).
    alternating,
    // Every cell alike, cut along its diagonal from the lowest to the highest corner: 2 triangles, or 6 tetrahedra of equal
    // volume [Kuhn1960].
    diagonal,
};

template <int Dim>
struct BlockShape {
    Vec<Dim> size = Vec<Dim>::Ones();    // m, each > 0
    std::array<int, Dim> cells{};        // along each axis, each >= 1
    Vec<Dim> origin = Vec<Dim>::Zero();  // m, the corner with the smallest coordinates
    CellSplit split = CellSplit::alternating;
};

// Nodes count fastest along x, then y, then z; simplices cell by cell in the same order. The node and facet sets "x_min",
// "x_max", "y_min", ... are the faces of the box. Throws Refused when a size or a count is out of range.
template <int Dim>
SimplexMesh<Dim> block_mesh(const BlockShape<Dim>& block);

}  // namespace pliant
