// The nearest known word to a mistyped one.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace pliant {

// The known word with the smallest edit distance (Levenshtein), or "" when none is near (more than a third of its length off).
std::string nearest(std::string_view word, std::span<const std::string> known);

// " (did you mean 'mass_spring'?)" or "".
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace pliant
