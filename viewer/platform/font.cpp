#include "platform/font.h"

#include "platform/index_letters.h"

#include <imgui.h>
#include <pliant/math/error.h>

#include <fmt/format.h>

#include <cstdlib>
#include <string>

namespace pliant::viewer {
namespace {

// Pairs of first and last code point, ended by 0. ImGui keeps a pointer to them.
constexpr ImWchar glyph_ranges[] = {
    0x0020, 0x00ff,  // Latin, with ² ³ ½ ° · ×
    0x0168, 0x0169,  // Ũ ũ
    0x0300, 0x0308,  // accents that combine: v̂ ṽ ẍ
    0x0370, 0x03ff,  // Greek
    0x1e86, 0x1e8d,  // ẋ ẍ
    0x1d2c, 0x1d6a,  // raised letters: ᵀ; lowered ones: ᵢ ᵣ
    0x2010, 0x205e,  // dashes, …, ′
    0x2070, 0x209f,  // ⁻¹ ⁿ ₀ ₙ
    0x2100, 0x214f,  // ℓ ℝ
    0x2150, 0x215f,  // ⅓ ⅛
    0x2190, 0x21ff,  // arrows
    0x2200, 0x22ff,  // ∂ ∇ ∑ √ ∫ ≈ ≤ ⋅ ⊗
    0x2308, 0x230b,  // ⌈ ⌋
    0x23e9, 0x23fa,  // ⏸ ⏹
    0x25a0, 0x25ff,  // ■ ▶ ●
    0x2713, 0x2718,  // ✓ ✗
    0x27e8, 0x27e9,  // ⟨ ⟩
    0x2c7c, 0x2c7c,  // ⱼ
    0,
};
// Of indices and exponents.
constexpr ImWchar index_ranges[] = {0x0020, 0x007e, 0x00b0, 0x00b7, 0x0370, 0x03ff, 0x2212, 0x2212, 0};

// Of formulas: upright signs, and slanted letters, Latin and Greek.
constexpr ImWchar math_ranges[] = {
    0x0020, 0x007e, 0x00a8, 0x00a8, 0x00ac, 0x00bf, 0x00d7, 0x00d7, 0x02c6, 0x02c7, 0x02d8,  0x02dd,  0x0370,  0x03ff,  0x2010,
    0x2057, 0x2102, 0x2102, 0x210e, 0x2115, 0x211d, 0x211d, 0x2153, 0x215e, 0x2190, 0x2195,  0x21a6,  0x21a6,  0x2200,  0x222e,
    0x2248, 0x2248, 0x2260, 0x226b, 0x2297, 0x22a5, 0x22c5, 0x22c5, 0x27e8, 0x27e9, 0x1d434, 0x1d467, 0x1d6fc, 0x1d71b, 0,
};

// A file of DejaVu.
std::filesystem::path find_typeface(const char* variable, const char* file_name, const char* typeface, const char* package) {
    if (const char* named = std::getenv(variable)) {
        if (std::filesystem::is_regular_file(named)) return named;
        throw MachineLacks(fmt::format("The typeface '{}', which {} names, is not there.", named, variable));
    }
    for (const char* folder : {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/TTF", "/usr/share/fonts/dejavu",
                               "/usr/share/fonts/dejavu-sans-fonts", "/usr/local/share/fonts", "/opt/homebrew/share/fonts",
                               "/Library/Fonts", "/fonts"}) {
        const auto file = std::filesystem::path(folder) / file_name;
        std::error_code ignored;
        if (std::filesystem::is_regular_file(file, ignored)) return file;
    }
    throw MachineLacks(
        fmt::format("The typeface {} is not on this machine: install {}, or set {} to its file.", typeface, package, variable));
}

ImFont* add_font(const std::filesystem::path& file, float pixels, const ImWchar* ranges) {
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed))
        throw MachineLacks("The typeface '" + file.string() + "' cannot be read.");
    ImFont* font = ImGui::GetIO().Fonts->AddFontFromFileTTF(file.c_str(), pixels, &config, ranges);
    if (!font) throw MachineLacks("The typeface '" + file.string() + "' cannot be read.");
    return font;
}

}  // namespace

std::filesystem::path find_font() { return find_typeface("PLIANT_FONT", "DejaVuSans.ttf", "DejaVu Sans", "fonts-dejavu-core"); }
std::filesystem::path find_math_font() {
    return find_typeface("PLIANT_MATH_FONT", "DejaVuMathTeXGyre.ttf", "DejaVu Math TeX Gyre", "fonts-dejavu-extra");
}

LoadedFonts add_fonts(std::span<const float> heights) {
    const auto file = find_font(), math_file = find_math_font();
    LoadedFonts fonts;
    std::vector<ImFont*> small;
    for (const float height : heights) {
        fonts.words.push_back(add_font(file, height, glyph_ranges));
        small.push_back(add_font(file, index_size * height, index_ranges));
    }
    for (const float height : heights) fonts.mathematics.push_back(add_font(math_file, height, math_ranges));
    ImGui::GetIO().Fonts->Build();
    for (std::size_t i = 0; i < small.size(); ++i) add_index_letters(*fonts.words[i], *small[i]);
    return fonts;
}

}  // namespace pliant::viewer
