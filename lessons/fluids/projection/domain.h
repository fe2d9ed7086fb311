// The unit square of the lesson: its walls, and the solid cells in it.
#pragma once
#include <pliant/fluids/staggered_grid.h>

namespace pliant::projection {

enum class Obstacle { none, disc, two_rooms, one_cell, all_solid };

inline const Vec<2> disc_middle{0.66, 0.5};  // m
inline constexpr Real disc_radius = 0.14;    // m

// n by n cells. inflow and outflow: speeds to the right on the left and on the right wall, m/s; not used where it is periodic.
StaggeredGridInfo<2> unit_square(Index n, bool periodic, Obstacle obstacle, Real inflow, Real outflow);

}  // namespace pliant::projection
