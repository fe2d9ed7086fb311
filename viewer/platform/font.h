// The typeface of the viewer: DejaVu Sans, which has the Greek letters and the mathematics that lessons use.
#pragma once
#include <filesystem>

struct ImFont;

namespace pliant::viewer {

// The file of DejaVu Sans: what PLIANT_FONT names, else the usual folders of fonts. Throws MachineLacks, with the package to
// install, when it is nowhere.
std::filesystem::path find_font();

// Adds the typeface to ImGui's atlas at a height in px (of a line of type, not of a letter). Call between frames. Throws
// MachineLacks.
ImFont* add_font(const std::filesystem::path& file, float pixels);

}  // namespace pliant::viewer
