// Letters of formulas, in UTF-8.
#pragma once
#include <cstddef>
#include <string_view>

namespace pliant {

struct CodePoint {
    char32_t letter = 0;
    std::size_t bytes = 0;  // that it takes in the text
};

// The one that begins at `at`, which lies inside of the text; a byte that begins none stands for itself.
CodePoint code_point(std::string_view text, std::size_t at);

// Latin and Greek.
bool is_letter(char32_t c);
bool is_digit(char32_t c);
// What may continue a symbol: letters, digits, letters below and above the line, primes, hats and tildes.
bool continues_symbol(char32_t c);

// 0 to 9 of "⁰" to "⁹", −1 for all others.
int raised_digit(char32_t c);
// The same of "₀" to "₉".
int lowered_digit(char32_t c);

// What a small letter above or below the line stands for: "T" of "ᵀ", "−" of "⁻", "j" of "ⱼ"; "" for all others.
std::string_view raised(char32_t c);
std::string_view lowered(char32_t c);

}  // namespace pliant
