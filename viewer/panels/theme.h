// Type, spacing and colours of the lab's own controls.
#pragma once
#include "render/palette.h"
#include "typeset/math_type.h"

struct ImFont;

namespace pliant::viewer {

struct Fonts {
    ImFont* normal = nullptr;
    ImFont* small = nullptr;
    ImFont* medium = nullptr;  // for the words of a slide that are many
    ImFont* large = nullptr;   // for the number that the last row must read
    ImFont* larger = nullptr;  // for the words of a slide that are few
    ImFont* huge = nullptr;    // titles of slides
    MathType mathematics{};    // for formulas
};

// Loads the typefaces at the scale (1 to 3) into ImGui's atlas. Call between frames; the GL texture of the atlas must be made
// again.
Fonts load_fonts(float scale);

// Sets ImGui's style. Larger controls and full contrast for the projector.
void apply_theme(Theme theme, float scale);

// A colour as ImGui packs it.
unsigned packed(Rgba8 colour, float opacity = 1);
unsigned ink(Theme theme, Ink role, float opacity = 1);

// Marks that tell by shape and colour whether something holds.
inline constexpr Rgba8 good_colour{60, 170, 110}, bad_colour{225, 75, 60}, quiet_colour{128, 134, 144};

}  // namespace pliant::viewer
