// The staggered grid itself: which faces are whose, and what is measured on them.
#include "fluids_grids.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/forces.h>
#include <pliant/math/error.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// Sets every component to f(place in metres)[axis].
template <int Dim, class F>
FaceField<Dim> sampled(const StaggeredGrid<Dim>& grid, F f) {
    FaceField<Dim> u = grid.zero_velocity();
    for (int a = 0; a < Dim; ++a) {
        for (Index i = 0; i < u[a].size(); ++i) {
            const GridPlace<Dim> place = grid.faces(a).place(grid.faces(a).coordinates(i));
            Vec<Dim> x;
            for (int b = 0; b < Dim; ++b) x[b] = place[b] * grid.dx();
            u[a][i] = f(x)[a];
        }
    }
    return u;
}

}  // namespace

TEST_CASE("a staggered grid counts its faces", "[fluids][grid]") {
    const StaggeredGrid<2> closed(box<2>({5, 3}));
    CHECK(closed.faces(0).size() == 6 * 3);
    CHECK(closed.faces(1).size() == 5 * 4);
    CHECK(closed.closed_faces(0).size() == 6);
    CHECK(closed.closed_faces(1).size() == 10);
    CHECK_FALSE(closed.has_gaps());

    const StaggeredGrid<3> endless(box<3>({5, 3, 4}, true));
    for (int a = 0; a < 3; ++a) {
        CHECK(endless.faces(a).size() == 60);
        CHECK(endless.closed_faces(a).empty());
    }

    // A solid in the middle closes the four faces around it and touches four fluid cells.
    const StaggeredGrid<2> stone(drawn({"...", ".#.", "..."}));
    CHECK(stone.fluid_cells() == 8);
    for (int a = 0; a < 2; ++a) {
        CHECK(stone.closed_faces(a).size() == 8);
        for (const auto fluid : stone.fluid_beside_closed(a)) CHECK(fluid == 1);
        CHECK(stone.openness(a).sum() == 4);
    }
}

TEST_CASE("a grid refuses what has no meaning, by name", "[fluids][grid]") {
    CHECK_THROWS_WITH(StaggeredGrid<2>(box<2>({0, 4})), ContainsSubstring("cells[0]"));
    CHECK_THROWS_WITH(StaggeredGrid<2>(box<2>({4, 4}, false, 0)), ContainsSubstring("dx"));
    CHECK_THROWS_AS(StaggeredGrid<2>(box<2>({4, 4}, false, std::nan(""))), Refused);
    CHECK_THROWS_AS(StaggeredGrid<2>(box<2>({4, 4}, false, INFINITY)), Refused);
    StaggeredGridInfo<2> info = box<2>({4, 4});
    info.walls[1][0].velocity[0] = std::nan("");
    CHECK_THROWS_WITH(StaggeredGrid<2>(info), ContainsSubstring("walls[1][0].velocity[0]"));
    info = box<2>({4, 4});
    info.types.assign(15, CellType::solid);
    CHECK_THROWS_WITH(StaggeredGrid<2>(info), ContainsSubstring("types"));
}

TEST_CASE("walls set the normal velocity of their faces and solids are at rest", "[fluids][grid]") {
    StaggeredGridInfo<2> info = drawn({"#...", "...."});
    info.walls[0][0].velocity = {3, 1};
    info.walls[1][1].velocity = {7, -2};
    const StaggeredGrid<2> grid(info);
    FaceField<2> u = grid.zero_velocity();
    u[0].setConstant(9);
    u[1].setConstant(9);
    grid.impose_walls(u);
    CHECK(u[0] == (VecX(10) << 3, 9, 9, 9, 0, /* top row, behind the solid */ 0, 0, 9, 9, 0).finished());
    CHECK(u[1] == (VecX(12) << 0, 0, 0, 0, 0, 9, 9, 9, 0, -2, -2, -2).finished());
}

TEST_CASE("divergence is exact for linear velocities", "[fluids][grid]") {
    const StaggeredGrid<3> grid(box<3>({4, 5, 3}, false, 0.5));
    const FaceField<3> u = sampled(grid, [](const Vec<3>& x) { return Vec<3>(2 * x[0] + x[1], 5 - 3 * x[1], 4 * x[2] - x[0]); });
    VecX div;
    divergence(grid, u, div);
    CHECK((div.array() - 3).abs().maxCoeff() < 1e-12);

    const StaggeredGrid<2> ring(box<2>({4, 1}, true));
    FaceField<2> v = ring.zero_velocity();
    v[0] << 1, 2, 4, 8;
    divergence(ring, v, div);
    CHECK(div == (VecX(4) << 1, 2, 4, -7).finished());
}

TEST_CASE("kinetic energy gives every face the fluid volume beside it", "[fluids][grid]") {
    // A uniform flow of speed 2 through a channel of 3 m × 1 m: ½ · 4 · 3 = 6.
    StaggeredGridInfo<2> info = box<2>({6, 2}, false, 0.5);
    info.walls[0][0].velocity = info.walls[0][1].velocity = {2, 0};
    const StaggeredGrid<2> grid(info);
    FaceField<2> u = grid.zero_velocity();
    u[0].setConstant(2);
    CHECK_THAT(kinetic_energy(grid, u), WithinRel(6.0, 1e-14));
    // Periodic, the same.
    const StaggeredGrid<3> space(box<3>({3, 2, 2}, true, 0.5));
    FaceField<3> w = space.zero_velocity();
    w[2].setConstant(2);
    CHECK_THAT(kinetic_energy(space, w), WithinRel(2 * 12 * 0.125, 1e-14));
    // Inside a solid nothing moves that counts.
    const StaggeredGrid<2> half(drawn({"..##"}));
    FaceField<2> v = half.zero_velocity();
    v[0].setConstant(1);
    CHECK_THAT(kinetic_energy(half, v), WithinRel(0.5 * 2, 1e-14));
}

TEST_CASE("Courant number, cell velocity and vorticity of a solid rotation", "[fluids][grid]") {
    const StaggeredGrid<2> grid(box<2>({8, 6}, false, 0.25));
    const FaceField<2> u = sampled(grid, [](const Vec<2>& x) { return Vec<2>(-3 * x[1], 3 * x[0]); });
    CHECK_THAT(courant_number(grid, u, 0.1), WithinRel(3 * 7.5 * 0.25 * 0.1 / 0.25, 1e-14));
    Points<2> centre;
    cell_velocity(grid, u, centre);
    for (Index c = 0; c < 48; ++c) {
        const GridPlace<2> x = grid.cells().place(grid.cells().coordinates(c));
        CHECK_THAT(centre(0, c), WithinAbs(-3 * 0.25 * x[1], 1e-13));
        CHECK_THAT(centre(1, c), WithinAbs(3 * 0.25 * x[0], 1e-13));
    }
    VelocitySampler<2> flow(grid);
    flow.set(u);
    VecX omega;
    vorticity(grid, flow, omega);
    for (Index j = 1; j < 5; ++j)
        for (Index i = 1; i < 7; ++i) CHECK_THAT(omega[i + 8 * j], WithinAbs(6.0, 1e-12));
}

TEST_CASE("the vorticity of a periodic vortex converges with order 2", "[fluids][grid]") {
    const auto error = [](Index n) {
        using std::numbers::pi;
        const StaggeredGrid<2> grid(box<2>({n, n}, true, 1 / static_cast<Real>(n)));
        VelocitySampler<2> flow(grid);
        flow.set(sampled(grid, [](const Vec<2>& x) {
            return Vec<2>(std::sin(2 * pi * x[0]) * std::cos(2 * pi * x[1]), -std::cos(2 * pi * x[0]) * std::sin(2 * pi * x[1]));
        }));
        VecX omega;
        vorticity(grid, flow, omega);
        Real largest = 0;
        for (Index c = 0; c < omega.size(); ++c) {
            const GridPlace<2> x = grid.cells().place(grid.cells().coordinates(c));
            const Real exact = 4 * pi * std::sin(2 * pi * x[0] * grid.dx()) * std::sin(2 * pi * x[1] * grid.dx());
            largest = std::max(largest, std::abs(omega[c] - exact));
        }
        return largest;
    };
    CHECK_THAT(std::log2(error(32) / error(64)), WithinAbs(2, 0.05));
}

TEST_CASE("forces are scaled by the time step and leave the walls alone", "[fluids][grid]") {
    const StaggeredGrid<2> grid(box<2>({3, 4}, false, 0.5));
    FaceField<2> u = grid.zero_velocity(), v = grid.zero_velocity();
    add_uniform_force(grid, u, 0.1, Vec<2>(0, -10));
    add_force(grid, v, 0.1, [](const Vec<2>&) { return Vec<2>(0, -10); });
    CHECK(u[0].isZero(0));
    for (Index j = 0; j <= 4; ++j) CHECK(u[1].segment(3 * j, 3) == VecX::Constant(3, j == 0 || j == 4 ? 0 : -1));
    CHECK((u[0] == v[0] && u[1] == v[1]));

    // The place of a face is in metres.
    FaceField<2> w = grid.zero_velocity();
    add_force(grid, w, 1, [](const Vec<2>& x) { return Vec<2>(x[0], x[1]); });
    CHECK(w[0][1] == 0.5);
    CHECK(w[1][3] == 0.5);
}

TEST_CASE("a jet pushes the fluid around its place, through periodic sides, and no wall", "[fluids][grid]") {
    // All faces of one component at their distances: f exp(−r²/2R²), cut at four radii.
    const StaggeredGrid<2> grid(box<2>({20, 16}, false, 0.05));
    FaceField<2> u = grid.zero_velocity();
    add_jet<2>(grid, u, 0.1, {0.1, 0.4}, 0.06, {3, 0});
    CHECK(u[1].isZero(0));
    for (Index f = 0; f < u[0].size(); ++f) {
        const Counts<2> at = grid.faces(0).coordinates(f);
        const Real x = 0.05 * static_cast<Real>(at[0]) - 0.1, y = 0.05 * (static_cast<Real>(at[1]) + 0.5) - 0.4;
        const Real r2 = (x * x + y * y) / (0.06 * 0.06);
        const bool wall = at[0] == 0 || at[0] == 20;
        CHECK_THAT(u[0][f], WithinAbs(wall || r2 > 16 ? 0 : 0.3 * std::exp(-0.5 * r2), 1e-14));
    }
    // The impulse is that of the bell, 2πR² times the acceleration, wherever the centre lies in a periodic box.
    const StaggeredGrid<2> endless(box<2>({40, 40}, true, 0.025));
    for (const Vec<2>& centre : {Vec<2>(0.5, 0.5), Vec<2>(0.01, 0.99)}) {
        FaceField<2> v = endless.zero_velocity();
        add_jet<2>(endless, v, 1, centre, 0.06, {0, -2});
        CHECK_THAT(v[1].sum() * endless.cell_volume(), WithinRel(-2 * 2 * std::numbers::pi * 0.06 * 0.06, 1e-3));
    }
    CHECK_THROWS_AS((add_jet<2>(grid, u, 1, {0, 0}, 0, {1, 0})), Refused);
}

TEST_CASE("buoyancy pushes the open faces by the mean of the cells beside them") {
    const StaggeredGrid<2> grid(drawn({"....", ".#..", "...."}));
    FaceField<2> u = random_velocity(grid, 3);
    const FaceField<2> before = u;
    const VecX lightness = VecX::LinSpaced(12, 0, 11);
    add_buoyancy<2>(grid, u, 0.1, 1, 3, lightness);
    CHECK(u[0] == before[0]);
    for (Index face = 0; face < u[1].size(); ++face) {
        const Counts<2> at = grid.faces(1).coordinates(face);
        const bool open = at[1] > 0 && at[1] < 3 && at[0] != 1;
        const Real mean = open ? Real(0.5) * (lightness[face - 4] + lightness[face]) : Real{0};
        CHECK_THAT(u[1][face] - before[1][face], Catch::Matchers::WithinAbs(0.1 * 3 * mean, 1e-14));
    }
    // Along a periodic axis the first face lies between the last cell and the first.
    const StaggeredGrid<2> endless(box<2>({3, 1}, true));
    FaceField<2> v = endless.zero_velocity();
    add_buoyancy<2>(endless, v, 1, 0, 2, VecX::LinSpaced(3, 1, 3));
    CHECK(v[0] == VecX{{4, 3, 5}});
}
