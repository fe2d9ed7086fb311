// Words that flow into lines, of letters in a window or of columns in a terminal.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// Lines no wider than `width`, unless a single word is, both in the unit of `width_of`; at least one. What belongs together stays
// so: both sides of a sign ("ν = ½", "0.1 m × 0.1 m"), and a number with its unit.
std::vector<std::string> flowing_lines(std::string_view text, double width,
                                       const std::function<double(const std::string&)>& width_of);

// Columns that a text takes in a terminal: characters, without the accents that combine (U+0300 to U+033F).
double columns_of(const std::string& text);

}  // namespace pliant
