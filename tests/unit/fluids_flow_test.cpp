// Whole time steps, forces to projection, against published and analytic flows.
#include "fluids_grids.h"

#include <pliant/fluids/advection.h>
#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/diffusion.h>
#include <pliant/fluids/forces.h>
#include <pliant/fluids/projection.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

// A grid, a velocity and the stages in the order of the lecture.
template <int Dim>
struct Flow {
    StaggeredGrid<Dim> grid;
    FaceField<Dim> velocity;
    SemiLagrangian<Dim> advection;
    Viscosity<Dim> viscosity;
    PressureProjection<Dim> projection;
    Vec<Dim> gravity = Vec<Dim>::Zero();
    Real nu = 0;

    explicit Flow(const StaggeredGridInfo<Dim>& info, Real tolerance = 1e-6)
        : grid(info), velocity(grid.zero_velocity()), advection(grid), viscosity(grid), projection(grid, {tolerance, 100}) {
        grid.impose_walls(velocity);
    }

    void step(Real dt) {
        add_uniform_force(grid, velocity, dt, gravity);
        advection.advect(velocity, dt);
        viscosity.diffuse_implicitly(velocity, nu, dt, {1e-7, 1000});
        projection.project(velocity, dt);
    }
};

// u = sin 2πx cos 2πy, v = −cos 2πx sin 2πy on the periodic unit square, divergence-free on the faces to rounding.
Flow<2> taylor_green(Index n, Real nu) {
    Flow<2> flow(box<2>({n, n}, true, 1 / static_cast<Real>(n)));
    flow.nu = nu;
    for (int a = 0; a < 2; ++a) {
        for (Index i = 0; i < n * n; ++i) {
            const GridPlace<2> at = flow.grid.faces(a).place(flow.grid.faces(a).coordinates(i));
            const Real x = 2 * pi * at[0] / static_cast<Real>(n), y = 2 * pi * at[1] / static_cast<Real>(n);
            flow.velocity[a][i] = a == 0 ? std::sin(x) * std::cos(y) : -std::cos(x) * std::sin(y);
        }
    }
    return flow;
}

// The viscosity that the observed decay of the energy over t seconds amounts to.
Real effective_viscosity(Index n, Real nu, Real courant, Real end) {
    Flow<2> flow = taylor_green(n, nu);
    const Real before = kinetic_energy(flow.grid, flow.velocity);
    const auto steps = static_cast<Index>(std::lround(end * static_cast<Real>(n) / courant));
    for (Index s = 0; s < steps; ++s) flow.step(end / static_cast<Real>(steps));
    return -std::log(kinetic_energy(flow.grid, flow.velocity) / before) / (16 * pi * pi * end);
}

StaggeredGridInfo<2> lid_driven(Index n) {
    StaggeredGridInfo<2> info = box<2>({n, n}, false, 1 / static_cast<Real>(n));
    for (auto& axis : info.walls)
        for (auto& wall : axis) wall.slip = Slip::none;
    info.walls[1][1].velocity = {1, 0};
    return info;
}

}  // namespace

TEST_CASE("a Taylor-Green vortex decays as its viscosity says, and by the interpolation", "[fluids][flow]") {
    // Energy falls by exp(−16π²νt). Linear interpolation adds a viscosity of order |u|Δx: first order in the grid.
    const Real nu = 0.01;
    const Real excess_16 = effective_viscosity(16, nu, 0.5, 0.25) - nu, excess_32 = effective_viscosity(32, nu, 0.5, 0.25) - nu,
               excess_64 = effective_viscosity(64, nu, 0.5, 0.25) - nu;
    CHECK(excess_64 > 0);
    CHECK(excess_64 < 0.3 * nu);
    CHECK_THAT(std::log2(excess_16 / excess_32), WithinAbs(1, 0.2));
    CHECK_THAT(std::log2(excess_32 / excess_64), WithinAbs(1, 0.2));
    // It is |u|Δx(1 − s)/2 for s cells per step: the shorter the step, the more often is interpolated.
    CHECK(effective_viscosity(32, 0, 0.5, 0.25) < effective_viscosity(32, 0, 0.05, 0.25));
}

TEST_CASE("without advection the Taylor-Green vortex decays by exp(−8π²νt)", "[fluids][flow]") {
    const Real nu = 0.01;
    const auto decay = [&](Index n, Index steps) {
        Flow<2> flow = taylor_green(n, nu);
        const Real before = kinetic_energy(flow.grid, flow.velocity);
        for (Index s = 0; s < steps; ++s) {
            flow.viscosity.diffuse_implicitly(flow.velocity, nu, 1 / static_cast<Real>(steps), {1e-10, 1000});
            flow.projection.project(flow.velocity, 1 / static_cast<Real>(steps));
        }
        return kinetic_energy(flow.grid, flow.velocity) / before;
    };
    CHECK_THAT(decay(64, 200), WithinRel(0.20615299, 5e-3));
    CHECK_THAT(std::log2((decay(64, 20) - 0.20615299) / (decay(64, 40) - 0.20615299)), WithinAbs(1, 0.2));
}

TEST_CASE("stirred fluid in three dimensions stays finite, divergence-free and inside its box", "[fluids][flow]") {
    StaggeredGridInfo<3> info = box<3>({16, 20, 13}, false, 0.05);
    for (auto& wall : info.walls[2]) wall.slip = Slip::none;
    Flow<3> flow(info);
    flow.nu = 1e-3;
    for (int step = 0; step < 20; ++step) {
        add_force(flow.grid, flow.velocity, 0.05, [](const Vec<3>& x) {
            const Vec<3> r = x - Vec<3>(0.4, 0.5, 0.3);
            return Vec<3>(20 * std::exp(-r.squaredNorm() / 0.02) * Vec<3>(-r[1], r[0], 0.2));
        });
        const FaceField<3> forced = flow.velocity;
        flow.step(0.05);
        // The interpolation and the viscosity only take energy.
        CHECK(kinetic_energy(flow.grid, flow.velocity) <= kinetic_energy(flow.grid, forced) * 1.05);
    }
    CHECK(kinetic_energy(flow.grid, flow.velocity) > 1e-4);
    CHECK(max_divergence(flow.grid, flow.velocity) <= 1e-6 * flow.projection.initial_divergence() * (1 + 1e-6));
    for (int a = 0; a < 3; ++a)
        for (Index face : flow.grid.closed_faces(a)) CHECK(flow.velocity[a][face] == 0);
}

TEST_CASE("gravity in a closed box moves nothing", "[fluids][flow]") {
    Flow<2> flow(box<2>({24, 30}, false, 0.1), 1e-12);
    flow.gravity = {0, -9.81};
    for (int step = 0; step < 50; ++step) flow.step(0.02);
    CHECK(max_speed(flow.velocity) < 1e-10);
}

TEST_CASE("the same run twice gives the same bits", "[fluids][flow]") {
    const auto run = [] {
        Flow<2> flow(lid_driven(20));
        flow.nu = 0.01;
        for (int step = 0; step < 20; ++step) flow.step(0.05);
        return flow.velocity;
    };
    const FaceField<2> first = run(), second = run();
    for (int a = 0; a < 2; ++a) CHECK(first[a] == second[a]);
}

TEST_CASE("another unit of length gives the same flow", "[fluids][flow]") {
    const auto run = [](Real unit) {
        StaggeredGridInfo<2> info = lid_driven(24);
        info.dx *= unit;
        info.walls[1][1].velocity *= unit;
        Flow<2> flow(info, 1e-8);
        flow.nu = 0.01 * unit * unit;
        for (int step = 0; step < 30; ++step) flow.step(0.05);
        FaceField<2> scaled = flow.velocity;
        for (int a = 0; a < 2; ++a) scaled[a] /= unit;
        return scaled;
    };
    const FaceField<2> metres = run(1);
    for (const Real unit : {1e-6, 1e6}) {
        const FaceField<2> other = run(unit);
        for (int a = 0; a < 2; ++a) CHECK((metres[a] - other[a]).lpNorm<Eigen::Infinity>() < 1e-6);
    }
}
