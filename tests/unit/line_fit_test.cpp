// The straight line through measured points.
#include <pliant/math/line_fit.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <vector>

using namespace pliant;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("Points on a line give the line back in any unit", "[fit]") {
    const Real unit = GENERATE(1e-200, 1e-6, 1.0, 1e6, 1e200);
    std::vector<Real> x, y;
    for (int i = 0; i < 6; ++i) {
        x.push_back(unit * (3 + i * i));
        y.push_back(7 - 2 * (3 + i * i));
    }
    const auto fit = fit_line(x, y);
    REQUIRE(fit);
    CHECK_THAT(fit->slope * unit, WithinRel(-2.0, 1e-14));
    CHECK_THAT(fit->intercept, WithinRel(7.0, 1e-13));
    CHECK(fit->largest_deviation < 1e-13);
}

TEST_CASE("Scattered points give the normal equations' answer", "[fit]") {
    // Sum of squares of y - a - b x over (0, 0), (1, 2), (2, 1) is least for b = 1/2, a = 1/2.
    const std::vector<Real> x{0, 1, 2}, y{0, 2, 1};
    const auto fit = fit_line(x, y);
    REQUIRE(fit);
    CHECK_THAT(fit->slope, WithinRel(0.5, 1e-15));
    CHECK_THAT(fit->intercept, WithinRel(0.5, 1e-15));
    CHECK_THAT(fit->largest_deviation, WithinAbs(1.0, 1e-15));
}

TEST_CASE("No line is defined through one place", "[fit]") {
    const std::vector<Real> none, one{1}, same{0, 0, 0}, y{1, 2, 3}, large{1e9, 1e9, 1e9};
    CHECK(!fit_line(none, none));
    CHECK(!fit_line(one, one));
    CHECK(!fit_line(same, y));
    CHECK(!fit_line(large, y));
}
