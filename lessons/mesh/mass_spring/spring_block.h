// A rectangular block of point masses, joined by structural, shear and bending springs.
#pragma once
#include <pliant/mesh/lattice.h>
#include <pliant/solids/springs.h>
#include <pliant/time/mass.h>

#include <array>

namespace pliant::mass_spring {

enum Family { structural, shear, bending, family_count };

class SpringBlock {
public:
    using Stiffnesses = std::array<Real, family_count>;  // N/m of each family

    // The block is centred on the y axis and stands on y = 0. fixed: nodes that nothing moves.
    SpringBlock(const NodeLattice<3>::Cells& cells, Real cell_size);

    const NodeLattice<3>& lattice() const { return lattice_; }
    const Points<3>& rest() const { return rest_; }  // m
    const std::vector<NodeTriple>& surface() const { return surface_; }
    const std::vector<NodePair>& surface_edges() const { return surface_edges_; }  // edges of the cells
    Vec<3> lengths() const;                                                        // m, of the edges

    // Nodes of the layer with the largest (or smallest) coordinate along an axis.
    std::vector<Index> layer(int axis, bool last) const;

    // Gives the families their stiffness; one of stiffness 0 has no springs. Returns whether springs were added or taken away.
    bool set_springs(const Stiffnesses& stiffness, Real damping);
    // Shares out the mass equally, kg. fixed: nodes that nothing moves.
    void set_mass(Real total, const std::vector<Index>& fixed);

    const Springs& springs() const { return springs_; }
    // The springs of a family: from first to before last.
    Index first(Family family) const { return first_[family]; }
    Index last(Family family) const { return first_[family + 1]; }
    const VecX& mass() const { return mass_; }  // kg, one per node
    const DiagonalMass& inertia() const { return inertia_; }

    // Smallest volume of a cell over its volume at rest, from the mean of its edges in each direction: 0 where a cell is flat,
    // negative where one is turned inside out.
    Real smallest_cell(const Points<3>& x) const;

private:
    std::vector<NodePair> pairs(Family family) const;

    NodeLattice<3> lattice_;
    Real cell_size_;
    Points<3> rest_;
    std::vector<NodeTriple> surface_;
    std::vector<NodePair> surface_edges_;
    Springs springs_;
    Stiffnesses stiffness_{};
    std::array<Index, family_count + 1> first_{};  // of each family in springs_
    bool built_ = false;
    VecX mass_;
    DiagonalMass inertia_;
};

}  // namespace pliant::mass_spring
