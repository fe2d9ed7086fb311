// The velocity of a staggered grid at any point, and the path of a weightless particle in it.
#pragma once
#include <pliant/fluids/padded_field.h>
#include <pliant/fluids/staggered_grid.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant {

// Lengths are in cells from the corner of the domain. Beyond the walls the velocity continues as the grid's lattices say; a
// point outside the domain is moved to the nearest point of it, along a periodic axis by whole periods.
template <int Dim>
class VelocitySampler {
public:
    explicit VelocitySampler(const StaggeredGrid<Dim>& grid, Interpolation interpolation = Interpolation::linear)
        : components_(padded(grid, interpolation, std::make_index_sequence<Dim>())) {
        for (int a = 0; a < Dim; ++a) {
            extent_[a] = static_cast<Real>(grid.cell_counts()[a]);
            periodic_[a] = grid.periodic(a);
        }
    }

    // Takes a copy of the velocity; the sampler answers from it until the next call.
    void set(const FaceField<Dim>& velocity) {
        for (int a = 0; a < Dim; ++a) components_[a].fill(velocity[a]);
    }

    const PaddedField<Dim>& component(int axis) const { return components_[axis]; }

    // The nearest place in the domain.
    GridPlace<Dim> confined(const GridPlace<Dim>& x) const { return PaddedField<Dim>::lane(confined(both(x)), 0); }
    [[gnu::always_inline]] PlacePair<Dim> confined(const PlacePair<Dim>& x) const {
        return for_axes<Dim>([&](auto a) {
            const Real extent = extent_[a];
            const auto outside = [&](Real y) { return y < 0 || y > extent; };
            Pair y = x[a];
            if (periodic_[a] && (outside(y[0]) || outside(y[1])))
                y = y - extent * Pair{std::floor(y[0] / extent), std::floor(y[1] / extent)};
            return clamped(y, 0, extent);
        });
    }

    // Velocity at a place in the domain, linearly interpolated.
    GridPlace<Dim> at(const GridPlace<Dim>& x) const {
        GridPlace<Dim> u;
        for (int a = 0; a < Dim; ++a) u[a] = components_[a].at(x);
        return u;
    }
    // One place as a pair.
    static PlacePair<Dim> both(const GridPlace<Dim>& x) {
        return for_axes<Dim>([&](auto a) { return Pair{x[a], x[a]}; });
    }

private:
    template <std::size_t... Axis>
    static std::array<PaddedField<Dim>, Dim> padded(const StaggeredGrid<Dim>& grid, Interpolation interpolation,
                                                    std::index_sequence<Axis...>) {
        return {PaddedField<Dim>(grid.faces(static_cast<int>(Axis)), interpolation)...};
    }

    std::array<PaddedField<Dim>, Dim> components_;
    GridPlace<Dim> extent_{};
    std::array<bool, Dim> periodic_{};
};

}  // namespace pliant
