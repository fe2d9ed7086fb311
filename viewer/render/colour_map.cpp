#include "render/colour_map.h"

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

using Triple = std::array<Real, 3>;

std::uint8_t to_byte(Real intensity) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(intensity, 0.0, 1.0))); }
Rgba8 to_colour(const Triple& rgb) { return {to_byte(rgb[0]), to_byte(rgb[1]), to_byte(rgb[2]), 255}; }

// viridis of S. van der Walt and N. Smith (2015, public domain by CC0): ten of its colours, evenly spaced, with a cubic spline of
// Catmull and Rom (1974) through them.
Rgba8 viridis(Real t) {
    constexpr std::array<Triple, 10> table{{{68, 1, 84},
                                            {72, 40, 120},
                                            {62, 74, 137},
                                            {49, 104, 142},
                                            {38, 130, 142},
                                            {31, 158, 137},
                                            {53, 183, 121},
                                            {109, 205, 89},
                                            {180, 222, 44},
                                            {253, 231, 37}}};
    constexpr std::size_t last = table.size() - 1;
    const Real place = t * static_cast<Real>(last);
    const std::size_t i = std::min(static_cast<std::size_t>(place), last - 1);
    const Real f = place - static_cast<Real>(i);
    Triple rgb{};
    for (std::size_t c = 0; c < 3; ++c) {
        // Beyond the ends the table goes on straight.
        const Real p1 = table[i][c], p2 = table[i + 1][c];
        const Real p0 = i > 0 ? table[i - 1][c] : 2 * p1 - p2, p3 = i + 2 <= last ? table[i + 2][c] : 2 * p2 - p1;
        const Real spline = p1 + 0.5 * f * (p2 - p0 + f * (2 * p0 - 5 * p1 + 4 * p2 - p3 + f * (3 * (p1 - p2) + p3 - p0)));
        rgb[c] = spline / 255;
    }
    return to_colour(rgb);
}

// The diverging map of K. Moreland, "Diverging Color Maps for Scientific Visualization", ISVC 2009: straight lines in the polar
// form (magnitude M, saturation s, hue h) of CIELAB, from the two ends to a light grey, with the hue spun so that both halves
// look equally bright (section 5 and figure 6 of the paper). sRGB with its white point D65.
struct Msh {
    Real m, s, h;
};
constexpr Triple white{0.95047, 1, 1.08883};

Real linear_from_srgb(Real v) { return v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92; }
Real srgb_from_linear(Real v) { return v > 0.0031308 ? 1.055 * std::pow(v, 1 / 2.4) - 0.055 : 12.92 * v; }
Real lab_curve(Real v) { return v > 0.008856 ? std::cbrt(v) : 7.787 * v + 16.0 / 116; }
Real lab_curve_inverse(Real v) { return v > 0.206893 ? v * v * v : (v - 16.0 / 116) / 7.787; }

Msh msh_from_rgb(const Triple& rgb) {
    const Real r = linear_from_srgb(rgb[0]), g = linear_from_srgb(rgb[1]), b = linear_from_srgb(rgb[2]);
    const Real x = lab_curve((0.4124 * r + 0.3576 * g + 0.1805 * b) / white[0]);
    const Real y = lab_curve((0.2126 * r + 0.7152 * g + 0.0722 * b) / white[1]);
    const Real z = lab_curve((0.0193 * r + 0.1192 * g + 0.9505 * b) / white[2]);
    const Triple lab{116 * y - 16, 500 * (x - y), 200 * (y - z)};
    const Real m = std::sqrt(lab[0] * lab[0] + lab[1] * lab[1] + lab[2] * lab[2]);
    return {m, std::acos(lab[0] / m), std::atan2(lab[2], lab[1])};
}

Triple rgb_from_msh(const Msh& msh) {
    const Triple lab{msh.m * std::cos(msh.s), msh.m * std::sin(msh.s) * std::cos(msh.h),
                     msh.m * std::sin(msh.s) * std::sin(msh.h)};
    const Real y_curve = (lab[0] + 16) / 116;
    const Real x = white[0] * lab_curve_inverse(y_curve + lab[1] / 500);
    const Real y = white[1] * lab_curve_inverse(y_curve);
    const Real z = white[2] * lab_curve_inverse(y_curve - lab[2] / 200);
    return {srgb_from_linear(3.2406 * x - 1.5372 * y - 0.4986 * z), srgb_from_linear(-0.9689 * x + 1.8758 * y + 0.0415 * z),
            srgb_from_linear(0.0557 * x - 0.2040 * y + 1.0570 * z)};
}

Rgba8 diverging(Real t) {
    constexpr Real middle_magnitude = 88;
    const Triple low{59.0 / 255, 76.0 / 255, 192.0 / 255}, high{180.0 / 255, 4.0 / 255, 38.0 / 255};
    const bool lower_half = t < 0.5;
    const Msh end = msh_from_rgb(lower_half ? low : high);
    // Hue of the grey end: the paper's AdjustHue, which turns away from purple on both sides.
    const Real spin =
        end.s * std::sqrt(std::max(0.0, middle_magnitude * middle_magnitude - end.m * end.m)) / (end.m * std::sin(end.s));
    const Real grey_hue = end.m >= middle_magnitude ? end.h : end.h > -1.0471975511965976 ? end.h + spin : end.h - spin;
    const Real from_end = lower_half ? 2 * t : 2 * (1 - t);  // 0 at the end, 1 in the middle
    return to_colour(rgb_from_msh(
        {end.m + from_end * (middle_magnitude - end.m), (1 - from_end) * end.s, end.h + from_end * (grey_hue - end.h)}));
}

ColourTable make_table(Rgba8 (*map)(Real)) {
    ColourTable table;
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = map(static_cast<Real>(i) / 255);
    return table;
}

}  // namespace

const ColourTable& colour_table(ColourMap map) {
    static const ColourTable of_viridis = make_table(viridis), of_diverging = make_table(diverging);
    return map == ColourMap::viridis ? of_viridis : of_diverging;
}

Rgba8 colour_at(ColourMap map, Real t) {
    return colour_table(map)[static_cast<std::size_t>(std::lround(255 * std::clamp(t, 0.0, 1.0)))];
}

}  // namespace pliant::viewer
