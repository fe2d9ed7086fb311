// Keys of programs as people say them: the one place that knows how.
#pragma once
#include <string>
#include <string_view>

namespace pliant {

// The name in words, small where it is no proper one: "youngs_modulus" is "Young's modulus", "cfl" the "Courant number".
std::string spoken(std::string_view key);

// "is" or "are" behind a name in words: "touching nodes" are, "stress" is.
std::string_view is_or_are(std::string_view name);

// A time that one waits: "0.4 s", "12 s", "3 min", "2.5 h".
std::string duration_words(double seconds);

// "1 pass", "2 passes", "1 step", "3 steps".
std::string counted(long long count, std::string_view one);

}  // namespace pliant
