#include "render/palette.h"

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

// Inks after Okabe and Ito, lightened for the dark theme and darkened for the projector.
constexpr Palette dark{{19, 22, 28},
                       {{{104, 155, 205},
                         {25, 30, 40},
                         {150, 158, 170},
                         {88, 98, 112},
                         {205, 150, 190},
                         {240, 130, 50},
                         {86, 200, 235},
                         {245, 215, 60},
                         {232, 236, 242}}}};
constexpr Palette projector{{255, 255, 255},
                            {{{90, 150, 210},
                              {20, 35, 55},
                              {105, 110, 118},
                              {150, 155, 160},
                              {140, 60, 120},
                              {195, 70, 0},
                              {0, 95, 160},
                              {170, 60, 0},
                              {0, 0, 0}}}};

}  // namespace

const Palette& palette(Theme theme) { return theme == Theme::dark ? dark : projector; }

Rgba8 ColourScale::of(float value) const {
    if (!std::isfinite(value)) return undefined_colour;
    return colour_at(map, max > min ? (static_cast<Real>(value) - min) / (max - min) : 0.5);
}

ColourScale scale_for(const std::vector<Real>& values, bool both_signs) {
    if (values.empty()) return {0, 1, both_signs ? ColourMap::diverging : ColourMap::viridis};
    const auto [least, greatest] = std::ranges::minmax(values);
    if (both_signs) {
        const Real size = std::max(std::abs(least), std::abs(greatest));
        return {size > 0 ? -size : 0, size, ColourMap::diverging};
    }
    return {least, greatest, ColourMap::viridis};
}

}  // namespace pliant::viewer
