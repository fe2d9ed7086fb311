// Motions in closed form against their equations, and up to the edge of their ranges.
#include <pliant/time/exact_motion.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>

using namespace pliant;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("damped oscillator: from rest, at every damping", "[exact_motion]") {
    const Real zeta = GENERATE(0.0, 0.3, 0.999999, 1.0, 1.000001, 40.0);
    const Real omega = 3, h = 1e-4;
    const auto x = [&](Real t) { return damped_oscillator(omega, zeta, {1, 0}, t).x; };
    CHECK_THAT(x(0), WithinAbs(1, 1e-12));
    for (const Real t : {0.1, 0.7, 2.0}) {
        const Real a = (x(t + h) - 2 * x(t) + x(t - h)) / (h * h), v = (x(t + h) - x(t - h)) / (2 * h);
        CHECK_THAT(a + 2 * zeta * omega * v + omega * omega * x(t), WithinAbs(0, 1e-5));
    }
}

// Next to ζ = 1 the two forms meet: x = e^(-ωt) (1 + ωt + O((1 - ζ) ω²t²)).
TEST_CASE("damped oscillator: both sides of critical damping are one motion", "[exact_motion]") {
    for (const Real off : {1e-16, 1e-14, 1e-12})
        for (const Real t : {1e-8, 1e-3, 1., 20.}) {
            const Real critical = std::exp(-t) * (1 + t);
            CHECK_THAT(damped_oscillator(1, 1 - off, {1, 0}, t).x, WithinRel(critical, 1e-15 + 1e-15 + 300 * off));
            CHECK_THAT(damped_oscillator(1, 1 + off, {1, 0}, t).x, WithinRel(critical, 1e-15 + 1e-15 + 300 * off));
        }
}

TEST_CASE("pendulum: rests, swings, turns, and comes to the top", "[exact_motion]") {
    const Pendulum rests(2, 9.81, {0, 0}), turns(3, 9, {0.2, 7}), tops(3, 9, {0, 6});
    CHECK(rests.at(5).x == 0);
    CHECK_FALSE(rests.reaches_top());
    // The gravity of 9 m/s² makes the length 1 m; 6 m/s below are just enough for the top.
    CHECK(tops.reaches_top());
    CHECK(std::isinf(tops.period()));
    for (const Real t : {0.1, 1., 4.}) {
        CHECK_THAT(tops.at(t).x, WithinRel(2 * std::atan(std::sinh(3 * t)), 1e-14));
        CHECK_THAT(tops.at(t).v, WithinRel(6 / std::cosh(3 * t), 1e-14));
    }
    CHECK(turns.reaches_top());
    CHECK_THAT(turns.at(turns.period()).x - 0.2, WithinRel(2 * 3.14159265358979324, 1e-13));
    CHECK_THAT(turns.at(turns.period()).v, WithinRel(7., 1e-13));
}

// The energy of a start next to the top, on either side of what the top takes, is that of the motion at every time.
TEST_CASE("pendulum: the energy stays what it was, next to the top too", "[exact_motion]") {
    for (const Real off : {-1e-3, -1e-9, -1e-14, 1e-14, 1e-9, 1e-3}) {
        const Pendulum pendulum(3, 9, {0, 6 * (1 + off)});
        CHECK(pendulum.reaches_top() == (off > 0));
        for (const Real t : {0., 0.5, 2., 7., 31.}) {
            INFO("off " << off << ", t " << t);
            const auto [x, v] = pendulum.at(t);
            CHECK_THAT(v * v / 2 + 18 * std::pow(std::sin(x / 2), 2), WithinRel(18 * (1 + off) * (1 + off), 1e-13));
        }
    }
}
