// The parts of the fluid that no open face joins. Each is closed: its pressure is known up to a constant, and a pressure exists
// only if as much flows in as out.
#pragma once
#include <pliant/fluids/staggered_grid.h>

namespace pliant {

template <int Dim>
class FluidRegions {
public:
    explicit FluidRegions(const StaggeredGrid<Dim>& grid);

    Index count() const { return static_cast<Index>(cells_.size()); }

    // Subtracts from the fluid cells of every region their mean, so that the right-hand side is compatible and the pressure
    // is the one of mean 0. Solid cells get 0.
    void remove_means(VecX& values) const;

    // Throws Diverged, with the net flux, if the prescribed velocities let more fluid into a region than out of it.
    void check_flux(const FaceField<Dim>& velocity) const;

private:
    Index region_of(Index cell) const { return label_.empty() ? 0 : label_[cell]; }
    void label_cells();

    const StaggeredGrid<Dim>& grid_;
    std::vector<Index> label_;  // region of every cell, -1 in solids; empty: all cells are region 0
    std::vector<Index> cells_;  // number of cells of each region
};

extern template class FluidRegions<2>;
extern template class FluidRegions<3>;

}  // namespace pliant
