// Advection schemes against each other: orders of convergence, what they keep, what explains their numbers.
#include "advection_flows.h"
#include "fluids_grids.h"

#include <pliant/fluids/interpolation_stencil.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using std::numbers::pi;

namespace {

constexpr AdvectionSettings cubic{BackTrace::midpoint, Interpolation::monotone_cubic};
constexpr AdvectionSettings mac_cormack{BackTrace::midpoint, Interpolation::linear, true};

// A sine carried over half a period at Courant number 1/2: the mean error, which the flat neighbourhoods of the extrema,
// where limiters act, enter with little weight.
Real sine_error(const AdvectionSettings& settings, Index n) {
    const StaggeredGrid<2> grid = periodic_grid(n, 1, 1 / static_cast<Real>(n));
    SemiLagrangian<2> advection(grid, settings);
    VecX quantity(n), exact(n);
    for (Index i = 0; i < n; ++i) {
        const Real x = (static_cast<Real>(i) + 0.5) / static_cast<Real>(n);
        quantity[i] = std::sin(2 * pi * x);
        exact[i] = std::sin(2 * pi * (x - 0.5));
    }
    for (Index step = 0; step < n; ++step) advection.advect(quantity, uniform(grid, 1, 0), 0.5 / static_cast<Real>(n));
    return (quantity - exact).lpNorm<1>() / static_cast<Real>(n);
}

// The same away from the extrema alone: within a tenth of a period of the places where the exact solution crosses 0.
Real steep_error(const AdvectionSettings& settings, Index n) {
    const StaggeredGrid<2> grid = periodic_grid(n, 1, 1 / static_cast<Real>(n));
    SemiLagrangian<2> advection(grid, settings);
    VecX quantity(n);
    for (Index i = 0; i < n; ++i) quantity[i] = std::sin(2 * pi * (static_cast<Real>(i) + 0.5) / static_cast<Real>(n));
    for (Index step = 0; step < n / 8; ++step) advection.advect(quantity, uniform(grid, 1, 0), 0.5 / static_cast<Real>(n));
    Real largest = 0;
    for (Index i = 0; i < n; ++i) {
        const Real exact = std::sin(2 * pi * ((static_cast<Real>(i) + 0.5) / static_cast<Real>(n) - 1.0 / 16));
        if (std::abs(exact) < 0.58) largest = std::max(largest, std::abs(quantity[i] - exact));
    }
    return largest;
}

// Order of the place that one step of a solid rotation by `angle` comes from, less 1.
Real path_error(BackTrace trace, Real angle) {
    const StaggeredGrid<2> grid(box<2>({40, 40}));
    FaceField<2> u = grid.zero_velocity();
    for (int a = 0; a < 2; ++a)
        for (Index f = 0; f < u[a].size(); ++f) {
            const GridPlace<2> x = grid.faces(a).place(grid.faces(a).coordinates(f));
            u[a][f] = a == 0 ? -(x[1] - 20) : x[0] - 20;
        }
    SemiLagrangian<2> advection(grid, {trace});
    VecX nothing = VecX::Zero(grid.cells().size());
    advection.advect(nothing, u, 0);
    const Departure<2> d = advection.departure({30, 20}, angle);
    return std::hypot(d.departure[0] - (20 + 10 * std::cos(angle)), d.departure[1] - (20 - 10 * std::sin(angle)));
}

template <int Dim>
void check_stencil(const AdvectionSettings& settings) {
    StaggeredGridInfo<Dim> info = box<Dim>([] {
        Counts<Dim> n;
        n.fill(6);
        return n;
    }());
    info.walls[0][0].slip = Slip::none;
    info.periodic[1] = true;
    const StaggeredGrid<Dim> grid(info);
    SemiLagrangian<Dim> advection(grid, settings);
    FaceField<Dim> u = random_velocity(grid, 5);
    const FaceField<Dim> before = u;
    const Real dt = 0.7;
    advection.advect(u, dt);
    for (int a = 0; a < Dim; ++a) {
        const PaddedField<Dim>& field = advection.flow().component(a);
        for (Index f = 0; f < u[a].size(); ++f) {
            if (std::ranges::binary_search(grid.closed_faces(a), f)) continue;
            const Departure<Dim> d = advection.departure(grid.faces(a).place(grid.faces(a).coordinates(f)), dt);
            Real sum = 0, weights = 0;
            for (const WeightedSample<Dim>& s : interpolation_stencil<Dim>(field, d.departure).samples) {
                sum += s.weight * field.sample(s.at);
                weights += s.weight;
            }
            CHECK_THAT(weights, WithinAbs(1, 1e-13));
            CHECK_THAT(sum, WithinAbs(u[a][f], 1e-12));
        }
    }
}

}  // namespace

TEST_CASE("orders of the interpolation errors per unit of time", "[fluids][advection]") {
    CHECK_THAT(std::log2(sine_error({}, 64) / sine_error({}, 128)), WithinAbs(1, 0.15));
    CHECK_THAT(std::log2(sine_error(mac_cormack, 64) / sine_error(mac_cormack, 128)), WithinAbs(2, 0.25));
    CHECK(std::log2(steep_error(cubic, 64) / steep_error(cubic, 128)) > 1.9);
    CHECK(std::log2(steep_error(mac_cormack, 64) / steep_error(mac_cormack, 128)) > 1.9);
    CHECK(sine_error(cubic, 128) < sine_error(mac_cormack, 128));
    CHECK(sine_error(mac_cormack, 128) < 0.1 * sine_error({}, 128));
}

TEST_CASE("the path back has order 1 by Euler's method and order 2 by the midpoint rule", "[fluids][advection]") {
    // One step of an order p errs by the power p + 1.
    CHECK_THAT(std::log2(path_error(BackTrace::euler, 0.1) / path_error(BackTrace::euler, 0.05)), WithinAbs(2, 0.05));
    CHECK_THAT(std::log2(path_error(BackTrace::midpoint, 0.1) / path_error(BackTrace::midpoint, 0.05)), WithinAbs(3, 0.05));
}

TEST_CASE("no scheme makes a new extremum of a quantity in cells, among walls and solids", "[fluids][advection]") {
    StaggeredGridInfo<2> info = drawn({"........", ".##.....", ".##..#..", "........", "...#....", "........"});
    info.periodic[0] = true;
    const StaggeredGrid<2> grid(info);
    const FaceField<2> u = random_velocity(grid, 11);
    std::srand(4);
    const VecX before = VecX::Random(48);
    for (const AdvectionSettings& settings : all_schemes())
        for (const Real courant : {0.1, 1.0, 5.0, 20.0, 100.0}) {
            SemiLagrangian<2> advection(grid, settings);
            VecX quantity = before;
            for (int step = 0; step < 5; ++step) advection.advect(quantity, u, courant);
            CHECK(quantity.maxCoeff() <= before.maxCoeff() + 1e-14);
            CHECK(quantity.minCoeff() >= before.minCoeff() - 1e-14);
            for (Index c = 0; c < 48; ++c)
                if (!grid.is_fluid(c)) CHECK(quantity[c] == before[c]);
        }
}

TEST_CASE("samples and weights of a target give its value", "[fluids][advection]") {
    for (const BackTrace trace : {BackTrace::euler, BackTrace::midpoint})
        for (const Interpolation interpolation : {Interpolation::linear, Interpolation::monotone_cubic}) {
            check_stencil<2>({trace, interpolation});
            check_stencil<3>({trace, interpolation});
        }
}

TEST_CASE("a monotone cubic is exact for parabolas away from their vertex and stays between its samples", "[fluids][advection]") {
    const auto parabola = [](Real x) { return 3 - 2 * x + x * x; };
    CHECK_THAT(monotone_cubic<Real>({parabola(2), parabola(3), parabola(4), parabola(5)}, 0.3), WithinAbs(parabola(3.3), 1e-13));
    for (const std::array<Real, 4>& q :
         {std::array<Real, 4>{0, 1, 1, 0}, {5, 0, 1, -7}, {-9, 0, 0.1, 9}, {1, 2, 2.001, 80}, {3, -1, 4, 1}}) {
        Real last = q[1];
        for (Real t = 0; t <= 1; t += 1.0 / 64) {
            const Real value = monotone_cubic(q, t);
            CHECK((q[2] >= q[1] ? value >= last : value <= last));
            last = value;
            const std::array<Real, 4> w = monotone_cubic_weights(q, t);
            CHECK_THAT(w[0] * q[0] + w[1] * q[1] + w[2] * q[2] + w[3] * q[3], WithinAbs(value, 1e-13));
        }
    }
}

TEST_CASE("MacCormack's correction takes back most of what interpolation loses, in space too", "[fluids][advection]") {
    // A smooth hill carried once through a periodic cube.
    const auto peak_after = [](const AdvectionSettings& settings) {
        const StaggeredGrid<3> grid(box<3>({16, 16, 16}, true));
        VecX quantity(grid.cells().size());
        for (Index c = 0; c < quantity.size(); ++c) {
            Real product = 1;
            for (const Real x : grid.cells().place(grid.cells().coordinates(c))) product *= (1 - std::cos(pi * x / 8)) / 2;
            quantity[c] = product;
        }
        FaceField<3> u = grid.zero_velocity();
        for (VecX& component : u.components) component.setConstant(0.5);
        SemiLagrangian<3> advection(grid, settings);
        const Real before = quantity.maxCoeff();
        for (int step = 0; step < 32; ++step) advection.advect(quantity, u, 1);
        return quantity.maxCoeff() / before;
    };
    const Real linear = peak_after({}), corrected = peak_after(mac_cormack), smooth = peak_after(cubic);
    CHECK(linear < 0.5);
    CHECK(corrected > 0.7);
    CHECK(smooth > 0.7);
    CHECK(corrected <= 1);
    CHECK(smooth <= 1);
}
