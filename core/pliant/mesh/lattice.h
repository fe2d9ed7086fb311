// Rectangular lattices of nodes, and the pairs of nodes that mass-spring nets join, by family. An axis with no cells holds
// one layer of nodes, so that a chain, a sheet and a block are the same thing: cells {n, 0, 0}, {n, m, 0} and {n, m, l}.
#pragma once
#include <pliant/math/types.h>

#include <array>
#include <vector>

namespace pliant {

using NodePair = std::array<Index, 2>;
using NodeTriple = std::array<Index, 3>;

template <int Dim>
class NodeLattice {
public:
    using Cells = std::array<Index, Dim>;

    // cells: cells along each axis, 0 for a single layer of nodes; spacing: edge lengths of one cell, m; origin: the corner
    // with the smallest coordinates, m. Throws Refused when a count is negative or too large, a spacing is not positive, or
    // a number is not finite.
    NodeLattice(const Cells& cells, const Vec<Dim>& spacing, const Vec<Dim>& origin = Vec<Dim>::Zero());

    const Cells& cells() const { return cells_; }
    Index node_count() const { return stride_[Dim]; }
    // Node numbers run fastest along the first axis.
    Index node(const Cells& position) const;
    Cells position(Index node) const;

    Points<Dim> points() const;  // m

    // The families that mass-spring bodies are built from [Nealen2006 §3]: neighbours along the axes resist stretching, the
    // diagonals of faces and of bodies resist shear, every second node along an axis resists bending. Every pair has the
    // smaller node number first, and pairs are sorted by their first node.
    std::vector<NodePair> structural() const;
    std::vector<NodePair> face_diagonals() const;
    std::vector<NodePair> body_diagonals() const;  // empty in 2D
    std::vector<NodePair> bending() const;

private:
    std::vector<NodePair> pairs(const std::vector<Cells>& offsets) const;

    Cells cells_;
    Vec<Dim> spacing_, origin_;
    std::array<Index, Dim + 1> stride_;
};

// Boundary of a block as triangles that wind anticlockwise when seen from outside. Throws Refused when an axis has no cells.
std::vector<NodeTriple> surface_triangles(const NodeLattice<3>& lattice);

}  // namespace pliant
