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

std::pair<Real, Real> ColourScale::wide() const {
    if (max > min) return {min, max};
    const Real beyond = std::max(std::abs(min), Real{1});
    return {min - beyond, min + beyond};
}

Rgba8 ColourScale::of(float value) const {
    if (!std::isfinite(value)) return undefined_colour;
    const auto [least, greatest] = wide();
    return colour_at(map, max > min ? (static_cast<Real>(value) - least) / (greatest - least) : 0.5);
}

ColourScale scale_for(const std::vector<Real>& values, bool both_signs, Real natural) {
    constexpr Real rounding = 1e-13;  // as a part of the largest number
    constexpr Real nothing = 1e-100;  // no quantity is as small
    const ColourMap map = both_signs ? ColourMap::diverging : ColourMap::viridis;
    if (values.empty()) return {0, 1, map};
    const auto [least, greatest] = std::ranges::minmax(values);
    const Real size = std::max(std::abs(least), std::abs(greatest));
    if (size <= std::max(nothing, rounding * natural)) return {0, 0, map};
    if (both_signs) return {-size, size, map};
    return {least, greatest - least > rounding * size ? greatest : least, map};
}

}  // namespace pliant::viewer
