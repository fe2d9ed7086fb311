// The pressure projection: what it must do to any velocity, in any box.
#include "fluids_grids.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/multigrid.h>
#include <pliant/fluids/pressure_gradient.h>
#include <pliant/fluids/projection.h>
#include <pliant/math/dense_matrix.h>
#include <pliant/math/error.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// A plate with a hole, a wall of one cell, a lone cell, and two chambers that nothing joins.
StaggeredGridInfo<2> rooms() {
    return drawn({"............",  //
                  ".###########",  //
                  "...#....#..#",  //
                  "...#.##.#..#",  //
                  "...#.##.####",  //
                  "...#....#.##",  //
                  "...#########",  //
                  "............"});
}

template <int Dim>
void check_projection(const StaggeredGridInfo<Dim>& info, Real tolerance = 1e-10) {
    const StaggeredGrid<Dim> grid(info);
    PressureProjection<Dim> projection(grid, {tolerance, 100});
    FaceField<Dim> u = random_velocity(grid);
    const FaceField<Dim> before = u;
    const Real energy = kinetic_energy(grid, u), div = max_divergence(grid, u);
    projection.project(u, 0.1);

    // Free of divergence, without energy from nowhere, and the walls as they were.
    const Real rounding = 1e-13 * max_speed(u) / info.dx;
    CHECK(max_divergence(grid, u) <= tolerance * div + rounding);
    CHECK(kinetic_energy(grid, u) <= energy);
    for (int a = 0; a < Dim; ++a)
        for (Index face : grid.closed_faces(a)) CHECK(u[a][face] == before[a][face]);
    CHECK(projection.pressure().allFinite());
    CHECK(std::abs(projection.pressure().sum()) <= 1e-9 * projection.pressure().cwiseAbs().sum() + 1e-300);

    // Once more changes nothing beyond the tolerance.
    FaceField<Dim> again = u;
    PressureProjection<Dim> fresh(grid, {tolerance, 100});
    fresh.project(again, 0.1);
    Real change = 0;
    for (int a = 0; a < Dim; ++a) change = std::max(change, (again[a] - u[a]).cwiseAbs().maxCoeff());
    CHECK(change <= 1e-6 * max_speed(before));
}

// Largest difference of w·Mv and v·Mw for the V-cycle M, relative.
template <int Dim>
Real asymmetry(const StaggeredGrid<Dim>& grid) {
    Multigrid<Dim> multigrid(grid);
    const FluidRegions<Dim> regions(grid);
    VecX v = VecX::Random(grid.cells().size()), w = VecX::Random(grid.cells().size()), mv, mw;
    regions.remove_means(v);
    regions.remove_means(w);
    multigrid.precondition(v, mv);
    multigrid.precondition(w, mw);
    CHECK(v.dot(mv) > 0);
    return std::abs(w.dot(mv) - v.dot(mw)) / std::sqrt(v.dot(mv) * w.dot(mw));
}

}  // namespace

TEST_CASE("projection frees any velocity of its divergence", "[fluids][projection]") {
    SECTION("closed boxes") {
        check_projection(box<2>({32, 32}));
        check_projection(box<2>({33, 20}));
        check_projection(box<2>({1, 9}));
        check_projection(box<2>({2, 1}));
        check_projection(box<2>({127, 3}, false, 1e-3));
        check_projection(box<3>({8, 8, 8}));
        check_projection(box<3>({7, 1, 12}));
        check_projection(box<3>({9, 5, 3}));
    }
    SECTION("periodic boxes") {
        check_projection(box<2>({16, 16}, true));
        check_projection(box<2>({17, 31}, true));
        check_projection(box<2>({2, 2}, true));
        check_projection(box<2>({3, 1}, true));
        check_projection(box<3>({8, 5, 6}, true));
        StaggeredGridInfo<2> channel = box<2>({15, 10});
        channel.periodic[0] = true;
        check_projection(channel);
    }
    SECTION("solids inside, regions apart from each other") {
        check_projection(rooms());
        StaggeredGridInfo<3> info = box<3>({6, 7, 5});
        info.types.assign(210, CellType::fluid);
        for (std::size_t c : {50, 51, 57, 93, 94, 130}) info.types[c] = CellType::solid;
        check_projection(info);
    }
}

TEST_CASE("the smallest boxes come to rest", "[fluids][projection]") {
    // One fluid cell: all its faces belong to the walls.
    for (const bool periodic : {false, true}) {
        const StaggeredGrid<2> grid(box<2>({1, 1}, periodic));
        PressureProjection<2> projection(grid);
        FaceField<2> u = random_velocity(grid);
        const Real before = u[0][0];
        CHECK(projection.project(u, 1) == 0);
        CHECK(projection.pressure()[0] == 0);
        CHECK(u[0][0] == before);  // the wall's, or a flow that closes onto itself
    }
    // One fluid cell among solids, and no fluid at all.
    const StaggeredGrid<2> lone(drawn({"###", "#.#", "###"})), none(drawn({"###", "###"}));
    CHECK(none.fluid_cells() == 0);
    for (const StaggeredGrid<2>* grid : {&lone, &none}) {
        PressureProjection<2> projection(*grid);
        FaceField<2> u = random_velocity(*grid);
        projection.project(u, 1);
        CHECK(max_speed(u) == 0);
        CHECK(projection.pressure().isZero(0));
    }
}

TEST_CASE("a gradient projects to nothing", "[fluids][projection]") {
    for (const auto& info : {box<2>({24, 17}), box<2>({24, 17}, true), rooms()}) {
        const StaggeredGrid<2> grid(info);
        FaceField<2> u = grid.zero_velocity();
        std::srand(5);
        VecX potential = VecX::Random(grid.cells().size());
        FluidRegions<2>(grid).remove_means(potential);
        subtract_gradient(grid, potential, -1, u);  // u = ∇φ
        PressureProjection<2> projection(grid, {1e-12, 200});
        projection.project(u, 0.5);
        CHECK(max_speed(u) < 1e-10);
        // Its pressure is φ/Δt, of mean 0 in every region.
        CHECK((0.5 * projection.pressure() - potential).lpNorm<Eigen::Infinity>() < 1e-9);
    }
}

TEST_CASE("the Laplacian of a staggered periodic grid has the constant as its only null vector", "[fluids][projection]") {
    const StaggeredGrid<2> grid(box<2>({8, 8}, true));
    const Multigrid<2> multigrid(grid);
    MatX matrix(64, 64);
    VecX column;
    for (Index c = 0; c < 64; ++c) {
        multigrid.finest().apply(VecX::Unit(64, c), column);
        matrix.col(c) = column;
    }
    CHECK((matrix - matrix.transpose()).isZero(0));
    const VecX values = dense_eigen(matrix).values;
    CHECK((values.array().abs() < 1e-12).count() == 1);
    CHECK((matrix * VecX::Ones(64)).isZero(0));
    CHECK_THAT(values[63], WithinRel(8.0, 1e-12));  // the checkerboard is the stiffest, not a null vector
}

TEST_CASE("the V-cycle is symmetric and positive", "[fluids][projection]") {
    CHECK(asymmetry(StaggeredGrid<2>(box<2>({16, 16}))) < 1e-13);
    CHECK(asymmetry(StaggeredGrid<2>(box<2>({17, 22}))) < 1e-13);
    CHECK(asymmetry(StaggeredGrid<2>(box<2>({15, 9}, true))) < 1e-13);
    CHECK(asymmetry(StaggeredGrid<2>(rooms())) < 1e-13);
    CHECK(asymmetry(StaggeredGrid<3>(box<3>({8, 9, 3}))) < 1e-13);
}

TEST_CASE("the number of iterations does not grow with the grid", "[fluids][projection]") {
    for (const Index n : {16, 64, 256}) {
        for (const Index odd : {0, 1}) {
            const StaggeredGrid<2> grid(box<2>({n + odd, n + odd}));
            PressureProjection<2> projection(grid, {1e-5, 100});
            FaceField<2> u = random_velocity(grid);
            CHECK(projection.project(u, 1) <= 6);
        }
    }
    const StaggeredGrid<3> grid(box<3>({32, 31, 20}));
    PressureProjection<3> projection(grid, {1e-5, 100});
    FaceField<3> u = random_velocity(grid);
    CHECK(projection.project(u, 1) <= 8);
}

TEST_CASE("every pass of the solver takes kinetic energy out", "[fluids][projection]") {
    const StaggeredGrid<2> grid(box<2>({40, 30}));
    PressureProjection<2> projection(grid, {1e-8, 100});
    // From p = 0, and once more from the pressure of an unrelated velocity.
    for (const unsigned seed : {1u, 2u}) {
        const FaceField<2> tentative = random_velocity(grid, seed);
        projection.begin(tentative, 0.2);
        Real last = kinetic_energy(grid, tentative);
        while (!projection.converged()) {
            projection.iterate();
            FaceField<2> u = tentative;
            projection.apply(u);
            const Real energy = kinetic_energy(grid, u);
            CHECK(energy <= last);
            last = energy;
            // The residual is the divergence that is left.
            CHECK_THAT(max_divergence(grid, u), WithinRel(projection.remaining_divergence(), 1e-6));
        }
    }
}

TEST_CASE("the last pressure is a head start in a steady flow", "[fluids][projection]") {
    const StaggeredGrid<2> grid(box<2>({64, 64}));
    PressureProjection<2> projection(grid, {1e-4, 100});
    const FaceField<2> tentative = random_velocity(grid);
    FaceField<2> u = tentative;
    const Index cold = projection.project(u, 0.1);
    u = tentative;
    CHECK(projection.project(u, 0.1) == 0);
    // p is scaled to the new time step: Δt p is what matters.
    u = tentative;
    CHECK(projection.project(u, 0.4) == 0);
    CHECK(cold >= 3);
}

TEST_CASE("hydrostatic pressure holds a closed box at rest", "[fluids][projection]") {
    const StaggeredGrid<2> grid(box<2>({12, 20}, false, 0.05));
    FaceField<2> u = grid.zero_velocity();
    for (Index j = 1; j < 20; ++j) u[1].segment(12 * j, 12).setConstant(-9.81 * 0.01);  // Δt g
    PressureProjection<2> projection(grid, {1e-12, 100});
    projection.project(u, 0.01);
    CHECK(max_speed(u) < 1e-12);
    const VecX& p = projection.pressure();
    for (Index j = 1; j < 20; ++j) CHECK_THAT(p[12 * (j - 1)] - p[12 * j], WithinRel(9.81 * 0.05, 1e-9));
}

TEST_CASE("flux that cannot balance is reported with its amount", "[fluids][projection]") {
    StaggeredGridInfo<2> info = box<2>({8, 4}, false, 0.25);
    info.walls[0][0].velocity = {2, 0};
    const StaggeredGrid<2> inflow(info);
    PressureProjection<2> projection(inflow);
    FaceField<2> u = random_velocity(inflow);
    CHECK_THROWS_AS(projection.begin(u, 0.1), Diverged);
    CHECK_THROWS_WITH(projection.begin(u, 0.1), ContainsSubstring("net 2 m^2/s"));

    info.walls[0][1].velocity = {2, 0};
    const StaggeredGrid<2> through(info);
    PressureProjection<2> balanced(through, {1e-10, 100});
    u = random_velocity(through);
    CHECK_NOTHROW(balanced.project(u, 0.1));
    CHECK(max_divergence(through, u) < 1e-8);
}

TEST_CASE("the solver says how far it came when its iterations run out", "[fluids][projection]") {
    const StaggeredGrid<2> grid(box<2>({32, 32}));
    PressureProjection<2> projection(grid, {1e-10, 1});
    FaceField<2> u = random_velocity(grid);
    CHECK_THROWS_WITH(projection.project(u, 0.1),
                      ContainsSubstring("after 1 iterations") && ContainsSubstring("divergence left"));
    CHECK(projection.remaining_divergence() < projection.initial_divergence());
}

TEST_CASE("projection refuses settings and velocities that make no sense", "[fluids][projection]") {
    const StaggeredGrid<2> grid(box<2>({4, 4}));
    CHECK_THROWS_AS(PressureProjection<2>(grid, {0, 10}), Refused);
    CHECK_THROWS_AS(PressureProjection<2>(grid, {std::nan(""), 10}), Refused);
    CHECK_THROWS_AS(PressureProjection<2>(grid, {1e-3, 0}), Refused);
    PressureProjection<2> projection(grid);
    FaceField<2> u = random_velocity(grid);
    CHECK_THROWS_AS(projection.begin(u, 0), Refused);
    CHECK_THROWS_AS(projection.begin(u, -1), Refused);
    u[0][7] = std::nan("");
    CHECK_THROWS_AS(projection.begin(u, 1), Diverged);
}

TEST_CASE("a solve that is interrupted and restored goes on with the same bits", "[fluids][projection]") {
    const StaggeredGrid<2> grid(box<2>({37, 21}));
    PressureProjection<2> projection(grid, {1e-9, 100}), other(grid, {1e-9, 100});
    const FaceField<2> tentative = random_velocity(grid);
    projection.begin(tentative, 0.1);
    projection.iterate();
    projection.iterate();
    other.pressure() = projection.pressure();
    other.residual() = projection.residual();
    other.direction() = projection.direction();
    other.scalars() = projection.scalars();
    for (PressureProjection<2>* p : {&projection, &other})
        while (!p->converged()) p->iterate();
    CHECK(projection.iterations() == other.iterations());
    CHECK(projection.pressure() == other.pressure());
}
