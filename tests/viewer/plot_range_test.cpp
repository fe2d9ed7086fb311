// The intervals that the axes of a plot show.
#include "special_numbers.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "plot/range.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {}

TEST_CASE("The range of data leaves out what cannot be shown") {
    const std::vector<Real> values{3, not_a_number, -2, infinity, -infinity, 0, 1e301};
    CHECK(data_range(values, AxisScale::linear) == Range{-2, 3});
    CHECK(data_range(values, AxisScale::log) == Range{3, 3});
    CHECK_FALSE(data_range(std::vector<Real>{not_a_number, infinity}, AxisScale::linear));
    CHECK_FALSE(data_range(std::vector<Real>{0, -1}, AxisScale::log));
    CHECK_FALSE(data_range({}, AxisScale::linear));
}

TEST_CASE("A nice range holds the data, wastes little and does not depend on the unit of length") {
    for (const Range data : {Range{0, 9.3}, Range{-1, 1}, Range{0.2, 0.21}, Range{-7e3, -6.5e3}, Range{12, 5600}}) {
        for (const Margin margin : {Margin::none, Margin::some}) {
            const Range nice = nice_range(data, AxisScale::linear, margin);
            CAPTURE(data.lo, data.hi);
            CHECK(nice.contains(data));
            CHECK(nice.span() < 1.75 * data.span());
            const Range micro = nice_range({1e-6 * data.lo, 1e-6 * data.hi}, AxisScale::linear, margin);
            CHECK_THAT(micro.lo, WithinAbs(1e-6 * nice.lo, 1e-12 * data.span()));
            CHECK_THAT(micro.hi, WithinAbs(1e-6 * nice.hi, 1e-12 * data.span()));
        }
    }
}

TEST_CASE("Data of one sign begin at zero, not below") {
    CHECK(nice_range({0, 9.3}, AxisScale::linear, Margin::some).lo == 0);
    CHECK(nice_range({-4, 0}, AxisScale::linear, Margin::some).hi == 0);
}

TEST_CASE("A nice log range ends on powers of ten, or on 1, 2 or 5 within a decade") {
    const Range wide = nice_range({3e-7, 0.02}, AxisScale::log, Margin::some);
    CHECK_THAT(wide.lo, WithinRel(1e-7, 1e-12));
    CHECK_THAT(wide.hi, WithinRel(0.1, 1e-12));
    const Range narrow = nice_range({2.2, 4.1}, AxisScale::log, Margin::some);
    CHECK_THAT(narrow.lo, WithinRel(2.0, 1e-12));
    CHECK_THAT(narrow.hi, WithinRel(5.0, 1e-12));
    const Range exact = nice_range({1e-4, 1e-1}, AxisScale::log, Margin::none);
    CHECK_THAT(exact.lo, WithinRel(1e-4, 1e-12));
    CHECK_THAT(exact.hi, WithinRel(1e-1, 1e-12));
}

TEST_CASE("A single value gets room on both sides") {
    for (const Real value : {0.0, 2.5, -1e-9, 1e12, 1e300, -1e300}) {
        const Range range = nice_range({value, value}, AxisScale::linear, Margin::some);
        CAPTURE(value);
        CHECK(range.lo <= value);
        CHECK(range.hi >= value);
        CHECK(range.span() > 0);
        CHECK(std::isfinite(range.span()));
    }
    const Range log = nice_range({3, 3}, AxisScale::log, Margin::some);
    CHECK((log.lo < 3 && log.hi > 3 && log.lo > 0));
    CHECK(nice_range({0, 0}, AxisScale::linear, Margin::none) == Range{0, 1});
    // Values that differ only by rounding count as one.
    const Real next = std::nextafter(1e6, 2e6);
    CHECK(nice_range({1e6, next}, AxisScale::linear, Margin::some).span() > 1e4);
}

TEST_CASE("An automatic range changes a few times while data stream in, and then by much") {
    AutoRange time, wave;
    int changes = 0;
    for (int step = 1; step <= 100000; ++step) {
        const Real t = 1e-3 * step;
        const auto before = time.shown;
        time.follow({0, t}, AxisScale::linear, Margin::none);
        REQUIRE(time.shown->contains(Range{0, t}));
        if (before && *before != *time.shown) {
            ++changes;
            REQUIRE(time.shown->span() >= 1.15 * before->span());
        }
    }
    CHECK(changes <= 40);

    // The values of now, of a wave that passes through zero all the time: the range stays as wide as it was.
    wave.follow({-1, 1}, AxisScale::linear, Margin::some);
    const Range full = *wave.shown;
    for (int step = 0; step < 1000; ++step) {
        const Real amplitude = std::abs(std::cos(0.1 * step));
        wave.follow({-amplitude, amplitude}, AxisScale::linear, Margin::some);
        REQUIRE(*wave.shown == full);
    }
}

TEST_CASE("The room about a first single value gives way to the data that follow") {
    AutoRange range;
    range.follow({0, 0}, AxisScale::linear, Margin::some);
    CHECK(*range.shown == Range{-1, 1});
    range.follow({0, 1e-6}, AxisScale::linear, Margin::some);
    CHECK(range.shown->span() < 3e-6);
}

TEST_CASE("Data that have started over are noticed") {
    AutoRange range;
    range.follow({0, 50}, AxisScale::linear, Margin::none);
    CHECK_FALSE(range.far_too_wide({0, 49}, AxisScale::linear));
    CHECK_FALSE(range.far_too_wide({0, 0}, AxisScale::linear));
    CHECK(range.far_too_wide({0, 0.1}, AxisScale::linear));
}

TEST_CASE("Zoom keeps the value under the pointer, and can be undone") {
    for (const AxisScale scale : {AxisScale::linear, AxisScale::log}) {
        const Range range{2, 300};
        for (const Real at : {0.0, 0.3, 1.0}) {
            const Range in = zoomed(range, scale, at, 1.5);
            CHECK_THAT(value_at(in, scale, at), WithinRel(value_at(range, scale, at), 1e-12));
            const Range out = zoomed(in, scale, at, 1 / 1.5);
            CHECK_THAT(out.lo, WithinRel(range.lo, 1e-11));
            CHECK_THAT(out.hi, WithinRel(range.hi, 1e-11));
        }
        const Range there = panned(range, scale, 0.25), back = panned(there, scale, -0.25);
        CHECK(there.lo > range.lo);
        CHECK_THAT(back.lo, WithinRel(range.lo, 1e-11));
        CHECK_THAT(back.hi, WithinRel(range.hi, 1e-11));
    }
}

TEST_CASE("However far one zooms, the axis keeps two ends that differ and are finite") {
    for (const AxisScale scale : {AxisScale::linear, AxisScale::log}) {
        for (const Real factor : {1.7, 1 / 1.7}) {
            Range range{1, 10};
            for (int i = 0; i < 3000; ++i) range = zoomed(range, scale, 0.4, factor);
            CHECK(range.lo < range.hi);
            CHECK(std::isfinite(range.span()));
            CHECK((scale == AxisScale::linear || range.lo > 0));
        }
    }
}

TEST_CASE("Numbers that agree to four digits are shown to agree; who zooms in sees more") {
    const Range match = nice_range({0.149460001, 0.149460003}, AxisScale::linear, Margin::some);
    CHECK(match.span() > 1e-4);
    CHECK(match.span() < 2e-3);
    CHECK(match.contains({0.149460001, 0.149460003}));
    CHECK(nice_range({0.14946018, 0.14946054}, AxisScale::linear, Margin::some).span() > 1e-4);
    // A place that is looked at closely is no match of anything either.
    CHECK(nice_range({1, 1.00001}, AxisScale::linear, Margin::none).span() < 2e-5);
    const Range differ = nice_range({0.1494, 0.1495}, AxisScale::linear, Margin::some);
    CHECK(differ.span() < 3e-4);
    // What is nearly 0 is no match of anything.
    CHECK(nice_range({-1e-12, 1e-12}, AxisScale::linear, Margin::some).span() < 1e-11);
    const Range zoom = zoomed(match, AxisScale::linear, 0.5, 1e4);
    CHECK(zoom.span() < 1e-6);
}
