// A compressible gas in a tube: its mass to rounding, the speed of its waves, and the shock tube.
#include <pliant/fluids/isothermal_gas.h>
#include <pliant/math/error.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <numbers>

using namespace pliant;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

Real place(const IsothermalGas& gas, Index cell) { return (static_cast<Real>(cell) + 0.5) * gas.info().dx; }

void run(IsothermalGas& gas, Real time, Real part_of_limit = 0.9) {
    for (Real t = 0; t < time;) {
        const Real dt = std::min(part_of_limit * gas.stable_step(), time - t);
        gas.step(dt);
        t = dt == time - t ? time : t + dt;
    }
}

}  // namespace

TEST_CASE("isothermal gas: mass is conserved to rounding while the density changes", "[fluids]") {
    for (const TubeEnds ends : {TubeEnds::closed, TubeEnds::periodic}) {
        IsothermalGas gas({.cells = 100, .dx = 0.01, .speed_of_sound = 1, .ends = ends});
        for (Index i = 0; i < 100; ++i) gas.momentum()[i] = 0.5 * std::sin(2 * pi * place(gas, i));
        const Real mass = gas.mass();
        run(gas, 0.3);
        CHECK_THAT(gas.mass(), WithinRel(mass, 1e-14));
        CHECK(gas.density().maxCoeff() > 1.2);
        CHECK(gas.density().minCoeff() < 0.85);
        run(gas, 5);
        CHECK_THAT(gas.mass(), WithinRel(mass, 1e-13));
        CHECK(gas.density().minCoeff() > 0);
    }
}

TEST_CASE("isothermal gas: a small disturbance travels at the speed of sound", "[fluids]") {
    const auto late_by = [](Index n) {
        IsothermalGas gas({.cells = n, .dx = Real(1) / static_cast<Real>(n), .speed_of_sound = 2, .ends = TubeEnds::periodic});
        // A wave to the right: u = c δρ/ρ.
        for (Index i = 0; i < n; ++i) {
            const Real excess = 1e-6 * std::cos(2 * pi * place(gas, i));
            gas.density()[i] = 1 + excess;
            gas.momentum()[i] = 2 * excess;
        }
        run(gas, 0.5);  // once around the tube
        Real in_phase = 0, out_of_phase = 0;
        for (Index i = 0; i < n; ++i) {
            in_phase += (gas.density()[i] - 1) * std::cos(2 * pi * place(gas, i));
            out_of_phase += (gas.density()[i] - 1) * std::sin(2 * pi * place(gas, i));
        }
        CHECK(in_phase > 0.8 * 0.5e-6 * static_cast<Real>(n));
        return std::abs(std::atan2(out_of_phase, in_phase)) / (2 * pi);  // of a wave length
    };
    CHECK(late_by(200) < 1e-3);
}

TEST_CASE("isothermal gas: between the waves of a shock tube lies the exact state", "[fluids]") {
    const GasState left{3, 0}, right{1, 0};
    const GasState middle = between_waves(left, right, 1);
    // The shock obeys the jump conditions, and the rarefaction keeps u + c ln ρ.
    const Real shock = middle.density * middle.velocity / (middle.density - right.density);
    CHECK_THAT(middle.density * middle.velocity * middle.velocity + middle.density - right.density,
               WithinRel(shock * middle.density * middle.velocity, 1e-12));
    CHECK_THAT(middle.velocity + std::log(middle.density), WithinRel(std::log(left.density), 1e-12));

    IsothermalGas gas({.cells = 400, .dx = Real(1) / 400});
    gas.density().head(200).setConstant(left.density);
    run(gas, 0.25);
    const Index between = 200 + static_cast<Index>(400 * 0.25 * 0.5 * (middle.velocity - 1 + shock));
    CHECK_THAT(gas.density()[between], WithinRel(middle.density, 2e-3));
    CHECK_THAT(gas.momentum()[between] / gas.density()[between], WithinRel(middle.velocity, 2e-3));
    // The shock stands where it should, to three cells.
    const auto behind = static_cast<Index>(200 + 400 * 0.25 * shock);
    CHECK(gas.density()[behind - 4] > 0.9 * middle.density);
    CHECK(gas.density()[behind + 4] < 1.1 * right.density);
}

TEST_CASE("isothermal gas: what cannot be is refused with the limit", "[fluids]") {
    CHECK_THROWS_AS(IsothermalGas({.cells = 0}), Refused);
    CHECK_THROWS_AS(IsothermalGas({.cells = 2, .dx = 0}), Refused);
    CHECK_THROWS_AS(IsothermalGas({.cells = 2, .speed_of_sound = NAN}), Refused);
    IsothermalGas gas({.cells = 1});
    CHECK_THROWS_AS(gas.step(1.01), Refused);
    CHECK_THROWS_AS(gas.step(0), Refused);
    gas.step(1);
    CHECK(gas.mass() == 1);
}
