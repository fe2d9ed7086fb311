// Slanted letters of a mathematical face, which stand at code points of their own (Unicode 15, "Mathematical Alphanumeric
// Symbols").
#pragma once

namespace pliant::viewer {

// The code point of the slanted letter: of Latin and of small Greek ones; capital Greek and all others stand upright.
char32_t slanted(char32_t letter);

}  // namespace pliant::viewer
