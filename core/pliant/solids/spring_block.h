// A piece of a lattice of point masses, joined by structural, shear and bending springs.
#pragma once
#include <pliant/solids/lattice_elasticity.h>
#include <pliant/time/mass.h>

#include <array>

namespace pliant {

class SpringBlock {
public:
    // The block is centred on the y axis and stands on y = 0.
    explicit SpringBlock(SpringLattice lattice);

    const SpringLattice& lattice() const { return lattice_; }
    int dimension() const { return dimension_of(lattice_.kind()); }
    const Points<3>& rest() const { return rest_; }  // m
    const std::vector<NodeTriple>& surface() const { return surface_; }
    const std::vector<NodePair>& surface_edges() const { return surface_edges_; }  // edges of the cells
    Vec<3> lengths() const { return lattice_.lengths(); }                          // m, of the edges

    // Nodes of the layer with the largest (or smallest) coordinate along an axis.
    std::vector<Index> layer(int axis, bool last) const { return lattice_.layer(axis, last); }

    // Gives the families their stiffness; one of stiffness 0 has no springs. rest_scale: rest lengths over the distances at rest.
    // Returns whether springs were made anew.
    bool set_springs(const FamilyStiffness& stiffness, Real damping, Real rest_scale);
    // Shares out the mass equally, kg. fixed: nodes that nothing moves.
    void set_mass(Real total, const std::vector<Index>& fixed);

    const Springs& springs() const { return springs_; }
    // The springs of a family: from first to before last.
    Index first(SpringFamily family) const { return first_[family]; }
    Index last(SpringFamily family) const { return first_[family + 1]; }
    // The firsts of all families, and behind them the number of springs.
    const std::array<Index, spring_families + 1>& families() const { return first_; }
    const VecX& mass() const { return mass_; }  // kg, one per node
    const DiagonalMass& inertia() const { return inertia_; }

    // Smallest volume of a cell over its volume at rest, from the mean of its edges in each direction: 0 where a cell is flat,
    // negative where one is turned inside out. Of a sheet, smallest area of a triangle; of a chain, smallest distance.
    Real smallest_cell(const Points<3>& x) const;

private:
    Real smallest_block_cell(const Points<3>& x) const;

    SpringLattice lattice_;
    Points<3> rest_;
    std::vector<NodeTriple> surface_;
    std::vector<NodePair> surface_edges_;
    Springs springs_;
    FamilyStiffness stiffness_{};
    Real rest_scale_ = 1;
    std::array<Index, spring_families + 1> first_{};  // of each family in springs_
    bool built_ = false;
    VecX mass_;
    DiagonalMass inertia_;
};

}  // namespace pliant
