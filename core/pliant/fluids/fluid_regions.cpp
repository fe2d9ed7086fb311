#include <fmt/format.h>
#include <pliant/fluids/fluid_regions.h>
#include <pliant/math/error.h>
#include <pliant/math/parallel.h>

#include <cmath>

namespace pliant {

template <int Dim>
FluidRegions<Dim>::FluidRegions(const StaggeredGrid<Dim>& grid) : grid_(&grid) {
    if (!grid.has_gaps()) {
        cells_ = {grid.cells().size()};
        return;
    }
    label_cells();
    if (grid.has_air()) find_surfaces();
}

// Numbers the regions in the order of their first cells.
template <int Dim>
void FluidRegions<Dim>::label_cells() {
    const Lattice<Dim>& lattice = grid_->cells();
    label_.assign(static_cast<std::size_t>(lattice.size()), -1);
    std::vector<Index> open_ends;
    for (Index seed = 0; seed < lattice.size(); ++seed) {
        if (!grid_->is_fluid(seed) || label_[seed] >= 0) continue;
        const auto region = static_cast<Index>(cells_.size());
        cells_.push_back(0);
        label_[seed] = region;
        open_ends.push_back(seed);
        while (!open_ends.empty()) {
            const Index cell = open_ends.back();
            open_ends.pop_back();
            ++cells_[region];
            for (int k = 0; k < 2 * Dim; ++k) {
                const Index next = lattice.neighbour(lattice.coordinates(cell), k / 2, k % 2 == 0 ? -1 : 1);
                if (next < 0 || !grid_->is_fluid(next) || label_[next] >= 0) continue;
                label_[next] = region;
                open_ends.push_back(next);
            }
        }
    }
}

template <int Dim>
void FluidRegions<Dim>::find_surfaces() {
    surface_.assign(cells_.size(), false);
    for (int a = 0; a < Dim; ++a)
        for (const Index face : grid_->surface_faces(a))
            for (int side = 0; side < 2; ++side)
                if (const Index cell = grid_->cell_beside(a, face, side); grid_->is_fluid(cell)) surface_[label_[cell]] = true;
}

template <int Dim>
void FluidRegions<Dim>::remove_means(VecX& values) const {
    if (label_.empty()) {
        const Index cells = values.size();
        const auto sum = [&](Index first, Index last) { return values.segment(first, last - first).sum(); };
        const Real mean = parallel_sum(cells, sum) / static_cast<Real>(cells);
        parallel_parts(cells, 1, [&](Index first, Index last, int) { values.segment(first, last - first).array() -= mean; });
        return;
    }
    std::vector<Real> mean(cells_.size(), 0);
    for (Index c = 0; c < values.size(); ++c)
        if (label_[c] >= 0) mean[label_[c]] += values[c];
    for (std::size_t r = 0; r < mean.size(); ++r)
        mean[r] = has_surface(static_cast<Index>(r)) ? 0 : mean[r] / static_cast<Real>(cells_[r]);
    for (Index c = 0; c < values.size(); ++c) values[c] = label_[c] >= 0 ? values[c] - mean[label_[c]] : 0;
}

template <int Dim>
void FluidRegions<Dim>::check_flux(const FaceField<Dim>& velocity) const {
    constexpr Real rounding = 1e-10;  // of the flux through all prescribed faces, far above what summing them costs
    std::vector<Real> net(cells_.size(), 0), gross(cells_.size(), 0);
    const Real area = grid_->cell_volume() / grid_->dx();
    for (int a = 0; a < Dim; ++a) {
        for (Index face : grid_->closed_faces(a)) {
            for (int side = 0; side < 2; ++side) {
                const Index cell = grid_->cell_beside(a, face, side);
                if (cell < 0 || !grid_->is_fluid(cell)) continue;
                const Real inward = (side == 1 ? 1 : -1) * area * velocity[a][face];
                net[region_of(cell)] += inward;
                gross[region_of(cell)] += std::abs(inward);
            }
        }
    }
    for (std::size_t r = 0; r < net.size(); ++r) {
        if (has_surface(static_cast<Index>(r)) || std::abs(net[r]) <= rounding * gross[r]) continue;
        Failure failure;
        failure.field = "velocity";
        failure.what = fmt::format(
            "the walls let a net {:.6g} m^{}/s flow into a closed region of {} cells: no incompressible flow and no pressure "
            "exist",
            net[r], Dim, cells_[r]);
        failure.limit =
            fmt::format("inflow must equal outflow to {:.0e} of the {:.6g} m^{}/s that cross the walls", rounding, gross[r], Dim);
        throw Diverged(failure);
    }
}

template class FluidRegions<2>;
template class FluidRegions<3>;

}  // namespace pliant
