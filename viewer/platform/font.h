// The typeface of the viewer: DejaVu Sans, which has the Greek letters and the mathematics that lessons use.
#pragma once
#include <filesystem>
#include <span>
#include <vector>

struct ImFont;

namespace pliant::viewer {

// The file of DejaVu Sans: what PLIANT_FONT names, else the usual folders of fonts. Throws MachineLacks, with the package to
// install, when it is nowhere.
std::filesystem::path find_font();

// Adds the typeface to ImGui's atlas at heights in px (of a line of type, not of a letter), each with letters for indices and
// exponents, and builds the atlas. Call between frames. Throws MachineLacks.
std::vector<ImFont*> add_fonts(const std::filesystem::path& file, std::span<const float> heights);

}  // namespace pliant::viewer
