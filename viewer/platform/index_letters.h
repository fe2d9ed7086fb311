// Indices and exponents as lecturers write them: x_d and (1 + ε)^(−ν) with small letters below and above the line. Unicode has
// some of them; the fonts of the viewer have all, under code points for private use.
#pragma once
#include <string>
#include <string_view>

struct ImFont;

namespace pliant::viewer {

// How large they are beside the other letters.
inline constexpr float index_size = 0.72f;

// The text with lowered letters in the place of an index behind a symbol of one letter (x_d, ε_max, q′_old, but not newton_cap)
// and of Unicode's own (xᵢ, ν₀), and raised ones in the place of an exponent in brackets. For the eye alone: a file gets the text
// as it was.
std::string with_index_letters(std::string_view text);

// Gives a font its lowered and raised letters: those of another one, index_size as high, in the same atlas. The atlas has been
// built.
void add_index_letters(ImFont& font, const ImFont& small);

}  // namespace pliant::viewer
