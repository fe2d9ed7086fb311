#include <pliant/text/format.h>

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

using namespace pliant;

TEST_CASE("format: a quantity takes the prefix of the number that is read", "[text]") {
    CHECK(format_quantity(0.05, "m") == "50 mm");
    CHECK(format_quantity(210e9, "Pa") == "210 GPa");
    CHECK(format_quantity(-2500, "N") == "-2.5 kN");
    CHECK(format_quantity(0.99999, "m/s", 3) == "1 m/s");
    CHECK(format_quantity(-0.99999, "m/s", 3) == "-1 m/s");
    CHECK(format_quantity(0.99999, "m/s", 6) == "999.99 mm/s");
    CHECK(format_quantity(999999, "Pa", 4) == "1 MPa");
    CHECK(format_quantity(1e-3, "s") == "1 ms");
    CHECK(format_quantity(999.96, "Hz", 4) == "1 kHz");
}

TEST_CASE("format: outside of the prefixes that people use, and without any, powers of ten are written out", "[text]") {
    CHECK(format_quantity(3e-13, "m") == "3×10⁻⁴ nm");
    CHECK(format_quantity(7200, "s") == "7200 s");
    CHECK(format_quantity(1.25e-7, "") == "1.25×10⁻⁷");
    CHECK(format_quantity(1e-7, "kg") == "10⁻⁷ kg");
    CHECK(format_quantity(-0.0, "m") == "0 m");
    CHECK(format_quantity(std::numeric_limits<Real>::denorm_min(), "m", 2) == "4.9×10⁻³¹⁵ nm");
}

TEST_CASE("format: what is not a number is not written as one", "[text]") {
    CHECK(format_quantity(std::nan(""), "m") == "undefined");
    CHECK(format_quantity(-std::numeric_limits<Real>::infinity(), "m") == "undefined");
}

TEST_CASE("format: rounding down keeps what has no more digits, however small the number", "[text]") {
    CHECK(rounded_down(0.29, 2) == 0.29);
    CHECK(rounded_down(0.299, 2) == 0.29);
    CHECK(rounded_down(-1.21, 2) == -1.3);
    CHECK(rounded_down(std::numeric_limits<Real>::denorm_min(), 1) <= std::numeric_limits<Real>::denorm_min());
}
