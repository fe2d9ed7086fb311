// The period of an oscillation, from its values step by step.
#include <pliant/time/rhythm.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <numbers>

using namespace pliant;
using Catch::Matchers::WithinRel;

namespace {

Real wave(Real time, Real period) { return std::sin(2 * std::numbers::pi * time / period); }

void watch(Rhythm& rhythm, Real from, Real to, Real period, Real size = 1) {
    for (Real t = from; t < to; t += 0.01) rhythm.note(t, size * wave(t, period), 0.1);
}

}  // namespace

TEST_CASE("rhythm: the period of a wave, between its samples") {
    Rhythm rhythm;
    watch(rhythm, 0, 1.5, 0.777);
    CHECK(!rhythm.period());  // one rise is no period yet
    watch(rhythm, 1.5, 2, 0.777);
    REQUIRE(rhythm.period());
    CHECK_THAT(*rhythm.period(), WithinRel(0.777, 1e-3));
    watch(rhythm, 2, 6, 0.777);
    CHECK_THAT(*rhythm.period(), WithinRel(0.777, 1e-4));
    rhythm.reset();
    CHECK(!rhythm.period());
}

TEST_CASE("rhythm: swings that are too small do not count, and old periods are forgotten") {
    Rhythm rhythm;
    watch(rhythm, 0, 10, 0.5, 0.09);
    CHECK(!rhythm.period());
    watch(rhythm, 0, 5, 0.5);
    CHECK_THAT(*rhythm.period(), WithinRel(0.5, 1e-3));
    watch(rhythm, 5, 5 + 0.25 * (Rhythm::most_periods + 2), 0.25);
    CHECK_THAT(*rhythm.period(), WithinRel(0.25, 1e-3));
}

TEST_CASE("rhythm: its memory is all that it knows") {
    Rhythm one, other;
    watch(one, 0, 3.3, 0.7);
    other.memory() = one.memory();
    watch(one, 3.3, 6, 0.7);
    watch(other, 3.3, 6, 0.7);
    CHECK(one.memory() == other.memory());
    CHECK(one.period() == other.period());
}
