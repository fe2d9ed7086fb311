// Numbers as a person writes them.
#include <pliant/text/number_text.h>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

using namespace pliant;

TEST_CASE("numbers: decimal, with a point, one sign at most") {
    CHECK(finite_number("10") == 10);
    CHECK(finite_number("010") == 10);
    CHECK(finite_number("+010") == 10);
    CHECK(finite_number("-0.5") == -0.5);
    CHECK(finite_number("+5") == 5);
    CHECK(finite_number(".5") == 0.5);
    CHECK(finite_number("1e3") == 1000);
    CHECK(finite_number("1.7976931348623157e308") == 1.7976931348623157e308);
    for (const char* text : {"",     "+",   "-",    "+-5",  "-+5", "++5",   "--5",  "0x10", "0b1",
                             "010x", "1 2", " 1",   "1 ",   "1e",  "1_000", "five", "1e3x", "\xe2\x88\x92\x35",
                             "inf",  "nan", "-inf", "1e999"}) {
        INFO("'" << text << "'");
        CHECK_FALSE(finite_number(text));
        CHECK_FALSE(whole_number(text));
    }
}

TEST_CASE("numbers: what is beyond all numbers is told from what is none") {
    CHECK(read_number("1e999").error == std::errc::result_out_of_range);
    CHECK(read_number("-1e999").error == std::errc::result_out_of_range);
    CHECK(read_number("1e-999").error == std::errc::result_out_of_range);
    CHECK(read_number("one").error == std::errc::invalid_argument);
    CHECK(std::isinf(read_number("inf").value));
    CHECK(std::isnan(read_number("nan").value));
}

TEST_CASE("numbers: whole ones, however they are written") {
    CHECK(whole_number("0") == 0);
    CHECK(whole_number("-1") == -1);
    CHECK(whole_number("010") == 10);
    CHECK(whole_number("1e4") == 10000);
    CHECK(whole_number("2.0") == 2);
    CHECK(whole_number("8999999999999999") == 8999999999999999);
    for (const char* text : {"1.5", "1e-3", "9e15", "99999999999999999999", "1e300"}) CHECK_FALSE(whole_number(text));
}

TEST_CASE("numbers: a comma is a decimal one, unless it may separate thousands") {
    CHECK(finite_number("1,5") == 1.5);
    CHECK(finite_number("-0,125") == -0.125);
    CHECK(read_number("1,250").ambiguous);
    CHECK_FALSE(read_number("1,250").good());
    CHECK_FALSE(finite_number("1,2,3"));
    CHECK_FALSE(finite_number("1.2,3"));
    CHECK_FALSE(whole_number("1,5"));
}
