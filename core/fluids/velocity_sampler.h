// The velocity of a staggered grid at any point, and the path of a weightless particle in it.
#pragma once
#include <pliant/fluids/padded_field.h>
#include <pliant/fluids/staggered_grid.h>

#include <utility>

namespace pliant {

// Lengths are in cells from the corner of the domain. Beyond the walls the velocity continues as the grid's lattices say; a
// point outside the domain is moved to the nearest point of it, along a periodic axis by whole periods.
template <int Dim>
class VelocitySampler {
public:
    explicit VelocitySampler(const StaggeredGrid<Dim>& grid) : components_(padded(grid, std::make_index_sequence<Dim>())) {
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
    GridPlace<Dim> confined(GridPlace<Dim> x) const {
        for (int a = 0; a < Dim; ++a) confine(a, Eigen::Map<Eigen::ArrayXd>(&x[a], 1), Eigen::Map<Eigen::ArrayXd>(&x[a], 1));
        return x;
    }
    // The same for the coordinates of many places along one axis: out = x, moved into the domain.
    template <class Coordinates, class Out>
    void confine(int axis, const Coordinates& x, Out&& out) const {
        // In this order a number that is not finite ends up inside the domain too.
        const auto between_walls = [&](const auto& y) { return Eigen::ArrayXd::Zero(y.size()).max(y).min(extent_[axis]); };
        if (periodic_[axis]) {
            out = x;
            if (out.minCoeff() < 0 || out.maxCoeff() > extent_[axis]) out -= extent_[axis] * (out / extent_[axis]).floor();
            out = between_walls(out);
        } else {
            out = between_walls(x);
        }
    }

    // Velocity at a place in the domain.
    GridPlace<Dim> at(const GridPlace<Dim>& x) const {
        GridPlace<Dim> u;
        for (int a = 0; a < Dim; ++a) u[a] = components_[a].at(x);
        return u;
    }

private:
    template <std::size_t... Axis>
    static std::array<PaddedField<Dim>, Dim> padded(const StaggeredGrid<Dim>& grid, std::index_sequence<Axis...>) {
        return {PaddedField<Dim>(grid.faces(static_cast<int>(Axis)))...};
    }

    std::array<PaddedField<Dim>, Dim> components_;
    GridPlace<Dim> extent_{};
    std::array<bool, Dim> periodic_{};
};

}  // namespace pliant
