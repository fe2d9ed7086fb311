// Bodies on a grid: the difference formulas, the closed forms beside them, frequencies, and the same bodies of finite elements.
#include <pliant/math/error.h>
#include <pliant/math/lanczos.h>
#include <pliant/mesh/disc_mesh.h>
#include <pliant/solids/elastic_solutions.h>
#include <pliant/solids/grid_problem.h>

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace pliant;
using std::numbers::pi;

namespace {

GridBody body_of(GridShape shape, int n, Energy energy = Energy::linear, Real nu = 0.3) {
    return {shape, energy, 1e4, nu, 1, 1000, n};
}

Points<2> random_displacements(Index count) {
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<Real> spread(-0.01, 0.01);
    return Points<2>::NullaryExpr(2, count, [&] { return spread(engine); });
}

}  // namespace

TEST_CASE("differences of stress along the axes add up to the grid's force, for both energies", "[grid]") {
    for (const Energy energy : {Energy::linear, Energy::stvk})
        for (const GridShape shape : {GridShape::block, GridShape::disc}) {
            const GridProblem problem(body_of(shape, 5, energy));
            const ElasticGrid<2>& grid = problem.grid();
            const Points<2> u = random_displacements(grid.node_count());
            ElasticGrid<2>::Tensors stress(4, grid.sample_count());
            for (Index s = 0; s < grid.sample_count(); ++s) {
                const Mat<2> P = problem.body().density().P(Mat<2>::Identity() + grid.gradient(s, u));
                stress.col(s) << P(0, 0), P(0, 1), P(1, 0), P(1, 1);
            }
            Points<2> density = Points<2>::Zero(2, grid.node_count()), force;
            for (const int axis : {0, 1}) grid.add_divergence(axis, stress, density);
            grid.internal_force(u, force);
            CHECK((density * grid.volumes().asDiagonal() + force).norm() < 1e-12 * force.norm());
            for (Index k = 0; k < grid.node_count(); ++k) CHECK(grid.node_at(grid.place_of(k)) == k);
        }
}

TEST_CASE("second differences and the 4-point cross derivative are exact for what they are meant for", "[grid]") {
    const GridProblem problem(body_of(GridShape::block, 6));
    const ElasticGrid<2>& grid = problem.grid();
    Points<2> u(2, grid.node_count());
    for (Index k = 0; k < u.cols(); ++k) {
        const Vec<2> X = grid.positions().col(k);
        u.col(k) << 3 * X.x() * X.x() + X.x() * X.y(), X.y() * X.y() - 2 * X.x() * X.y() * X.y();
    }
    for (Index k = 0; k < u.cols(); ++k) {
        if (!problem.has_stencil(k)) continue;
        const Vec<2> X = grid.positions().col(k);
        CHECK((second_difference(grid, u, k, 0) - Vec<2>(6, 0)).norm() < 1e-10);
        CHECK((second_difference(grid, u, k, 1) - Vec<2>(0, 2 - 4 * X.x())).norm() < 1e-10);
        CHECK((cross_difference(grid, u, k) - Vec<2>(1, -4 * X.y())).norm() < 1e-10);
    }
}

TEST_CASE("Lanczos' method finds the largest eigenvalue", "[lanczos]") {
    // Of the second difference: 4 sin²(n pi/(2(n + 1))).
    for (const Index n : {1, 2, 7, 60}) {
        const auto apply = [n](const VecX& x, VecX& y) {
            y = 2 * x;
            if (n > 1) y.head(n - 1) -= x.tail(n - 1), y.tail(n - 1) -= x.head(n - 1);
        };
        const auto N = static_cast<Real>(n);
        CHECK(std::abs(largest_eigenvalue(n, apply, 80) - 4 * std::pow(std::sin(N * pi / (2 * (N + 1))), 2)) < 1e-9);
    }
    CHECK(largest_eigenvalue(0, {}, 5) == 0);
    CHECK(largest_eigenvalue(
              3, [](const VecX&, VecX& y) { y.setZero(3); }, 5) == 0);
}

TEST_CASE("the fastest motion of a grid: that of waves inside, but faster at free edges where ν is above 0.3", "[grid]") {
    const auto over_inside = [](GridShape shape, int n, Real nu) {
        const GridProblem problem(body_of(shape, n, Energy::linear, nu));
        return 2 / problem.highest_frequency(100) / problem.grid().stable_time_step(100);
    };
    for (const int n : {4, 20}) {
        const Real exact = 1 / std::sin((2 * n - 1) * pi / (4 * n));
        CHECK(std::abs(over_inside(GridShape::rod, n, 0) / exact - 1) < 1e-6);
    }
    CHECK(std::abs(over_inside(GridShape::block, 16, 0.2) - 1) < 1e-3);
    CHECK(std::abs(over_inside(GridShape::block, 16, 0.3) - 1) < 1e-3);
    CHECK(std::abs(over_inside(GridShape::block, 16, 0.45) - 0.9204) < 1e-3);
}

TEST_CASE("a manufactured force has its displacement under both energies, at second order", "[grid]") {
    for (const Energy energy : {Energy::linear, Energy::stvk}) {
        const auto error = [energy](int n) {
            GridBody body = body_of(GridShape::manufactured, n, energy);
            if (energy == Energy::stvk) body.amplitude = 0.03;  // squeezed further, this energy softens
            const GridProblem problem(body);
            return problem.error(problem.equilibrium());
        };
        const Real coarse = error(8), fine = error(16);
        CHECK(std::abs(std::log2(coarse / fine) - 2) < 0.2);
    }
}

TEST_CASE("a spinning disc: its rim is free, stairs cost an order, triangles that follow it do not", "[grid]") {
    const SpinningDisc disc{2, 300, {.lambda = 5000, .mu = 3000}};
    // sigma_rr = (lambda + 2 mu) u' + lambda u/r at the rim.
    const auto u = [&](Real r) { return disc.displacement(Vec<2>(r, 0)).x(); };
    const Real h = 1e-4, slope = (u(2 + h) - u(2 - h)) / (2 * h);
    CHECK(std::abs(11000 * slope + 5000 * u(2) / 2) < 1e-3);
    const auto errors = [](int n) {
        const GridProblem problem(body_of(GridShape::disc, n));
        return std::pair(problem.error(problem.equilibrium()), finite_elements_beside(problem.body()).error);
    };
    const auto [stairs8, triangles8] = errors(8);
    const auto [stairs32, triangles32] = errors(32);
    INFO(stairs8 << " " << stairs32 << ", " << triangles8 << " " << triangles32);
    CHECK(std::abs(std::log(stairs8 / stairs32) / std::log(4) - 1) < 0.2);
    // 2 but for a logarithm, in the largest error.
    CHECK(std::log(triangles8 / triangles32) / std::log(4) > 1.5);
    CHECK(triangles32 < stairs32 / 10);
}

TEST_CASE("a released rod goes through its four corners", "[grid]") {
    const ReleasedRod rod{2, 5, 0.01};
    for (const auto& [t, tip] :
         {std::pair{0.0, 0.02}, {0.2, 0.01}, {0.4, 0.0}, {0.8, -0.02}, {1.2, 0.0}, {1.6, 0.02}, {3.4, 0.01}})
        CHECK(std::abs(rod.displacement(2, t) - tip) < 1e-15);
    CHECK(rod.strain_at(1, 0.1) == 0.01);
    CHECK(rod.strain_at(1.9, 0.1) == 0);
    CHECK(rod.strain_at(1, 0.7) == -0.01);
    CHECK(rod.frequency(2) == 3 * 5 / 8.0);
}

TEST_CASE("a disc of triangles is round, and refuses what makes none", "[grid]") {
    const SimplexMesh<2> mesh = disc_mesh(2, 12, Vec<2>(1, 1));
    CHECK(mesh.node_count() == 1 + 3 * 12 * 13);
    CHECK(std::abs(mesh.volume() / (4 * pi) - 1) < 2e-3);
    CHECK(mesh.facet_count() == 6 * 12);
    CHECK_THROWS_AS(disc_mesh(0, 3), Refused);
    CHECK_THROWS_AS(disc_mesh(1, 0), Refused);
}
