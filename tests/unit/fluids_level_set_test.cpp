// The signed distance to a free surface: distances, volumes, and what carrying costs of them.
#include "fluids_grids.h"

#include <pliant/fluids/level_set.h>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Approx;

namespace {

using std::numbers::pi;

template <int Dim, class Distance>
void set(LevelSet<Dim>& surface, const StaggeredGrid<Dim>& grid, Distance&& phi) {
    for (Index c = 0; c < grid.cells().size(); ++c) {
        const GridPlace<Dim> place = grid.cells().place(grid.cells().coordinates(c));
        Vec<Dim> x;
        for (int a = 0; a < Dim; ++a) x[a] = place[a] * grid.dx();
        surface.distance()[c] = phi(x);
    }
}

// Of a disc (ball) whose level set was stretched, the largest error of the distance within three cells of the surface.
template <int Dim>
Real error_of_distance(Index n) {
    Counts<Dim> cells;
    cells.fill(n);
    const StaggeredGrid<Dim> grid(box<Dim>(cells, false, Real(1) / static_cast<Real>(n)));
    LevelSet<Dim> surface(grid);
    const auto exact = [](const Vec<Dim>& x) { return (x - Vec<Dim>::Constant(0.5)).norm() - 0.3; };
    set(surface, grid, [&](const Vec<Dim>& x) { return exact(x) * (1.5 + x[0] + std::sin(3 * x[1])); });
    surface.redistance();
    Real worst = 0;
    for (Index c = 0; c < grid.cells().size(); ++c) {
        const GridPlace<Dim> place = grid.cells().place(grid.cells().coordinates(c));
        Vec<Dim> x;
        for (int a = 0; a < Dim; ++a) x[a] = place[a] * grid.dx();
        if (std::abs(exact(x)) < 3 * grid.dx()) worst = std::max(worst, std::abs(surface.distance()[c] - exact(x)));
    }
    return worst;
}

}  // namespace

TEST_CASE("the part of a box that a plane leaves filled", "[fluids][level_set]") {
    CHECK(filled_fraction<2>(0, {1, 0}) == Approx(0.5));
    CHECK(filled_fraction<2>(-0.25, {1, 0}) == Approx(0.75));
    CHECK(filled_fraction<2>(0.25, {0, -1}) == Approx(0.25));
    CHECK(filled_fraction<2>(0, {1, 1}) == Approx(0.5));
    CHECK(filled_fraction<2>(0.5, {1, 1}) == Approx(0.125));
    CHECK(filled_fraction<2>(-3, {1, 1}) == 1);
    CHECK(filled_fraction<2>(3, {1, 1}) == 0);
    CHECK(filled_fraction<2>(-1, {0, 0}) == 1);
    // A corner of a cube beyond the plane x + y + z = 1/2: 1/6 of the cube of the edge 1/2.
    CHECK(filled_fraction<3>(1, {1, 1, 1}) == Approx(1.0 / 48));
    CHECK(filled_fraction<3>(0, {2, -1, 0.5}) == Approx(0.5));
    // Against counting points.
    for (const auto& m : {GridPlace<3>{0.3, -1.2, 0.7}, {1, 1e-3, -2}, {0.5, 0.5, 1e-6}}) {
        Index inside = 0;
        constexpr int n = 60;
        for (int i = 0; i < n * n * n; ++i) {
            const auto at = [&](int k) { return (k + 0.5) / n - 0.5; };
            inside += 0.2 + m[0] * at(i % n) + m[1] * at(i / n % n) + m[2] * at(i / n / n) < 0;
        }
        CHECK(filled_fraction<3>(0.2, m) == Approx(static_cast<Real>(inside) / (n * n * n)).margin(2e-3));
    }
}

TEST_CASE("redistancing gives a distance and leaves the surface where it is, with order 2", "[fluids][level_set]") {
    const Real coarse = error_of_distance<2>(32), fine = error_of_distance<2>(64);
    CHECK(coarse < 0.2 / 32);
    CHECK(fine < coarse / 1.9);
    CHECK(error_of_distance<3>(24) < 0.25 / 24);

    // A plane along the grid is exact, and done once more nothing moves.
    const StaggeredGrid<2> grid(box<2>({12, 20}, false, 0.1));
    LevelSet<2> surface(grid);
    set(surface, grid, [](const Vec<2>& x) { return 3 * (x[1] - 0.93); });
    for (int k = 0; k < 3; ++k) {
        surface.redistance();
        for (Index c = 0; c < grid.cells().size(); ++c) {
            const Real y = (static_cast<Real>(c / 12) + 0.5) * 0.1;
            CHECK(std::abs(surface.distance()[c] - (y - 0.93)) < 1e-12);
        }
    }
}

TEST_CASE("the volume of a disc and of a ball, with order 2", "[fluids][level_set]") {
    const auto off = [](Index n) {
        auto info = box<2>({n, n}, false, Real(1) / static_cast<Real>(n));
        const StaggeredGrid<2> grid(info);
        LevelSet<2> surface(grid);
        set(surface, grid, [](const Vec<2>& x) { return (x - Vec<2>(0.51, 0.48)).norm() - 0.3; });
        return std::abs(surface.volume() - pi * 0.09);
    };
    CHECK(off(32) < 2e-3);
    CHECK(off(64) < off(32) / 3);
    const StaggeredGrid<3> grid(box<3>({24, 24, 24}, false, 1.0 / 24));
    LevelSet<3> ball(grid);
    set(ball, grid, [](const Vec<3>& x) { return (x - Vec<3>::Constant(0.5)).norm() - 0.3; });
    CHECK(ball.volume() == Approx(4 * pi / 3 * 0.027).epsilon(0.01));
}

TEST_CASE("the surface is shifted to a volume, and solids count for nothing", "[fluids][level_set]") {
    const StaggeredGrid<2> grid(box<2>({20, 10}, false, 0.1));
    LevelSet<2> surface(grid);
    set(surface, grid, [](const Vec<2>& x) { return x[1] - 0.4; });
    CHECK(surface.volume() == Approx(0.8));
    surface.shift_to_volume(0.86);
    CHECK(surface.volume() == Approx(0.86).epsilon(1e-9));
    CHECK(surface.distance()[0] == Approx(0.05 - 0.43).epsilon(1e-9));
    std::vector<CellType> solids(200, CellType::fluid);
    for (std::size_t k = 0; k < 20; k += 2) solids[k] = CellType::solid;
    surface.set_solids(solids);
    CHECK(surface.volume() == Approx(0.76).epsilon(1e-9));
    // Nothing but air, nothing but fluid: no surface to shift.
    surface.distance().setConstant(1);
    surface.shift_to_volume(0.5);
    CHECK(surface.volume() == 0);
    surface.redistance();
    CHECK((surface.distance().array() == 1).all());
}

TEST_CASE("a disc that is carried around keeps its place, and nearly its volume", "[fluids][level_set]") {
    const Index n = 64;
    const StaggeredGrid<2> grid(box<2>({n, n}, false, 1.0 / n));
    LevelSet<2> surface(grid);
    const auto disc = [](const Vec<2>& x) { return (x - Vec<2>(0.5, 0.7)).norm() - 0.15; };
    set(surface, grid, disc);
    const Real before = surface.volume();
    // One turn around the middle.
    FaceField<2> velocity = grid.zero_velocity();
    for (int a = 0; a < 2; ++a)
        for (Index f = 0; f < velocity[a].size(); ++f) {
            const GridPlace<2> x = grid.faces(a).place(grid.faces(a).coordinates(f));
            velocity[a][f] = (a == 0 ? -1 : 1) * 2 * pi * (x[1 - a] / n - 0.5);
        }
    const int steps = 128;
    for (int k = 0; k < steps; ++k) {
        surface.advect(velocity, 1.0 / steps);
        surface.redistance();
    }
    CHECK(surface.volume() == Approx(before).epsilon(0.15));
    Real x = 0, y = 0, mass = 0;
    for (Index c = 0; c < n * n; ++c)
        if (surface.distance()[c] < 0) {
            x += (static_cast<Real>(c % n) + 0.5) / n, y += (static_cast<Real>(c / n) + 0.5) / n, mass += 1;
        }
    CHECK(x / mass == Approx(0.5).margin(0.01));
    CHECK(y / mass == Approx(0.7).margin(0.01));
}

TEST_CASE("values are continued layer by layer by the mean of what is known", "[fluids][level_set]") {
    const Lattice<2> line{.count = {5, 1}};
    std::vector<Known> known{Known::yes, Known::no, Known::no, Known::yes, Known::aside};
    VecX values{{1, 0, 0, 4, 9}};
    Extrapolation<2>().fill(line, known, values);
    CHECK(values == VecX{{1, 1, 4, 4, 9}});
    // Nothing known: nothing changes.
    known.assign(5, Known::no);
    Extrapolation<2>().fill(line, known, values);
    CHECK(values == VecX{{1, 1, 4, 4, 9}});
}
