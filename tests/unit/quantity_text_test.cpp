// Numbers with a unit, as people write them.
#include <pliant/text/quantity_text.h>
#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using Problem = QuantityText::Problem;

namespace {

Real value_of(std::string_view text, std::string_view unit) {
    const QuantityText q = read_quantity(text, unit);
    CAPTURE(text, unit);
    REQUIRE(q.problem == Problem::none);
    return q.value;
}

}  // namespace

TEST_CASE("a number without a unit is in the unit of what it is for") {
    CHECK(value_of("0.02", "s") == 0.02);
    CHECK(value_of("2e-2", "s") == 0.02);
    CHECK(value_of(" 5 ", "m") == 5);
    CHECK(value_of("-3", "") == -3);
    CHECK(value_of("+1.5E3", "Pa") == 1500);
    CHECK(value_of(".5", "m") == 0.5);
}

TEST_CASE("a decimal comma is read as meant, and refused where it may be none") {
    CHECK(value_of("0,5", "kg") == 0.5);
    CHECK(value_of("0,125", "m") == 0.125);
    CHECK(value_of("-1,5e-3", "m") == -0.0015);
    CHECK(value_of("12,25", "m") == 12.25);
    CHECK(value_of("1,2345", "m") == 1.2345);
    CHECK(value_of("1234,567", "m") == 1234.567);
    CHECK(value_of("1,250e2", "m") == 125);
    for (const char* text : {"1,250", "-12,500", "250,000 m"}) CHECK(read_quantity(text, "m").problem == Problem::ambiguous);
    for (const char* text : {"1,234,567", "1.234,5", "1,234.5", ",", "1,,5"}) {
        CAPTURE(text);
        CHECK(read_quantity(text, "m").problem == Problem::no_number);
    }
}

TEST_CASE("a unit may stand behind the number, with an SI prefix") {
    CHECK(value_of("1e-2 s", "s") == 0.01);
    CHECK(value_of("20 ms", "s") == 0.02);
    CHECK(value_of("20ms", "s") == 0.02);
    CHECK(value_of("0,5 ms", "s") == 0.0005);
    CHECK(value_of("10 us", "s") == 1e-5);
    CHECK(value_of("10 µs", "s") == 1e-5);
    CHECK(value_of("10 μs", "s") == 1e-5);  // the Greek letter
    CHECK(value_of("200 GPa", "Pa") == 2e11);
    CHECK(value_of("3 cm", "m") == 0.03);
    CHECK(value_of("12 mm", "m") == 0.012);
    CHECK(value_of("1.5 kN/m", "N/m") == 1500);
    CHECK(value_of("9.81 m/s^2", "m/s²") == 9.81);
    CHECK(value_of("9.81 m/s2", "m/s²") == 9.81);
    CHECK(value_of("2 cm2", "m²") == 2e-4);
    CHECK(value_of("3 mm²/s", "m²/s") == 3e-6);
    CHECK(value_of("5 N·s/m", "N s/m") == 5);
    CHECK(value_of("5 N*s/m", "N s/m") == 5);
    CHECK(value_of("250 g", "kg") == 0.25);
    CHECK(value_of("3 kg", "kg") == 3);
    CHECK(value_of("7 mg", "kg") == 7e-6);
    CHECK(value_of("90 deg", "°") == 90);
    CHECK(value_of("90°", "°") == 90);
    CHECK(value_of("4 1/s", "1/s") == 4);
    CHECK(value_of("4/s", "1/s") == 4);
    CHECK(value_of("2 rad/s", "rad/s") == 2);
    CHECK(value_of("64 cells", "cells") == 64);
    CHECK(value_of("1,5 %", "") == 0.015);
    CHECK(value_of("30%", "") == 0.3);
}

TEST_CASE("a prefix rounds no more than the decimal number itself") {
    CHECK(value_of("35 ms", "s") == 0.035);
    CHECK(value_of("0.7 µs", "s") == 0.7e-6);
    CHECK(value_of("1.1e3 ms", "s") == 1.1);
    CHECK(value_of("0.3 mm²", "m²") == 0.3e-6);
}

TEST_CASE("another unit, and what is no number, are told apart") {
    for (const auto& [text, unit] : {std::pair{"20 kg", "s"},
                                     {"20 min", "s"},
                                     {"20 m", "s"},
                                     {"3 s", ""},
                                     {"3 %", "s"},
                                     {"20 Ms2", "s"},
                                     {"5 kcells", "cells"},
                                     {"5 m°", "°"},
                                     {"2 cs", "s"}}) {
        CAPTURE(text, unit);
        CHECK(read_quantity(text, unit).problem == Problem::other_unit);
    }
    CHECK(read_quantity("20 kg", "s").unit == "kg");
    for (const char* text : {"", " ", "2*3", "2+3", "1/2", "abc", "1 2", "0x10", "1.2.3", "--1", "1e", "- 1", "5 m 6"}) {
        CAPTURE(text);
        CHECK(read_quantity(text, "m").problem != Problem::none);
    }
    for (const char* text : {"2*3", "1/2", "abc", "1 2", "0x10", "1.2.3"}) {
        CAPTURE(text);
        CHECK(read_quantity(text, "m").problem == Problem::no_number);
    }
    CHECK(read_quantity("1e400", "m").problem == Problem::out_of_range);
    CHECK(read_quantity("1e308 Gm", "m").problem == Problem::out_of_range);
}

TEST_CASE("messages can name the units that are read") {
    CHECK(units_accepted("s") == "s, ms or µs");
    CHECK(units_accepted("Pa") == "Pa, kPa or MPa");
    CHECK(units_accepted("kg") == "kg or g");
    CHECK(units_accepted("°") == "°");
    CHECK(units_accepted("").empty());
}
