#include "render/colour_map.h"

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

using Triple = std::array<Real, 3>;

std::uint8_t to_byte(Real intensity) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(intensity, 0.0, 1.0))); }
Rgba8 to_colour(const Triple& rgb) { return {to_byte(rgb[0]), to_byte(rgb[1]), to_byte(rgb[2]), 255}; }

// viridis of S. van der Walt and N. Smith (public domain, CC0), by the polynomial of degree 6 that M. Zucker fitted to it
// (public domain, shadertoy.com/view/WlfXRN).
Rgba8 viridis(Real t) {
    constexpr std::array<Triple, 7> c{{{0.2777273272234177, 0.005407344544966578, 0.3340998053353061},
                                       {0.1050930431085774, 1.404613529898575, 1.384590162594685},
                                       {-0.3308618287255563, 0.214847559468213, 0.09509516302823659},
                                       {-4.634230498983486, -5.799100973351585, -19.33244095627987},
                                       {6.228269936347081, 14.17993336680509, 56.69055260068105},
                                       {4.776384997670288, -13.74514537774601, -65.35303263337234},
                                       {-5.435455855934631, 4.645852612178535, 26.3124352495832}}};
    Triple rgb{};
    for (std::size_t k = c.size(); k-- > 0;) {
        for (std::size_t i = 0; i < 3; ++i) rgb[i] = c[k][i] + t * rgb[i];
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
    const Triple lab{msh.m * std::cos(msh.s), msh.m * std::sin(msh.s) * std::cos(msh.h), msh.m * std::sin(msh.s) * std::sin(msh.h)};
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
    const Real spin = end.s * std::sqrt(std::max(0.0, middle_magnitude * middle_magnitude - end.m * end.m)) / (end.m * std::sin(end.s));
    const Real grey_hue = end.m >= middle_magnitude ? end.h : end.h > -1.0471975511965976 ? end.h + spin : end.h - spin;
    const Real from_end = lower_half ? 2 * t : 2 * (1 - t);  // 0 at the end, 1 in the middle
    return to_colour(rgb_from_msh({end.m + from_end * (middle_magnitude - end.m), (1 - from_end) * end.s, end.h + from_end * (grey_hue - end.h)}));
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
