// The parts of the fluid that no open face joins. One without a surface is closed: its pressure is known up to a constant, and a
// pressure exists only if as much flows in as out.
#pragma once
#include <pliant/fluids/staggered_grid.h>

namespace pliant {

template <int Dim>
class FluidRegions {
public:
    explicit FluidRegions(const StaggeredGrid<Dim>& grid);

    Index count() const { return static_cast<Index>(cells_.size()); }

    // Does the region meet air, where the pressure is 0?
    bool has_surface(Index region) const { return !surface_.empty() && surface_[region]; }

    // Subtracts from the fluid cells of every closed region their mean, so that the right-hand side is compatible and the
    // pressure is the one of mean 0. Cells without fluid get 0.
    void remove_means(VecX& values) const;

    // Throws Diverged, with the net flux, if the prescribed velocities let more fluid into a closed region than out of it.
    void check_flux(const FaceField<Dim>& velocity) const;

private:
    Index region_of(Index cell) const { return label_.empty() ? 0 : label_[cell]; }
    void label_cells();
    void find_surfaces();

    const StaggeredGrid<Dim>* grid_;
    std::vector<Index> label_;   // region of every cell, -1 where there is no fluid; empty: all cells are region 0
    std::vector<Index> cells_;   // number of cells of each region
    std::vector<bool> surface_;  // has_surface(); empty: none has
};

extern template class FluidRegions<2>;
extern template class FluidRegions<3>;

}  // namespace pliant
