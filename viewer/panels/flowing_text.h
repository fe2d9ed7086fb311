// Words that flow into lines at blanks alone: ImGui would also break 0.02 behind its point.
#pragma once
#include <string>

struct ImFont;

namespace pliant::viewer {

// The text with line ends, so that no line is wider than `width` px unless a single word is. What belongs together stays so: both
// sides of a sign ("ν = ½", "0.1 m × 0.1 m"), and a number with its unit.
std::string flowing_text(const std::string& text, const ImFont* font, float width);

}  // namespace pliant::viewer
