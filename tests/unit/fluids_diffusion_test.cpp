// Diffusion and viscosity against their Fourier factors and closed forms.
#include "channel_grid.h"

#include <pliant/fluids/diffusion.h>
#include <pliant/math/error.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>
#include <type_traits>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

template <int Dim>
Lattice<Dim> periodic_lattice(Counts<Dim> count) {
    Lattice<Dim> lattice;
    lattice.count = count;
    for (auto& axis : lattice.sides) axis = {LatticeSide{Beyond::periodic}, LatticeSide{Beyond::periodic}};
    return lattice;
}

// cos(Σ 2π m_a i_a / n_a): one Fourier mode.
template <int Dim>
VecX mode(const Lattice<Dim>& lattice, std::type_identity_t<Counts<Dim>> waves) {
    VecX q(lattice.size());
    for (Index i = 0; i < q.size(); ++i) {
        const Counts<Dim> at = lattice.coordinates(i);
        Real phase = 0;
        for (int a = 0; a < Dim; ++a) phase += 2 * pi * static_cast<Real>(waves[a] * at[a]) / static_cast<Real>(lattice.count[a]);
        q[i] = std::cos(phase);
    }
    return q;
}

// 4 Σ sin²(k_a Δx/2)
template <int Dim>
Real eigenvalue(const Lattice<Dim>& lattice, std::type_identity_t<Counts<Dim>> waves) {
    Real sum = 0;
    for (int a = 0; a < Dim; ++a)
        sum += 4 * std::pow(std::sin(pi * static_cast<Real>(waves[a]) / static_cast<Real>(lattice.count[a])), 2);
    return sum;
}

template <int Dim>
void check_factors(const Lattice<Dim>& lattice, std::type_identity_t<Counts<Dim>> waves, Real r) {
    const VecX before = mode(lattice, waves);
    const Real lambda = r * eigenvalue(lattice, waves);
    Diffusion<Dim> diffusion(lattice);
    VecX q = before;
    diffusion.explicit_step(q, r);
    CHECK((q - (1 - lambda) * before).template lpNorm<Eigen::Infinity>() < 1e-13 * (1 + lambda));
    q = before;
    diffusion.implicit_step(q, r, {1e-13, 1000});
    CHECK((q - before / (1 + lambda)).template lpNorm<Eigen::Infinity>() < 1e-11);
}

// u at half the height of the channel: between the two middle rows of an even number.
Real middle(const StaggeredGrid<2>& grid, const FaceField<2>& velocity) {
    const Index row = grid.cell_counts()[1] / 2;
    return 0.5 * (velocity[0][grid.faces(0).index({1, row})] + velocity[0][grid.faces(0).index({1, row - 1})]);
}

}  // namespace

TEST_CASE("a Fourier mode decays by its explicit and implicit factor", "[fluids][diffusion]") {
    check_factors<2>(periodic_lattice<2>({32, 24}), {3, 5}, 0.2);
    check_factors<2>(periodic_lattice<2>({32, 24}), {1, 0}, 10);
    check_factors<2>(periodic_lattice<2>({9, 1}), {2, 0}, 0.7);
    check_factors<3>(periodic_lattice<3>({8, 6, 10}), {3, 1, 4}, 0.15);
    check_factors<3>(periodic_lattice<3>({8, 6, 10}), {1, 2, 0}, 25);
}

TEST_CASE("the checkerboard shows the stability limit of the explicit stencil", "[fluids][diffusion]") {
    const Lattice<2> lattice = periodic_lattice<2>({8, 8});
    const VecX board = mode<2>(lattice, {4, 4});
    Diffusion<2> diffusion(lattice);
    for (const auto& [r, factor] : {std::pair{0.2, -0.6}, {0.25, -1.0}, {0.26, -1.08}}) {
        VecX q = board;
        diffusion.explicit_step(q, r);
        CHECK((q - factor * board).lpNorm<Eigen::Infinity>() < 1e-13);
    }
    VecX q = board;
    diffusion.implicit_step(q, 10, {1e-13, 100});
    CHECK_THAT(q[0], WithinRel(1.0 / 81, 1e-10));

    STATIC_CHECK(Diffusion<2>::explicit_limit() == 0.25);
    CHECK_THAT(Diffusion<3>::explicit_limit(), WithinRel(1.0 / 6, 1e-15));
}

TEST_CASE("diffusion converges with order 2 in space and 1 in time", "[fluids][diffusion]") {
    const Real nu = 0.1, end = 0.5;
    const auto error = [&](Index n, Index steps, bool implicit) {
        const Lattice<2> lattice = periodic_lattice<2>({n, n});
        Diffusion<2> diffusion(lattice);
        const VecX before = mode<2>(lattice, {1, 1});
        VecX q = before;
        const Real r = nu * end / static_cast<Real>(steps) * static_cast<Real>(n * n) / (4 * pi * pi);  // on a domain of 2π
        for (Index s = 0; s < steps; ++s) {
            if (implicit)
                diffusion.implicit_step(q, r, {1e-12, 1000});
            else
                diffusion.explicit_step(q, r);
        }
        return (q - std::exp(-2 * nu * end) * before).lpNorm<Eigen::Infinity>();
    };
    // At a fixed small time step the error is that of space; on a fine grid that of time.
    CHECK_THAT(std::log2(error(8, 4000, false) / error(16, 4000, false)), WithinAbs(2, 0.1));
    CHECK_THAT(std::log2(error(256, 1, true) / error(256, 2, true)), WithinAbs(1, 0.1));
    CHECK_THAT(std::log2(error(256, 2, true) / error(256, 4, true)), WithinAbs(1, 0.1));
}

TEST_CASE("a channel starts up as the series solution says", "[fluids][diffusion]") {
    // u(1/2) at t = 0.2, 0.5 and 1 s for H = 1 m, ν = 0.1 m²/s and a lid at 1 m/s.
    const std::array<std::pair<Real, Real>, 3> published = {{{0.2, 0.01241933}, {0.5, 0.11384420}, {1.0, 0.26275627}}};
    const auto errors = [&](Index n, Index steps_per_second, bool implicit) {
        const StaggeredGrid<2> grid = channel(n, 1);
        Viscosity<2> viscosity(grid);
        FaceField<2> u = grid.zero_velocity();
        const Real dt = 1 / static_cast<Real>(steps_per_second);
        Real largest = 0;
        Index step = 0;
        for (const auto& [time, exact] : published) {
            for (; static_cast<Real>(step) * dt < time - dt / 2; ++step) {
                if (implicit)
                    viscosity.diffuse_implicitly(u, 0.1, dt, {1e-11, 1000});
                else
                    viscosity.diffuse_explicitly(u, 0.1, dt);
            }
            largest = std::max(largest, std::abs(middle(grid, u) - exact));
        }
        CHECK(u[1].isZero(0));  // nothing flows across
        return largest;
    };
    // Explicit at a fixed diffusion number r = 0.16: order 2 in Δx.
    const Real coarse = errors(8, 40, false), fine = errors(16, 160, false), finest = errors(64, 2560, false);
    CHECK_THAT(std::log2(coarse / fine), WithinAbs(2, 0.2));
    CHECK_THAT(std::log2(fine / finest) / 2, WithinAbs(2, 0.2));
    CHECK(finest < 1e-4);
    CHECK(errors(64, 2560, true) < 2e-4);
}

TEST_CASE("a lattice of one row has the stencil of one dimension", "[fluids][diffusion]") {
    Lattice<2> row = periodic_lattice<2>({7, 1});
    const auto stencil_of = [&](const VecX& q) {
        VecX out;
        Diffusion<2>(row).stencil(q, out);
        return out;
    };
    const VecX q = VecX::LinSpaced(7, 0, 6).array().square();
    VecX expected = VecX::Constant(7, 2);
    expected[0] = 1 + 36, expected[6] = 25 - 72;
    CHECK(stencil_of(q) == expected);
    row.sides[0] = {LatticeSide{}, LatticeSide{}};
    expected[0] = 1, expected[6] = 25 - 36;
    CHECK(stencil_of(q) == expected);
    row.sides[0] = {LatticeSide{Beyond::wall_value, 3}, LatticeSide{Beyond::wall_value, -1}};
    expected[0] = 1 + 6, expected[6] = 25 - 72 - 2 - 36;
    CHECK(stencil_of(q) == expected);
    // Its checkerboard grows beyond r = 1/2.
    row = periodic_lattice<2>({8, 1});
    for (const auto& [r, factor] : {std::pair{0.25, 0.0}, {0.5, -1.0}, {0.52, -1.08}}) {
        const VecX board = mode<2>(row, {4, 0});
        VecX after = board;
        Diffusion<2>(row).explicit_step(after, r);
        CHECK((after - factor * board).lpNorm<Eigen::Infinity>() < 1e-13);
    }
}

TEST_CASE("implicit diffusion by single iterations is the same step", "[fluids][diffusion]") {
    const Lattice<2> lattice = periodic_lattice<2>({16, 12});
    std::srand(4);
    const VecX before = VecX::Random(lattice.size());
    Diffusion<2> whole(lattice), stepped(lattice);
    VecX a = before, b = before;
    const Index iterations = whole.implicit_step(a, 3);
    stepped.begin_implicit(b, 3);
    Real last = stepped.residual_norm();
    while (!stepped.converged()) {
        stepped.iterate(b);
        // The residual is what is left of the equation.
        VecX sums;
        stepped.stencil(b, sums);
        CHECK((before - b + 3 * sums - stepped.residual()).lpNorm<Eigen::Infinity>() < 1e-13);
        last = stepped.residual_norm();
    }
    CHECK(stepped.iterations() == iterations);
    CHECK(a == b);
    CHECK(last <= stepped.target());
    stepped.iterate(b);
    CHECK(a == b);
    // A uniform quantity needs no iteration.
    VecX even = VecX::Ones(lattice.size());
    stepped.begin_implicit(even, 3);
    CHECK(stepped.converged());
    stepped.iterate(even);
    CHECK(even == VecX::Ones(lattice.size()));
}

TEST_CASE("a driven channel is a parabola but for the constant of its linear walls", "[fluids][diffusion]") {
    // G = 2 m/s², H = 1 m, ν = 0.1 m²/s: u = G y (H − y)/(2ν), and the reflected value half a cell beyond a wall adds G Δx²/(8ν).
    const Real G = 2, nu = 0.1;
    for (const Index n : {8, 16, 32}) {
        Lattice<2> row;
        row.count = {n, 1};
        row.sides[0] = {LatticeSide{Beyond::wall_value, 0}, LatticeSide{Beyond::wall_value, 0}};
        Diffusion<2> diffusion(row);
        const Real dx = 1 / static_cast<Real>(n), dt = 1e3;
        VecX u = VecX::Zero(n);
        for (int step = 0; step < 20; ++step) {
            u.array() += G * dt;
            diffusion.implicit_step(u, nu * dt / (dx * dx), {1e-14, 1000});
        }
        for (Index i = 0; i < n; ++i) {
            const Real y = (static_cast<Real>(i) + 0.5) * dx;
            CHECK_THAT(u[i] - G * y * (1 - y) / (2 * nu), WithinAbs(G * dx * dx / (8 * nu), 1e-8));
        }
    }
}

TEST_CASE("viscosity refuses what is unstable and costs nothing at zero", "[fluids][diffusion]") {
    const StaggeredGrid<2> grid = channel(10, 1);
    Viscosity<2> viscosity(grid);
    FaceField<2> u = grid.zero_velocity();
    u[0].setRandom();
    const VecX before = u[0];

    viscosity.diffuse_explicitly(u, 0, 1);
    CHECK(viscosity.diffuse_implicitly(u, 0, 1) == 0);
    CHECK(u[0] == before);
    CHECK(std::isinf(viscosity.explicit_limit(0)));

    CHECK_THAT(viscosity.explicit_limit(0.1), WithinRel(0.01 / 0.4, 1e-12));
    CHECK_NOTHROW(viscosity.diffuse_explicitly(u, 0.1, 0.025));
    CHECK_THROWS_AS(viscosity.diffuse_explicitly(u, 0.1, 0.02501), Refused);
    CHECK_THROWS_WITH(viscosity.diffuse_explicitly(u, 1e6, 1), ContainsSubstring("2.5e-09 s") && ContainsSubstring("time_step"));
    CHECK_THROWS_WITH(viscosity.diffuse_implicitly(u, -1, 1), ContainsSubstring("viscosity"));
    CHECK_THROWS_AS(viscosity.diffuse_implicitly(u, std::nan(""), 1), Refused);
    CHECK_THROWS_AS(viscosity.diffuse_implicitly(u, 1, 0), Refused);

    StaggeredGridInfo<3> info;
    info.cells = {2, 2, 2};
    const StaggeredGrid<3> space(info);
    CHECK_THAT(Viscosity<3>(space).explicit_limit(2), WithinRel(1.0 / 12, 1e-12));
}

TEST_CASE("a huge viscosity takes the flow to its walls' velocity or to its mean", "[fluids][diffusion]") {
    StaggeredGridInfo<2> info;
    info.cells = {6, 20};
    info.dx = 0.05;
    info.periodic = {true, false};
    for (auto& wall : info.walls[1]) wall = {Slip::none, {3, 0}};
    const StaggeredGrid<2> between_walls(info);
    FaceField<2> u = between_walls.zero_velocity();
    Viscosity<2> viscosity(between_walls);
    CHECK(viscosity.diffuse_implicitly(u, 1e6, 1) > 0);
    CHECK((u[0].array() - 3).abs().maxCoeff() < 1e-4);

    info.periodic = {true, true};
    const StaggeredGrid<2> endless(info);
    u = endless.zero_velocity();
    u[0].setRandom();
    const Real mean = u[0].mean();
    Viscosity<2> mixing(endless);
    mixing.diffuse_implicitly(u, 1e6, 1);
    CHECK((u[0].array() - mean).abs().maxCoeff() < 1e-6);
}

TEST_CASE("an implicit step reports the residual when its iterations run out", "[fluids][diffusion]") {
    const Lattice<2> lattice = periodic_lattice<2>({32, 32});
    Diffusion<2> diffusion(lattice);
    VecX q = VecX::Random(lattice.size());
    CHECK_THROWS_WITH(diffusion.implicit_step(q, 100, {1e-10, 2}),
                      ContainsSubstring("residual") && ContainsSubstring("2 iterations"));
}
