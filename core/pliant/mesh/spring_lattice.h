// Finite pieces of regular lattices with the families of springs that mass-spring bodies are built from.
//
// A chain stands along y; the square and the triangular lattice lie in the xy plane; the cubic ones fill space. Rows of the
// triangular lattice run along x, every other one is shifted by half an edge, and their distance is sqrt(3)/2 of an edge.
#pragma once
#include <pliant/mesh/lattice.h>

#include <string_view>

namespace pliant {

enum class LatticeKind { cubic_face, cubic_body, square, triangular, chain };

// Structural springs join nearest neighbours along the edges of the cells. Shear springs are diagonals: of the faces (cubic_face,
// square) or of the bodies (cubic_body); a triangular lattice and a chain have none. Bending springs join every second node
// along an edge.
enum SpringFamily { structural, shear, bending, spring_families };

int dimension_of(LatticeKind kind);  // 1, 2 or 3: the directions in which its nodes can be stretched apart

// One spring of the infinite lattice, from a node to the one at this offset. Each is given once.
struct LatticeBond {
    Vec<3> offset;  // in edges of a cell
    SpringFamily family;
};
std::vector<LatticeBond> lattice_bonds(LatticeKind kind);

// Length, area or volume that belongs to one node, in edges^dimension.
Real cell_measure(LatticeKind kind);

class SpringLattice {
public:
    // cells: along each axis; those across the lattice (x and z of a chain, z of a sheet) are not used. Rows of a triangular
    // lattice have cells[0] edges, and there are cells[1] + 1 of them. edge: m. Centred on the y axis, from y = 0 up. Throws
    // Refused as NodeLattice does.
    SpringLattice(LatticeKind kind, const NodeLattice<3>::Cells& cells, Real edge);

    LatticeKind kind() const { return kind_; }
    Real edge() const { return edge_; }  // m
    const NodeLattice<3>& nodes() const { return nodes_; }
    Points<3> points() const;  // m
    // Of a sheet, its width without what the shift of every other row adds; 0 across the lattice.
    Vec<3> lengths() const;  // m

    // Sorted by their first node, which is the smaller one.
    std::vector<NodePair> pairs(SpringFamily family) const;
    // The part of the cells around a structural or shear spring that this piece holds: 1 inside, 1/2 on a face, 1/4 on an edge.
    // With stiffnesses weighted so, the piece behaves as the infinite lattice. 1 of bending springs.
    Real share(const NodePair& pair, SpringFamily family) const;

    // Nodes of the layer with the largest (or smallest) coordinate along an axis.
    std::vector<Index> layer(int axis, bool last) const;

private:
    Real shift(Index row) const { return kind_ == LatticeKind::triangular && row % 2 == 1 ? 0.5 : 0; }

    LatticeKind kind_;
    Real edge_;
    NodeLattice<3> nodes_;  // numbers them; its positions are those of a rectangular lattice
};

}  // namespace pliant
