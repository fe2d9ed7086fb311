// Grids, flows and quantities that the tests of advection share.
#pragma once
#include <pliant/fluids/advection.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace pliant::test {

inline StaggeredGrid<2> periodic_grid(Index nx, Index ny, Real dx = 1) {
    StaggeredGridInfo<2> info;
    info.cells = {nx, ny};
    info.dx = dx;
    info.periodic = {true, true};
    return StaggeredGrid<2>(info);
}

inline FaceField<2> uniform(const StaggeredGrid<2>& grid, Real u, Real v) {
    FaceField<2> velocity = grid.zero_velocity();
    velocity[0].setConstant(u);
    velocity[1].setConstant(v);
    return velocity;
}

// Amplitude of the Fourier mode m along axis 0 of the first row.
inline Real amplitude(const VecX& row, Index m) {
    using std::numbers::pi;
    std::complex<Real> sum = 0;
    for (Index i = 0; i < row.size(); ++i)
        sum += std::polar(row[i], -2 * pi * static_cast<Real>(m * i) / static_cast<Real>(row.size()));
    return 2 * std::abs(sum) / static_cast<Real>(row.size());
}

// Every scheme: what traces, what interpolates, with and without MacCormack's correction.
inline std::vector<AdvectionSettings> all_schemes() {
    std::vector<AdvectionSettings> all;
    for (const BackTrace trace : {BackTrace::euler, BackTrace::midpoint})
        for (const Interpolation interpolation : {Interpolation::linear, Interpolation::monotone_cubic})
            for (const bool mac_cormack : {false, true}) all.push_back({trace, interpolation, mac_cormack});
    return all;
}

}  // namespace pliant::test
