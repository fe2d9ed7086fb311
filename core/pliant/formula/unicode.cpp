#include <pliant/formula/unicode.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pliant {
namespace {

using Small = std::pair<char32_t, std::string_view>;

constexpr std::array<Small, 42> raised_letters{
    {{U'⁰', "0"}, {U'¹', "1"}, {U'²', "2"}, {U'³', "3"}, {U'⁴', "4"}, {U'⁵', "5"}, {U'⁶', "6"}, {U'⁷', "7"}, {U'⁸', "8"},
     {U'⁹', "9"}, {U'⁻', "−"}, {U'⁺', "+"}, {U'ᵃ', "a"}, {U'ᵇ', "b"}, {U'ᶜ', "c"}, {U'ᵈ', "d"}, {U'ᵉ', "e"}, {U'ᶠ', "f"},
     {U'ᵍ', "g"}, {U'ʰ', "h"}, {U'ⁱ', "i"}, {U'ʲ', "j"}, {U'ᵏ', "k"}, {U'ˡ', "l"}, {U'ᵐ', "m"}, {U'ⁿ', "n"}, {U'ᵒ', "o"},
     {U'ᵖ', "p"}, {U'ʳ', "r"}, {U'ˢ', "s"}, {U'ᵗ', "t"}, {U'ᵘ', "u"}, {U'ᵛ', "v"}, {U'ʷ', "w"}, {U'ˣ', "x"}, {U'ʸ', "y"},
     {U'ᶻ', "z"}, {U'ᵀ', "T"}, {U'⁽', "("}, {U'⁾', ")"}, {U'ᴴ', "H"}, {U'ᵅ', "α"}}};
constexpr std::array<Small, 29> lowered_letters{{{U'₀', "0"}, {U'₁', "1"}, {U'₂', "2"}, {U'₃', "3"}, {U'₄', "4"}, {U'₅', "5"},
                                                 {U'₆', "6"}, {U'₇', "7"}, {U'₈', "8"}, {U'₉', "9"}, {U'₋', "−"}, {U'₊', "+"},
                                                 {U'ₐ', "a"}, {U'ₑ', "e"}, {U'ₒ', "o"}, {U'ₓ', "x"}, {U'ₕ', "h"}, {U'ₖ', "k"},
                                                 {U'ₗ', "l"}, {U'ₘ', "m"}, {U'ₙ', "n"}, {U'ₚ', "p"}, {U'ₛ', "s"}, {U'ₜ', "t"},
                                                 {U'ᵢ', "i"}, {U'ⱼ', "j"}, {U'ᵣ', "r"}, {U'ᵤ', "u"}, {U'ᵥ', "v"}}};

template <class Letters>
std::string_view stood_for(const Letters& letters, char32_t c) {
    const auto found = std::ranges::find(letters, c, &Small::first);
    return found == letters.end() ? std::string_view() : found->second;
}

}  // namespace

CodePoint code_point(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(at);
    const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    if (at + length > text.size()) return {first, 1};
    char32_t c = length == 1 ? first : first & (0x7f >> length);
    for (std::size_t k = 1; k < length; ++k) c = c << 6 | (byte(at + k) & 0x3f);
    return {c, length};
}

bool is_letter(char32_t c) {
    const bool latin = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'), greek = c >= 0x370 && c <= 0x3ff;
    return latin || greek || (c >= 0xc0 && c <= 0x24f && c != 0xd7);
}

bool is_digit(char32_t c) { return c >= '0' && c <= '9'; }

bool continues_symbol(char32_t c) {
    const bool small = (c >= 0x2080 && c <= 0x209c) || (c >= 0x1d2c && c <= 0x1d6a) || c == 0x2c7c;
    return is_letter(c) || is_digit(c) || c == '_' || c == '\'' || c == 0x2032 || (c >= 0x300 && c <= 0x36f) || small;
}

int raised_digit(char32_t c) {
    switch (c) {
        case U'¹':
            return 1;
        case U'²':
            return 2;
        case U'³':
            return 3;
        default:
            return c == U'⁰' || (c >= U'⁴' && c <= U'⁹') ? static_cast<int>(c - U'⁰') : -1;
    }
}

int lowered_digit(char32_t c) { return c >= U'₀' && c <= U'₉' ? static_cast<int>(c - U'₀') : -1; }

std::string_view raised(char32_t c) { return stood_for(raised_letters, c); }
std::string_view lowered(char32_t c) { return stood_for(lowered_letters, c); }

}  // namespace pliant
