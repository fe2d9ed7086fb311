// The typefaces of the viewer: DejaVu Sans, which has the Greek letters and the signs that lessons use, and DejaVu Math for
// formulas.
#pragma once
#include <filesystem>
#include <span>
#include <vector>

struct ImFont;

namespace pliant::viewer {

// The files of DejaVu Sans and of DejaVu Math TeX Gyre: what PLIANT_FONT and PLIANT_MATH_FONT name, else the usual folders of
// fonts. Throw MachineLacks, with the package to install, when it is nowhere.
std::filesystem::path find_font();
std::filesystem::path find_math_font();

struct LoadedFonts {
    std::vector<ImFont*> words{}, mathematics{};  // in the order of the heights
};

// Adds both typefaces to ImGui's atlas at heights in px (of a line of type, not of a letter), that of words with letters for
// indices and exponents, and builds the atlas. Call between frames. Throws MachineLacks.
LoadedFonts add_fonts(std::span<const float> heights);

}  // namespace pliant::viewer
