// The numbers along the axes of a plot.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "plot/ticks.h"

#include <cmath>
#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::viewer;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

std::vector<std::string> numbers(const Ticks& ticks) {
    std::vector<std::string> texts;
    for (const Tick& tick : ticks.ticks) {
        if (!tick.text.empty()) texts.push_back(tick.text);
    }
    return texts;
}

// 1, 2 or 5 times a power of ten?
bool is_nice(Real step) {
    const Real factor = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    return std::abs(factor - 1) < 1e-6 || std::abs(factor - 2) < 1e-6 || std::abs(factor - 5) < 1e-6;
}

}  // namespace

TEST_CASE("Linear ticks are evenly spaced multiples of 1, 2 or 5 times a power of ten, inside the range and not too many") {
    for (const Real size : {1e-280, 1e-12, 1e-3, 1.0, 7.3, 1e6, 1e280}) {
        for (const Range part : {Range{0, 1}, Range{-0.37, 0.81}, Range{-3, -2.2}, Range{100, 101.3}}) {
            for (const int most : {2, 3, 5, 8, 12}) {
                const Range range{part.lo * size, part.hi * size};
                const auto ticks = make_ticks(range, AxisScale::linear, most, "").ticks;
                CAPTURE(size, part.lo, most);
                REQUIRE(ticks.size() <= static_cast<std::size_t>(most));
                for (std::size_t i = 0; i < ticks.size(); ++i) {
                    const Real rounding = 1e-5 * range.span();
                    REQUIRE(ticks[i].value >= range.lo - rounding);
                    REQUIRE(ticks[i].value <= range.hi + rounding);
                    REQUIRE_FALSE(ticks[i].text.empty());
                    if (i == 0) continue;
                    const Real step = ticks[i].value - ticks[i - 1].value;
                    REQUIRE(is_nice(step));
                    REQUIRE_THAT(std::remainder(ticks[i].value, step), WithinAbs(0, 1e-6 * step));
                }
                if (most >= 8) REQUIRE(ticks.size() >= 3);
            }
        }
    }
}

TEST_CASE("The numbers carry an SI prefix or a power of ten, never both") {
    const Ticks pressure = make_ticks({0, 412e3}, AxisScale::linear, 6, "Pa");
    CHECK(pressure.unit == "kPa");
    CHECK(numbers(pressure) == std::vector<std::string>{"0", "100", "200", "300", "400"});

    const Ticks length = make_ticks({0, 5e-6}, AxisScale::linear, 6, "m");
    CHECK(length.unit == "µm");
    CHECK(numbers(length).back() == "5");

    CHECK(make_ticks({0, 4e4}, AxisScale::linear, 6, "N/m³").unit == "10³ N/m³");
    CHECK(make_ticks({0, 4e-7}, AxisScale::linear, 6, "").unit == "×10⁻⁹");
    // Seconds take no kilo.
    CHECK(make_ticks({0, 4e4}, AxisScale::linear, 6, "s").unit == "10³ s");
}

TEST_CASE("Numbers have as many decimals as the steps need and no minus sign before zero") {
    CHECK(numbers(make_ticks({-0.5, 0.5}, AxisScale::linear, 6, "m")) ==
          std::vector<std::string>{"-0.4", "-0.2", "0.0", "0.2", "0.4"});
    CHECK(numbers(make_ticks({0, 0.1}, AxisScale::linear, 3, "m")) == std::vector<std::string>{"0.00", "0.05", "0.10"});
    CHECK(numbers(make_ticks({-100, 100}, AxisScale::linear, 3, "m")) == std::vector<std::string>{"-100", "0", "100"});
}

TEST_CASE("Numbers that differ only in late digits are counted from an offset") {
    const Ticks energy = make_ticks({1e6 - 0.003, 1e6 + 0.003}, AxisScale::linear, 8, "J");
    CHECK(energy.offset == "1000000 J");
    CHECK(energy.unit == "mJ");
    CHECK(numbers(energy) == std::vector<std::string>{"-3", "-2", "-1", "0", "+1", "+2", "+3"});
    CHECK(axis_text("energy E", energy) == "energy E = 1000000 J + … [mJ]");

    const Ticks below = make_ticks({-1e6 - 0.003, -1e6 + 0.003}, AxisScale::linear, 8, "J");
    CHECK(axis_text("energy E", below) == "energy E = -1000000 J + … [mJ]");
}

TEST_CASE("A number, its unit and the offset together give the value back") {
    for (const Real middle : {0.0, 1.0, 250.0, 1e6, -3e9}) {
        for (const Real half : {2e-6, 0.3, 40.0, 7e5}) {
            if (half < 1e-11 * std::abs(middle)) continue;
            const Ticks ticks = make_ticks({middle - half, middle + half}, AxisScale::linear, 7, "");
            // A dimensionless axis has a power of ten for its unit: "×10⁻⁶"; its exponent follows from the spacing of the
            // numbers.
            const auto texts = numbers(ticks);
            REQUIRE(texts.size() >= 2);
            const Real scale = (ticks.ticks[1].value - ticks.ticks[0].value) / (std::stod(texts[1]) - std::stod(texts[0]));
            const Real offset = ticks.offset.empty() ? 0 : std::stod(ticks.offset);
            CAPTURE(middle, half);
            CHECK_THAT(std::log10(scale), WithinAbs(std::round(std::log10(scale)), 1e-4));
            for (std::size_t i = 0; i < texts.size(); ++i) {
                CHECK_THAT(offset + scale * std::stod(texts[i]), WithinAbs(ticks.ticks[i].value, 1e-3 * half));
            }
        }
    }
}

TEST_CASE("Log ticks stand at powers of ten with the multiples in between unnumbered") {
    const Ticks ticks = make_ticks({1e-7, 1e-1}, AxisScale::log, 8, "m");
    CHECK(numbers(ticks) == std::vector<std::string>{"10⁻⁷", "10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²", "10⁻¹"});
    CHECK(ticks.ticks.size() == 6 * 9 + 1);
    CHECK_THAT(ticks.ticks[1].value, WithinRel(2e-7, 1e-12));
    CHECK(ticks.unit == "m");
}

TEST_CASE("A long log axis leaves out powers, a short one numbers 2 and 5, a very short one is numbered like a linear one") {
    const auto thinned = numbers(make_ticks({1e-12, 1}, AxisScale::log, 5, ""));
    CHECK(thinned == std::vector<std::string>{"10⁻¹²", "10⁻⁹", "10⁻⁶", "10⁻³", "10⁰"});
    CHECK(numbers(make_ticks({1, 10}, AxisScale::log, 8, "")) == std::vector<std::string>{"1", "2", "5", "10"});
    CHECK(numbers(make_ticks({2.1, 2.9}, AxisScale::log, 8, "")).size() >= 3);
    CHECK(numbers(make_ticks({1e-300, 1e300}, AxisScale::log, 6, "")).size() <= 6);
}

TEST_CASE("The label of an axis holds its name and its unit, where there are any") {
    const Ticks plain{{}, "s", ""}, none{};
    CHECK(axis_text("time t", plain) == "time t [s]");
    CHECK(axis_text("", plain) == "[s]");
    CHECK(axis_text("steps", none) == "steps");
    CHECK(power_of_ten(0) == "10⁰");
    CHECK(power_of_ten(-123) == "10⁻¹²³");
}
