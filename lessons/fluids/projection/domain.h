// The unit square of the lesson: its walls, and the solid cells in it.
#pragma once
#include <pliant/fluids/staggered_grid.h>

namespace pliant::projection {

enum class Obstacle { none, disc, two_rooms, one_cell, all_solid };

inline const Vec<2> disc_middle{0.66, 0.5};  // m
inline constexpr Real disc_radius = 0.14;    // m

inline bool is_solid(Obstacle obstacle, Index i, Index j, Index n) {
    const auto place = [n](Index k) { return (static_cast<Real>(k) + Real(0.5)) / static_cast<Real>(n); };
    switch (obstacle) {
        case Obstacle::none:
            return false;
        case Obstacle::disc:
            return (Vec<2>(place(i), place(j)) - disc_middle).norm() < disc_radius;
        case Obstacle::two_rooms:
            return i == n / 2;
        case Obstacle::one_cell:
            return i != n / 2 || j != n / 2;
        case Obstacle::all_solid:
            return true;
    }
    return false;
}

// n by n cells. inflow and outflow: speeds to the right on the left and on the right wall, m/s; not used where it is periodic.
inline StaggeredGridInfo<2> unit_square(Index n, bool periodic, Obstacle obstacle, Real inflow, Real outflow) {
    StaggeredGridInfo<2> info;
    info.cells = {n, n};
    info.dx = 1 / static_cast<Real>(n);
    info.periodic.fill(periodic);
    if (!periodic) {
        info.walls[0][0].velocity = {inflow, 0};
        info.walls[0][1].velocity = {outflow, 0};
    }
    if (obstacle == Obstacle::none) return info;
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) info.types.push_back(is_solid(obstacle, i, j, n) ? CellType::solid : CellType::fluid);
    return info;
}

}  // namespace pliant::projection
