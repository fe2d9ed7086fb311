// A square sheet of point masses, joined by structural, shear and bending springs.
#pragma once
#include <pliant/mesh/spring_lattice.h>
#include <pliant/solids/springs.h>
#include <pliant/time/mass.h>

#include <array>

namespace pliant {

class ClothSheet {
public:
    using Stiffnesses = std::array<Real, spring_families>;  // N/m of each family

    // nodes: along each side, at least 2; side: m.
    ClothSheet(Index nodes, Real side);

    Index nodes() const { return nodes_; }
    Index node(Index i, Index j) const { return i + nodes_ * j; }
    Real side() const { return side_; }
    Real cell() const { return side_ / Real(nodes_ - 1); }  // m
    // Places in the sheet, (u, w, 0), from its middle, m.
    const Points<3>& rest() const { return rest_; }
    // Two to each cell, the diagonal turned from cell to cell.
    const std::vector<NodeTriple>& triangles() const { return triangles_; }

    // A family of stiffness 0 keeps its springs, which then measure strain and do nothing else.
    void set_springs(const Stiffnesses& stiffness, Real damping);
    // Shares out the mass equally, kg. fixed: nodes that nothing moves.
    void set_mass(Real total, const std::vector<Index>& fixed);

    const Springs& springs() const { return springs_; }
    // The springs of a family: from first to before last.
    Index first(SpringFamily family) const { return first_[family]; }
    Index last(SpringFamily family) const { return first_[family + 1]; }
    // The firsts of all families, and behind them the number of springs.
    const std::array<Index, spring_families + 1>& families() const { return first_; }
    SpringFamily family_of(Index spring) const {
        return spring < last(structural) ? structural : spring < last(shear) ? shear : bending;
    }
    // The springs of a node, in their order.
    const std::vector<Index>& springs_of(Index node) const { return of_node_[static_cast<std::size_t>(node)]; }
    const VecX& mass() const { return mass_; }  // kg, one per node
    const DiagonalMass& inertia() const { return inertia_; }

    Real energy(SpringFamily family, PointsIn<3> x) const;  // J
    // Area that the edge of the sheet encloses when seen from above, m^2: folds that lie over each other cancel.
    Real shadow(PointsIn<3> x) const;

private:
    Index nodes_;
    Real side_;
    Points<3> rest_;
    std::vector<NodeTriple> triangles_;
    Springs springs_;
    std::array<Index, spring_families + 1> first_{};  // of each family in springs_
    std::vector<std::vector<Index>> of_node_;
    VecX mass_;
    DiagonalMass inertia_;
};

}  // namespace pliant
