// Grids and velocities that several tests of the grid fluids share.
#pragma once
#include <pliant/fluids/staggered_grid.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace pliant::test {

template <int Dim>
StaggeredGridInfo<Dim> box(const Counts<Dim>& cells, bool periodic = false, Real dx = 1) {
    StaggeredGridInfo<Dim> info;
    info.cells = cells;
    info.dx = dx;
    info.periodic.fill(periodic);
    return info;
}

// A plane box from a picture: '#' is solid, anything else fluid. The first line is the top row.
inline StaggeredGridInfo<2> drawn(const std::vector<std::string>& rows) {
    const auto ny = static_cast<Index>(rows.size()), nx = static_cast<Index>(rows.front().size());
    StaggeredGridInfo<2> info = box<2>({nx, ny});
    for (Index j = 0; j < ny; ++j)
        for (Index i = 0; i < nx; ++i)
            info.types.push_back(rows[static_cast<std::size_t>(ny - 1 - j)][static_cast<std::size_t>(i)] == '#'
                                     ? CellType::solid
                                     : CellType::fluid);
    return info;
}

// Random numbers on the open faces, the walls' velocity on the closed ones.
template <int Dim>
FaceField<Dim> random_velocity(const StaggeredGrid<Dim>& grid, unsigned seed = 1) {
    std::srand(seed);
    FaceField<Dim> velocity = grid.zero_velocity();
    for (VecX& component : velocity.components) component.setRandom();
    grid.impose_walls(velocity);
    return velocity;
}

}  // namespace pliant::test
