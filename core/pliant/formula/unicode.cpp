#include <pliant/formula/unicode.h>

namespace pliant {

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

}  // namespace pliant
