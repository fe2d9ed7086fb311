// The body of a lesson as cells over points, for files that other programs read.
#pragma once
#include <pliant/lesson/array.h>
#include <pliant/math/types.h>

#include <vector>

namespace pliant {

// With the numbers of nodes 1, 2, 3, 4, 4, 8, and with the middles of edges 3, 6, 10. Nodes stand as in VTK [VTK2006]: a
// quadrangle goes round, a hexahedron round its bottom and then round its top; middles follow the corners, of the edges 01, 12,
// 20, 03, 13, 23.
enum class CellKind { vertex, line, triangle, quadrangle, tetrahedron, hexahedron, line3, triangle6, tetrahedron10 };
int nodes_of(CellKind kind);

struct CellBlock {
    CellKind kind = CellKind::vertex;
    Eigen::MatrixXi nodes{};  // a column each, of points
};

struct UnstructuredGrid {
    Points<3> points;  // m, where they are now
    std::vector<CellBlock> cells{};
    std::vector<On> on_points{On::node};  // fields on these have a number for each point, in order
    std::vector<On> on_cells{};           // fields on these have one for each cell
    Index cell_count() const;
    // Is a field of so many rows one of the points, or of the cells?
    bool of_points(On on, Index rows) const;
    bool of_cells(On on, Index rows) const;
};

// Points in a plane, or along a line, with 0 for what they lack. `points`: a column each.
Points<3> in_space(const Eigen::Ref<const MatX>& points);
// Points that belong together in pairs (springs), or in any other cells of one kind.
UnstructuredGrid grid_of(Points<3> points, CellKind kind, Eigen::MatrixXi nodes, std::vector<On> on_cells);
// A point each, and no more.
UnstructuredGrid grid_of_points(Points<3> points, std::vector<On> on_points);
// nx × ny cells (nx × ny × nz with nz > 0) of a regular grid, x counting first, with fields on the cells. `corner`: the lowest.
UnstructuredGrid regular_grid(const Vec<3>& corner, const Vec<3>& spacing, Index nx, Index ny, Index nz,
                              std::vector<On> on_cells);

}  // namespace pliant
