// Indices and exponents in the words on the screen.
#include "platform/index_letters.h"

#include <catch2/catch_test_macros.hpp>

using namespace pliant::viewer;

namespace {

// With private letters written as <lowered> and <raised> ones.
std::string spelled_out(std::string_view text) {
    std::string words;
    const std::string shown = with_index_letters(text);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (static_cast<unsigned char>(shown[i]) != 0xee) {
            words += shown[i];
            continue;
        }
        const unsigned code = (static_cast<unsigned>(shown[i + 1]) & 0x3f) << 6 | (static_cast<unsigned>(shown[i + 2]) & 0x3f);
        words += code == 0x800 ? "_-" : code == 0x801 ? "^-" : std::string(code < 0x400 ? "_" : "^") + static_cast<char>(code);
        i += 2;
    }
    return words;
}

}  // namespace

TEST_CASE("an index behind a symbol is lowered") {
    CHECK(spelled_out("x_d = x − Δt u(x_m)") == "x_d = x − Δt u(x_m)");
    CHECK(with_index_letters("x_d") != "x_d");
    CHECK(spelled_out("ε_max, q′_old; dε_x") == "ε_m_a_x, q′_o_l_d; dε_x");
    CHECK(spelled_out("xᵢ − x₀₋₁") == "x_i − x_0_-_1");
}

TEST_CASE("the key of a parameter and a lone line stay as they are") {
    for (const char* text : {"newton_cap = 20", "set keep_volume", "a _ b", "_x", "x_", "k_much_longer", "plain words", ""})
        CHECK(with_index_letters(text) == text);
}

TEST_CASE("an exponent in brackets is raised without them") {
    CHECK(spelled_out("(1 + s)^(1 − 2n)") == "(1 + s)^1^ ^-^ ^2^n");
    CHECK(with_index_letters("2^10 and x^(") == "2^10 and x^(");
}
