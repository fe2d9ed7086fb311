#include "platform/font.h"

#include "platform/index_letters.h"

#include <imgui.h>
#include <pliant/math/error.h>

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

}  // namespace

std::filesystem::path find_font() {
    if (const char* named = std::getenv("PLIANT_FONT")) {
        if (std::filesystem::is_regular_file(named)) return named;
        throw MachineLacks(std::string("The typeface '") + named + "', which PLIANT_FONT names, is not there.");
    }
    for (const char* folder : {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/TTF", "/usr/share/fonts/dejavu",
                               "/usr/share/fonts/dejavu-sans-fonts", "/usr/local/share/fonts", "/opt/homebrew/share/fonts",
                               "/Library/Fonts", "/fonts"}) {
        const auto file = std::filesystem::path(folder) / "DejaVuSans.ttf";
        std::error_code ignored;
        if (std::filesystem::is_regular_file(file, ignored)) return file;
    }
    throw MachineLacks(
        "The typeface DejaVu Sans is not on this machine: install fonts-dejavu-core, or set PLIANT_FONT to its file.");
}

namespace {

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

std::vector<ImFont*> add_fonts(const std::filesystem::path& file, std::span<const float> heights) {
    std::vector<ImFont*> fonts, small;
    for (const float height : heights) {
        fonts.push_back(add_font(file, height, glyph_ranges));
        small.push_back(add_font(file, index_size * height, index_ranges));
    }
    ImGui::GetIO().Fonts->Build();
    for (std::size_t i = 0; i < fonts.size(); ++i) add_index_letters(*fonts[i], *small[i]);
    return fonts;
}

}  // namespace pliant::viewer
