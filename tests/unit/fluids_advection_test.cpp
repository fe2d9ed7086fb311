// Semi-Lagrangian advection: its amplification factor, its bound, and its exact cases.
#include "advection_flows.h"

#include <pliant/fluids/diagnostics.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <limits>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

template <int Dim>
void check_bound(StaggeredGridInfo<Dim> info, Real courant, const AdvectionSettings& settings) {
    const StaggeredGrid<Dim> grid(info);
    SemiLagrangian<Dim> advection(grid, settings);
    FaceField<Dim> u = grid.zero_velocity();
    std::srand(7);
    for (VecX& component : u.components) component.setRandom();
    grid.impose_walls(u);
    Real bound = max_speed(u);
    for (const auto& axis : info.walls)
        for (const auto& wall : axis) bound = std::max(bound, wall.velocity.cwiseAbs().maxCoeff());
    for (int step = 0; step < 5; ++step) {
        advection.advect(u, courant * info.dx);
        for (const VecX& component : u.components) REQUIRE(component.allFinite());
        CHECK(max_speed(u) <= bound * (1 + 1e-14));
    }
}

}  // namespace

TEST_CASE("a sine carried by a uniform flow loses amplitude as linear interpolation says", "[fluids][advection]") {
    // 64 cells, 2 waves, 0.3 cells per step, 100 steps: |1 − s + s exp(−ikΔx)|^100 = 0.66687936.
    const StaggeredGrid<2> grid = periodic_grid(64, 3);
    SemiLagrangian<2> advection(grid);
    VecX quantity(grid.cells().size());
    for (Index c = 0; c < quantity.size(); ++c) quantity[c] = std::sin(2 * pi * 2 * static_cast<Real>(c % 64) / 64);
    const FaceField<2> flow = uniform(grid, 0.3, 0);
    for (int step = 0; step < 100; ++step) advection.advect(quantity, flow, 1);
    CHECK_THAT(amplitude(quantity.head(64), 2), WithinAbs(0.66687936, 1e-8));

    // The velocity carries itself the same way: v(x) in a uniform u.
    FaceField<2> u = uniform(grid, 0.3, 0);
    for (Index f = 0; f < u[1].size(); ++f) u[1][f] = 0.5 * std::sin(2 * pi * 2 * static_cast<Real>(f % 64) / 64);
    for (int step = 0; step < 100; ++step) advection.advect(u, 1);
    CHECK_THAT(amplitude(u[1].head(64), 2), WithinAbs(0.5 * 0.66687936, 1e-8));
    CHECK((u[0].array() - 0.3).abs().maxCoeff() < 1e-14);
}

TEST_CASE("a whole number of cells per step is an exact shift in every scheme", "[fluids][advection]") {
    const StaggeredGrid<2> grid = periodic_grid(16, 8, 0.25);
    std::srand(3);
    const VecX before = VecX::Random(grid.cells().size());
    for (const AdvectionSettings& settings : all_schemes()) {
        SemiLagrangian<2> advection(grid, settings);
        VecX quantity = before;
        advection.advect(quantity, uniform(grid, 3, -2), 0.25);  // 3 cells right, 2 down
        for (Index c = 0; c < quantity.size(); ++c) {
            const Counts<2> at = grid.cells().coordinates(c);
            CHECK(quantity[c] == before[grid.cells().index({(at[0] + 13) % 16, (at[1] + 2) % 8})]);
        }
        // The same 1000 periods farther.
        VecX far = before;
        advection.advect(far, uniform(grid, 3 + 16000, -2 - 8000), 0.25);
        CHECK((far - quantity).lpNorm<Eigen::Infinity>() < 1e-9);
    }
}

TEST_CASE("the interpolation error falls with order 1 per unit of time at a fixed Courant number", "[fluids][advection]") {
    const auto error = [](Index n) {
        const StaggeredGrid<2> grid = periodic_grid(n, 1, 1 / static_cast<Real>(n));
        SemiLagrangian<2> advection(grid);
        VecX quantity(n), exact(n);
        for (Index i = 0; i < n; ++i) {
            const Real x = (static_cast<Real>(i) + 0.5) / static_cast<Real>(n);
            quantity[i] = std::sin(2 * pi * x);
            exact[i] = std::sin(2 * pi * (x - 0.25));
        }
        for (Index step = 0; step < n / 2; ++step) advection.advect(quantity, uniform(grid, 1, 0), 0.5 / static_cast<Real>(n));
        return (quantity - exact).lpNorm<Eigen::Infinity>();
    };
    CHECK_THAT(std::log2(error(128) / error(256)), WithinAbs(1, 0.1));
    CHECK_THAT(std::log2(error(256) / error(512)), WithinAbs(1, 0.1));
}

TEST_CASE("a solid rotation is traced with order 2 by the midpoint rule", "[fluids][advection]") {
    // One step of angle θ around the middle: linear interpolation is exact for the linear field x, so only the path errs.
    const auto error = [](Real angle) {
        StaggeredGridInfo<2> info;
        info.cells = {40, 40};
        const StaggeredGrid<2> grid(info);
        FaceField<2> u = grid.zero_velocity();
        for (int a = 0; a < 2; ++a) {
            for (Index f = 0; f < u[a].size(); ++f) {
                const GridPlace<2> x = grid.faces(a).place(grid.faces(a).coordinates(f));
                u[a][f] = a == 0 ? -(x[1] - 20) : x[0] - 20;
            }
        }
        VecX quantity(grid.cells().size());
        for (Index c = 0; c < quantity.size(); ++c) quantity[c] = grid.cells().place(grid.cells().coordinates(c))[0] - 20;
        SemiLagrangian<2> advection(grid);
        advection.advect(quantity, u, angle);
        Real largest = 0;
        for (Index c = 0; c < quantity.size(); ++c) {
            const GridPlace<2> x = grid.cells().place(grid.cells().coordinates(c));
            if (std::hypot(x[0] - 20, x[1] - 20) > 15) continue;
            largest = std::max(largest, std::abs(quantity[c] - (std::cos(angle) * (x[0] - 20) + std::sin(angle) * (x[1] - 20))));
        }
        return largest;
    };
    CHECK_THAT(std::log2(error(0.2) / error(0.1)), WithinAbs(3, 0.1));  // order 2 is an error of order 3 per step
}

TEST_CASE("the largest velocity never grows, at any Courant number, in any scheme", "[fluids][advection]") {
    const Real courant = GENERATE(0.1, 1.0, 5.0, 20.0, 100.0, 1e9);
    for (const AdvectionSettings& settings : all_schemes()) {
        StaggeredGridInfo<2> closed;
        closed.cells = {17, 10};
        closed.dx = 0.1;
        check_bound(closed, courant, settings);
        StaggeredGridInfo<2> sticking = closed;
        for (auto& axis : sticking.walls)
            for (auto& wall : axis) wall.slip = Slip::none;
        sticking.walls[1][1].velocity = {2, 0};
        check_bound(sticking, courant, settings);
        StaggeredGridInfo<2> endless = closed;
        endless.periodic = {true, true};
        check_bound(endless, courant, settings);
        StaggeredGridInfo<2> obstacle = sticking;
        obstacle.types.assign(170, CellType::fluid);
        for (Index c : {40, 41, 57, 58, 120}) obstacle.types[static_cast<std::size_t>(c)] = CellType::solid;
        check_bound(obstacle, courant, settings);
        StaggeredGridInfo<3> space;
        space.cells = {5, 8, 6};
        space.periodic = {false, true, false};
        space.walls[2][0].slip = Slip::none;
        check_bound(space, courant, settings);
    }
}

TEST_CASE("fluid at rest stays as it is and closed faces keep their value", "[fluids][advection]") {
    StaggeredGridInfo<2> info;
    info.cells = {6, 5};
    info.walls[0][0].velocity = {0.5, 0};
    info.walls[0][1].velocity = {0.5, 0};
    const StaggeredGrid<2> grid(info);
    FaceField<2> u = grid.zero_velocity();
    grid.impose_walls(u);
    SemiLagrangian<2> advection(grid);
    advection.advect(u, 3.7);
    for (int a = 0; a < 2; ++a)
        for (Index face : grid.closed_faces(a)) CHECK(u[a][face] == (a == 0 ? 0.5 : 0.0));

    FaceField<2> still = grid.zero_velocity();
    VecX quantity = VecX::Random(30), before = quantity;
    advection.advect(quantity, still, 10);
    CHECK(quantity == before);
}

TEST_CASE("a velocity that is not finite is carried without leaving the arrays", "[fluids][advection]") {
    for (const bool periodic : {false, true}) {
        StaggeredGridInfo<2> info;
        info.cells = {8, 8};
        info.periodic = {periodic, periodic};
        const StaggeredGrid<2> grid(info);
        FaceField<2> u = grid.zero_velocity();
        u[0][20] = std::numeric_limits<Real>::quiet_NaN();
        u[1][30] = std::numeric_limits<Real>::infinity();
        SemiLagrangian<2> advection(grid);
        advection.advect(u, 1);
        CHECK_FALSE((u[0].allFinite() && u[1].allFinite()));
    }
}
