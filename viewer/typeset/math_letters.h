// Slanted and bold letters of a mathematical face, which stand at code points of their own (Unicode 15, "Mathematical
// Alphanumeric Symbols").
#pragma once

namespace pliant::viewer {

enum class LetterShape { upright, slanted, bold };

// The code point of the letter in that shape; the letter itself where there is none.
char32_t shaped(char32_t letter, LetterShape shape);

}  // namespace pliant::viewer
