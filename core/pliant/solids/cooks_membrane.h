// Cook's membrane [Cook1974]: a tapered panel with the corners (0, 0), (48, 44), (48, 60), (0, 44) m, clamped at its left edge
// and pulled up at its right one. It bends and shears, so that elements which lock show it.
#pragma once
#include <pliant/solids/linear_fem.h>

namespace pliant {

class CooksMembrane {
public:
    // n × n cells of 2 linear triangles each, cut from node (i, j) to (i+1, j+1); n even, so that a node lies in the middle of
    // the loaded edge. Throws Refused when n is odd or less than 2.
    explicit CooksMembrane(int n);

    const SimplexMesh<2>& mesh() const { return mesh_; }
    // The node at (48, 52), where the deflection is measured.
    Index tip() const { return mesh_.nodes("x_max")[mesh_.nodes("x_max").size() / 2]; }
    // Forces on the nodes [N per metre of thickness]: 1 N upward, spread over the right edge.
    const Points<2>& unit_load() const { return unit_load_; }

    // Displacements [m] under a force [N] on the right edge. IsotropicModuli::lame() is plane strain.
    Points<2> displacement(const Lame& material, Real force) const;

private:
    SimplexMesh<2> mesh_;
    Points<2> unit_load_;
};

}  // namespace pliant
