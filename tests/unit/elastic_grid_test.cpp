// Finite differences of an elastic body: the formula inside, waves, the order, the limit of the step, and what is refused.
#include <pliant/continuum/moduli.h>
#include <pliant/math/error.h>
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/elastic_grid.h>
#include <pliant/solids/hyperelastic_fem.h>
#include <pliant/solids/newton_equilibrium.h>

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace pliant;

namespace {

constexpr Real pi = std::numbers::pi;
const auto everywhere = [](const Vec<2>&) { return true; };

Points<2> random_points(Index count, Real size) {
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<Real> spread(-size, size);
    return Points<2>::NullaryExpr(2, count, [&] { return spread(engine); });
}

// Largest error at the nodes of the unit square under the body force of a known displacement, held all around.
Real manufactured_error(int n) {
    const Lame m = IsotropicModuli::from_young_poisson(1e4, 0.3).lame();
    const ElasticGrid<2> grid({n, n}, 1.0 / n, Vec<2>::Zero(), everywhere, Energy::linear, m);
    const auto exact = [](const Vec<2>& X) {
        return Vec<2>(0.1 * std::sin(pi * X.x()) * std::sin(pi * X.y()), 0.05 * std::sin(pi * X.x()) * std::sin(2 * pi * X.y()));
    };
    // -(mu ∇²u + (lambda + mu) ∇ ∇·u)
    const auto force_density = [&](const Vec<2>& X) {
        const Real sx = std::sin(pi * X.x()), cx = std::cos(pi * X.x()), sy = std::sin(pi * X.y()), cy = std::cos(pi * X.y()),
                   s2 = std::sin(2 * pi * X.y()), c2 = std::cos(2 * pi * X.y()), p2 = pi * pi, both = m.lambda + m.mu;
        const Real u_xx = -0.1 * p2 * sx * sy, u_yy = u_xx, u_xy = 0.1 * p2 * cx * cy;
        const Real v_xx = -0.05 * p2 * sx * s2, v_yy = 4 * v_xx, v_xy = 0.1 * p2 * cx * c2;
        return Vec<2>(-m.mu * (u_xx + u_yy) - both * (u_xx + v_xy), -m.mu * (v_xx + v_yy) - both * (u_xy + v_yy));
    };
    DisplacementConstraints<2> held(grid.node_count());
    Points<2> force(2, grid.node_count());
    for (Index k = 0; k < grid.node_count(); ++k) {
        force.col(k) = grid.volumes()[k] * force_density(grid.positions().col(k));
        if (!grid.inside(k)) held.prescribe({k}, Vec<2>::Zero());
    }
    NewtonEquilibrium<2> newton(grid, held, {.tolerance = 1e-11});
    newton.begin(Points<2>::Zero(2, grid.node_count()), force, held);
    newton.solve();
    CHECK(newton.converged());
    Real worst = 0;
    for (Index k = 0; k < grid.node_count(); ++k)
        worst = std::max(worst, (newton.displacement().col(k) - exact(grid.positions().col(k))).cwiseAbs().maxCoeff());
    return worst;
}

// Steps of v += dt a, x += dt v from a random start; the largest displacement in the end over that of the start.
Real growth(const ElasticGrid<2>& grid, Real density, Real dt, int steps) {
    Points<2> u = random_points(grid.node_count(), 1e-6), v = Points<2>::Zero(2, grid.node_count()), f;
    const Real first = u.cwiseAbs().maxCoeff();
    for (int k = 0; k < steps; ++k) {
        grid.internal_force(u, f);
        v -= dt / density * f * grid.volumes().cwiseInverse().asDiagonal();
        u += dt * v;
    }
    return u.cwiseAbs().maxCoeff() / first;
}

}  // namespace

TEST_CASE("inside, the grid's force is Navier–Lamé's with the 4-point cross derivative", "[grid]") {
    const Lame m = IsotropicModuli::from_young_poisson(1e4, 0.3).lame();
    const Real dx = 0.25;
    const ElasticGrid<2> grid({4, 4}, dx, Vec<2>::Zero(), everywhere, Energy::linear, m);
    const Points<2> u = random_points(25, 0.1);
    Points<2> force;
    grid.internal_force(u, force);
    const auto at = [&](int i, int j) { return Vec<2>(u.col(grid.node_at({i, j}))); };
    for (int i = 1; i < 4; ++i)
        for (int j = 1; j < 4; ++j) {
            const Vec<2> xx = (at(i + 1, j) - 2 * at(i, j) + at(i - 1, j)) / (dx * dx),
                         yy = (at(i, j + 1) - 2 * at(i, j) + at(i, j - 1)) / (dx * dx),
                         xy = (at(i + 1, j + 1) - at(i + 1, j - 1) - at(i - 1, j + 1) + at(i - 1, j - 1)) / (4 * dx * dx);
            const Real both = m.lambda + m.mu;
            const Vec<2> expected(m.mu * (xx.x() + yy.x()) + both * (xx.x() + xy.y()),
                                  m.mu * (xx.y() + yy.y()) + both * (xy.x() + yy.y()));
            const Index n = grid.node_at({i, j});
            REQUIRE(grid.inside(n));
            CHECK((-force.col(n) / grid.volumes()[n] - expected).norm() < 1e-10 * expected.norm());
        }
    // Nothing pushes the body as a whole, and a small turn costs nothing.
    CHECK(force.rowwise().sum().norm() < 1e-10 * force.norm());
    Points<2> turn(2, 25);
    for (Index n = 0; n < 25; ++n) turn.col(n) = 1e-3 * Vec<2>(-grid.positions()(1, n), grid.positions()(0, n));
    grid.internal_force(turn, force);
    CHECK(force.norm() < 1e-10);
}

TEST_CASE("the form of metric tensors does not feel a rotation of any angle", "[grid]") {
    const ElasticGrid<2> grid({3, 2}, 0.5, Vec<2>::Zero(), everywhere, Energy::stvk,
                              IsotropicModuli::from_young_poisson(1e4, 0.3).lame());
    Mat<2> R;
    R << 0, -1, 1, 0;
    const Points<2> u = R * grid.positions() - grid.positions();
    Points<2> force;
    grid.internal_force(u, force);
    CHECK(force.norm() < 1e-8);
    CHECK(grid.energy(u) < 1e-10);
}

TEST_CASE("a manufactured solution is met at second order", "[grid]") {
    const Real e8 = manufactured_error(8), e16 = manufactured_error(16), e32 = manufactured_error(32);
    INFO(e8 << " " << e16 << " " << e32);
    CHECK(std::abs(std::log2(e8 / e16) - 2) < 0.2);
    CHECK(std::abs(std::log2(e16 / e32) - 2) < 0.1);
}

TEST_CASE("the longest step is dx over sqrt(c_p² + c_s²)", "[grid]") {
    const ElasticGrid<2> grid({24, 24}, 1.0 / 24, Vec<2>::Zero(), everywhere, Energy::linear,
                              IsotropicModuli::from_young_poisson(1e4, 0.3).lame());
    const Real limit = grid.stable_time_step(1000);
    CHECK(growth(grid, 1000, 0.99 * limit, 2000) < 100);
    CHECK(growth(grid, 1000, 1.01 * limit, 2000) > 1e6);
}

TEST_CASE("a released rod swings as a triangle with the period 4 L/c", "[grid]") {
    // A strip whose nodes keep their height: c = sqrt((lambda + 2 mu)/rho) = 10 m/s.
    const int n = 200;
    const Real density = 1, dt = 0.5 / n / 10;
    const ElasticGrid<2> grid({n, 1}, 1.0 / n, Vec<2>::Zero(), everywhere, Energy::linear,
                              IsotropicModuli::from_young_poisson(100, 0).lame());
    Points<2> u = Points<2>::Zero(2, grid.node_count()), v = u, f;
    u.row(0) = 0.01 * grid.positions().row(0);
    const Index tip = grid.node_at({n, 0});
    const auto run = [&](int steps) {
        for (int k = 0; k < steps; ++k) {
            grid.internal_force(u, f);
            v.row(0) -= dt / density * f.row(0) * grid.volumes().cwiseInverse().asDiagonal();
            for (int j = 0; j < 2; ++j) v(0, grid.node_at({0, j})) = 0;
            u.row(0) += dt * v.row(0);
        }
        return u(0, tip);
    };
    CHECK(std::abs(run(200) - 0.005) < 1e-4);
    CHECK(std::abs(run(200)) < 1e-4);
    CHECK(std::abs(run(400) + 0.01) < 2e-4);
    CHECK(std::abs(run(800) - 0.01) < 3e-4);
}

TEST_CASE("a block under its weight sinks as one of finite elements does", "[grid]") {
    const Lame m = IsotropicModuli::from_young_poisson(1e5, 0.3).lame();
    const auto sink = [&](const ElasticBody<2>& body, const Points<2>& at, const Points<2>& force) {
        DisplacementConstraints<2> held(body.node_count());
        Index top = 0;
        for (Index k = 0; k < at.cols(); ++k) {
            if (at(1, k) < 1e-9) held.prescribe({k}, Vec<2>::Zero());
            if ((at.col(k) - Vec<2>(1, 1)).norm() < 1e-9) top = k;
        }
        NewtonEquilibrium<2> newton(body, held, {.tolerance = 1e-10});
        newton.begin(Points<2>::Zero(2, body.node_count()), force, held);
        newton.solve();
        return Vec<2>(newton.displacement().col(top));
    };
    const int n = 32;
    const ElasticGrid<2> grid({n, n}, 1.0 / n, Vec<2>::Zero(), everywhere, Energy::linear, m);
    Points<2> weight = Points<2>::Zero(2, grid.node_count());
    weight.row(1) = -1e4 * grid.volumes().transpose();
    const Vec<2> by_grid = sink(grid, grid.positions(), weight);

    const SimplexMesh<2> mesh = block_mesh<2>({.size = Vec<2>::Ones(), .cells = {16, 16}});
    const HyperelasticFem<2, 2> fem(mesh, Energy::linear, m);
    Points<2> on_nodes = Points<2>::Zero(2, fem.node_count());
    // Of a uniform load the middles of the edges take all.
    for (Index e = 0; e < mesh.simplex_count(); ++e)
        for (int a = 3; a < 6; ++a) on_nodes(1, fem.elements().elements()(a, e)) -= 1e4 * mesh.volumes()[e] / 3;
    const Vec<2> by_fem = sink(fem, fem.elements().positions(), on_nodes);
    INFO(by_grid.transpose() << " against " << by_fem.transpose());
    CHECK((by_grid - by_fem).norm() < 0.01 * by_fem.norm());
}

TEST_CASE("cells that a shape leaves out are not there; what makes no grid is refused", "[grid]") {
    const Lame m{1, 1};
    const ElasticGrid<2> disc(
        {20, 20}, 0.1, Vec<2>(-1, -1), [](const Vec<2>& X) { return X.norm() < 1; }, Energy::linear, m);
    CHECK(std::abs(disc.volumes().sum() - pi) < 0.15);
    CHECK(disc.node_at({0, 0}) == -1);
    CHECK(disc.node_at({10, 10}) >= 0);
    CHECK_THROWS_AS((ElasticGrid<2>({0, 2}, 0.1, Vec<2>::Zero(), everywhere, Energy::linear, m)), Refused);
    CHECK_THROWS_AS((ElasticGrid<2>({2, 2}, NAN, Vec<2>::Zero(), everywhere, Energy::linear, m)), Refused);
    CHECK_THROWS_AS((ElasticGrid<2>(
                        {2, 2}, 0.1, Vec<2>::Zero(), [](const Vec<2>&) { return false; }, Energy::linear, m)),
                    Refused);
    // Two parts: each needs its own support.
    const ElasticGrid<2> parts(
        {5, 1}, 1, Vec<2>::Zero(), [](const Vec<2>& X) { return std::abs(X.x() - 2.5) > 0.6; }, Energy::linear, m);
    CHECK_THROWS_AS(parts.check_support(DisplacementConstraints<2>(parts.node_count())), Refused);
}
