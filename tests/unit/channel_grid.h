// A channel between two plates, for tests of viscosity.
#pragma once
#include <pliant/fluids/staggered_grid.h>

namespace pliant::test {

// A channel of 4 × n cells between y = 0 and y = 1, periodic along x, whose upper plate moves.
inline StaggeredGrid<2> channel(Index n, Real plate_speed) {
    StaggeredGridInfo<2> info;
    info.cells = {4, n};
    info.dx = Real(1) / static_cast<Real>(n);
    info.periodic = {true, false};
    for (Wall<2>& wall : info.walls[1]) wall.slip = Slip::none;
    info.walls[1][1].velocity = {plate_speed, 0};
    return StaggeredGrid<2>(info);
}

}  // namespace pliant::test
