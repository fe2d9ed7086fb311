// A liquid with a free surface: rest, waves, a falling column, solids that move; in two and three dimensions.
#include "fluids_grids.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/liquid.h>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Approx;

namespace {

using std::numbers::pi;
constexpr Real g = 9.81;
const Vec<2> down{0, -g};

LiquidSettings precise(SurfaceCondition condition = SurfaceCondition::at_surface) {
    return {.condition = condition, .keep_volume = true, .projection = {1e-10, 300}};
}

// Height of the surface over the middles of one column of cells.
Real height_in_column(const Liquid<2>& liquid, Index i) {
    const Lattice<2>& cells = liquid.grid().cells();
    const Real dx = liquid.grid().dx();
    for (Index j = cells.count[1] - 2; j >= 0; --j) {
        const Real low = liquid.distance()[cells.index({i, j})], high = liquid.distance()[cells.index({i, j + 1})];
        if (low < 0 && high >= 0) return (static_cast<Real>(j) + Real(0.5) + low / (low - high)) * dx;
    }
    return 0;
}

// Of the pressure in one column, largest difference from g · depth.
template <int Dim>
Real pressure_error(const Liquid<Dim>& liquid, Real height) {
    Real worst = 0;
    for (Index c = 0; c < liquid.grid().cells().size(); ++c) {
        const Real y = liquid.grid().cells().place(liquid.grid().cells().coordinates(c))[1] * liquid.grid().dx();
        if (y < height) worst = std::max(worst, std::abs(liquid.projection().pressure()[c] - g * (height - y)));
    }
    return worst;
}

}  // namespace

TEST_CASE("still water: the pressure of its depth, at any height of the surface", "[fluids][liquid]") {
    for (const Real height : {0.5, 0.47, 0.513}) {
        Liquid<2> tank(box<2>({16, 16}, false, 1.0 / 16), precise());
        tank.fill([&](const Vec<2>& x) { return x[1] - height; });
        for (int k = 0; k < 4; ++k) tank.step(down, 0.01);
        INFO("height " << height);
        CHECK(pressure_error(tank, height) < 1e-9);
        CHECK(max_speed(tank.velocity()) < 1e-10);
        CHECK(tank.volume() == Approx(height).epsilon(1e-9));
    }
    Liquid<3> tank(box<3>({8, 8, 8}, false, 1.0 / 8), precise());
    tank.fill([](const Vec<3>& x) { return x[1] - 0.44; });
    tank.step({0, -g, 0}, 0.01);
    CHECK(pressure_error(tank, 0.44) < 1e-9);
    CHECK(max_speed(tank.velocity()) < 1e-10);
}

TEST_CASE("p = 0 in the middle of a cell of air is off by half a cell, and order 1", "[fluids][liquid]") {
    for (const Index n : {16, 32}) {
        const Real dx = 1 / static_cast<Real>(n);
        Liquid<2> tank(box<2>({n, n}, false, dx), precise(SurfaceCondition::at_cell_centre));
        tank.fill([&](const Vec<2>& x) { return x[1] - 0.5; });
        tank.step(down, 0.01);
        CHECK(pressure_error(tank, 0.5) == Approx(g * dx / 2).epsilon(1e-6));
    }
}

TEST_CASE("in a mould nothing falls", "[fluids][liquid]") {
    Liquid<2> tank(box<2>({20, 20}, false, 0.05), precise(SurfaceCondition::closed));
    tank.fill([](const Vec<2>& x) { return std::max(x[0] - 0.4, x[1] - 0.8); });
    const Real height = height_in_column(tank, 0), volume = tank.volume();
    for (int k = 0; k < 5; ++k) tank.step(down, 0.02);
    CHECK(max_speed(tank.velocity()) < 1e-9);
    CHECK(height_in_column(tank, 0) == Approx(height).margin(0.05 / 20));
    CHECK(tank.volume() == Approx(volume).epsilon(1e-9));
}

TEST_CASE("a wave in a tank has the period of linear theory", "[fluids][liquid]") {
    // T = 2π / √(g k tanh kh), k = π/L: 1.18182 s for L = 1 m, h = 0.5 m; 1.39761 s for h = 0.25 m.
    const auto period = [](Real depth) {
        const Index n = 48;
        Liquid<2> tank(box<2>({n, n}, false, 1.0 / n), {.projection = {1e-7, 300}});
        tank.fill([&](const Vec<2>& x) { return x[1] - depth - 0.02 * std::cos(pi * x[0]); });
        const Real dt = 0.25 / n;
        Real last = 0.02, first = 0, crossed = 0;
        int crossings = 0;
        for (int k = 1; crossings < 3; ++k) {
            tank.step(down, dt);
            const Real now = height_in_column(tank, 0) - height_in_column(tank, n - 1);
            if (last * now < 0) {
                crossed = dt * (k - now / (now - last));
                if (++crossings == 1) first = crossed;
            }
            last = now;
        }
        return crossed - first;
    };
    CHECK(period(0.5) == Approx(1.18181552).epsilon(0.02));
    CHECK(period(0.25) == Approx(1.39761207).epsilon(0.02));
}

TEST_CASE("a falling column runs as fast as measured", "[fluids][liquid]") {
    // Martin and Moyce 1952, n² = 2: the front Z = x/a over T = t √(2g/a) between the experiment, whose gate opens late, and a
    // volume-of-fluid solution with walls to slide along.
    struct Bound {
        Real T, low, high;
    };
    const Bound bounds[] = {{1.219, 1.474 - 0.15, 1.774 + 0.25},
                            {1.997, 2.292 - 0.15, 2.662 + 0.25},
                            {2.547, 2.995 - 0.15, 3.415 + 0.25},
                            {3.345, 4.134 - 0.15, 4.641 + 0.25}};
    const Real a = 0.05715, dx = a / 12, dt = 0.002, scale = std::sqrt(2 * g / a);
    Liquid<2> tank(box<2>({72, 36}, false, dx), {.projection = {1e-6, 300}});
    tank.fill([&](const Vec<2>& x) { return std::max(x[0] - a, x[1] - 2 * a); });
    const auto front = [&] {
        Index furthest = 0;
        for (Index c = 0; c < tank.distance().size(); ++c)
            if (tank.distance()[c] < 0) furthest = std::max(furthest, c % 72);
        return static_cast<Real>(furthest + 1) * dx;
    };
    Real before = front();
    int step = 0;
    for (const Bound& b : bounds) {
        for (; step * dt * scale < b.T; ++step) tank.step(down, dt);
        INFO("T = " << step * dt * scale << ", Z = " << front() / a);
        CHECK(front() / a > b.low);
        CHECK(front() / a < b.high);
    }
    // No front is faster than that of shallow water over a dry bed [Ritter1892].
    CHECK((front() - before) / (step * dt) < 2 * std::sqrt(g * 2 * a));
    CHECK(tank.volume() == Approx(2 * a * a).epsilon(1e-3));
    CHECK(tank.volume() == Approx(tank.kept_volume()).epsilon(1e-9));
}

TEST_CASE("the flow is free of divergence, and no liquid goes through walls or solids", "[fluids][liquid]") {
    StaggeredGridInfo<2> info = box<2>({40, 30}, false, 0.025);
    info.types.assign(1200, CellType::fluid);
    for (Index j = 0; j < 8; ++j)
        for (Index i = 22; i < 25; ++i) info.types[static_cast<std::size_t>(i + 40 * j)] = CellType::solid;
    Liquid<2> tank(info, {.projection = {1e-9, 300}});
    tank.fill([](const Vec<2>& x) { return std::max(x[0] - 0.3, x[1] - 0.6); });
    for (int k = 0; k < 60; ++k) {
        tank.add_force(down, 0.005);
        tank.advect(0.005);
        tank.begin_projection(0.005);
        while (!tank.projection().converged()) tank.projection().iterate();
        const Real allowed = 1.01e-9 * tank.projection().initial_divergence() + 1e-9;
        tank.end_projection();
        // The faces of walls and solids are at rest, and along them the liquid is free to slide.
        for (int a = 0; a < 2; ++a)
            for (const Index face : tank.grid().closed_faces(a))
                if (tank.grid().prescribed(a, face)) CHECK(tank.velocity()[a][face] == 0);
        CHECK(max_divergence(tank.grid(), tank.velocity()) <= allowed);
        tank.continue_velocity();
        tank.advect_surface(0.005);
        tank.redistance();
        tank.restore_volume();
        tank.classify();
    }
    CHECK(max_speed(tank.velocity()) > 0.5);
}

TEST_CASE("a paddle pushes the water at its own speed and lets it slide", "[fluids][liquid]") {
    StaggeredGridInfo<2> info = box<2>({40, 20}, false, 0.05);
    info.solid_velocity = [](const Vec<2>&) { return Vec<2>(0.3, 0); };
    info.types.assign(800, CellType::fluid);
    for (Index j = 0; j < 20; ++j)
        for (Index i = 8; i < 10; ++i) info.types[static_cast<std::size_t>(i + 40 * j)] = CellType::solid;
    Liquid<2> tank(info, precise());
    tank.fill([](const Vec<2>& x) { return x[1] - 0.5; });
    tank.step(down, 0.01);
    const Lattice<2>& faces = tank.grid().faces(0);
    for (Index j = 0; j < 9; ++j) {
        CHECK(tank.velocity()[0][faces.index({10, j})] == 0.3);
        CHECK(tank.velocity()[0][faces.index({8, j})] == 0.3);
    }
    // In front of it the water rises, behind it sinks.
    CHECK(tank.velocity()[1][tank.grid().faces(1).index({10, 8})] > 0.01);
    CHECK(tank.velocity()[1][tank.grid().faces(1).index({7, 8})] < -0.01);
}

TEST_CASE("all solid, all air, one drop, a tank full to the lid", "[fluids][liquid]") {
    const auto run = [](Liquid<2>& tank) {
        for (int k = 0; k < 3; ++k) tank.step(down, 0.01);
        for (int a = 0; a < 2; ++a) CHECK(tank.velocity()[a].allFinite());
        CHECK(tank.distance().allFinite());
    };
    StaggeredGridInfo<2> info = box<2>({6, 6}, false, 0.1);
    Liquid<2> empty(info, precise());
    run(empty);
    CHECK(max_speed(empty.velocity()) == 0);
    CHECK(empty.volume() == 0);
    Liquid<2> full(info, precise());
    full.fill([](const Vec<2>&) { return Real(-1); });
    run(full);
    CHECK(max_speed(full.velocity()) < 1e-10);
    CHECK(full.volume() == Approx(0.36));
    info.types.assign(36, CellType::solid);
    Liquid<2> rock(info, precise());
    rock.fill([](const Vec<2>& x) { return x[1] - 0.3; });
    run(rock);
    CHECK(max_speed(rock.velocity()) == 0);
    // A drop of one cell falls freely.
    Liquid<2> drop(box<2>({15, 15}, false, 0.1), precise());
    drop.fill([](const Vec<2>& x) { return (x - Vec<2>(0.75, 1.15)).norm() - 0.09; });
    drop.step(down, 0.01);
    CHECK(drop.velocity()[1][drop.grid().faces(1).index({7, 11})] == Approx(-g * 0.01).epsilon(1e-6));
}

TEST_CASE("the same pour twice gives the same bits, also in three dimensions", "[fluids][liquid]") {
    const auto pour = [] {
        auto tank = std::make_unique<Liquid<3>>(box<3>({16, 12, 8}, false, 0.1), LiquidSettings{.projection = {1e-6, 300}});
        tank->fill([](const Vec<3>& x) { return std::max({x[0] - 0.52, x[1] - 0.8, x[2] - 0.6}); });
        for (int k = 0; k < 10; ++k) tank->step({0, -g, 0}, 0.02);
        return tank;
    };
    const auto one = pour(), other = pour();
    for (int a = 0; a < 3; ++a) CHECK(one->velocity()[a] == other->velocity()[a]);
    CHECK(one->distance() == other->distance());
    CHECK(one->volume() == Approx(0.52 * 0.8 * 0.6).epsilon(0.05));
    CHECK(max_speed(one->velocity()) > 1);
}
