#include "plot/style.h"

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

// M. Okabe and K. Ito, "Color Universal Design" (2008), without the colours that lack contrast on the background.
constexpr Rgba8 orange{0xE6, 0x9F, 0x00}, sky_blue{0x56, 0xB4, 0xE9}, green{0x00, 0x9E, 0x73}, yellow{0xF0, 0xE4, 0x42},
    blue{0x00, 0x72, 0xB2}, vermillion{0xD5, 0x5E, 0x00}, purple{0xCC, 0x79, 0xA7};
constexpr std::array on_dark{sky_blue, orange, green, yellow, purple, vermillion};
constexpr std::array on_light{blue, vermillion, green, purple, orange, sky_blue};

PlotStyle dark_style() {
    PlotStyle style;
    style.background = {22, 25, 30};
    style.frame = {120, 128, 140};
    style.grid = {50, 55, 64};
    style.minor_grid = {36, 40, 47};
    style.text = {232, 235, 240};
    style.faint_text = {160, 168, 180};
    style.reference = {245, 245, 245};
    style.plate = {22, 25, 30, 215};
    style.palette = on_dark;
    return style;
}

PlotStyle light_style() {
    PlotStyle style;
    style.background = {255, 255, 255};
    style.frame = {90, 96, 105};
    style.grid = {216, 220, 226};
    style.minor_grid = {236, 239, 242};
    style.text = {16, 18, 22};
    style.faint_text = {86, 92, 102};
    style.reference = {0, 0, 0};
    style.plate = {255, 255, 255, 220};
    style.palette = on_light;
    return style;
}

PlotStyle projector_style() {
    PlotStyle style = light_style();
    style.frame = style.text = {0, 0, 0};
    style.faint_text = {60, 60, 60};
    style.grid = {190, 190, 190};
    style.minor_grid = {224, 224, 224};
    style.line_width = 2.75f;
    style.grid_width = style.frame_width = 1.25f;
    style.marker_radius = 4.5f;
    style.least_width = 2;
    return style;
}

Real luminance(Rgba8 colour) {
    const auto linear = [](std::uint8_t byte) {
        const Real v = byte / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
}

}  // namespace

PlotStyle plot_style(PlotTheme theme, float ui_scale) {
    PlotStyle style = theme == PlotTheme::dark ? dark_style() : theme == PlotTheme::light ? light_style() : projector_style();
    style.scale = ui_scale;
    return style;
}

Rgba8 palette_colour(const PlotStyle& style, std::size_t index) { return style.palette[index % style.palette.size()]; }

Marker marker_by_place(std::size_t index) {
    constexpr std::array order{Marker::circle, Marker::square, Marker::triangle, Marker::diamond, Marker::cross, Marker::plus};
    return order[index % order.size()];
}

std::array<float, 2> dash_pattern(Dash dash, float width) {
    if (dash == Dash::dotted) return {width, 2 * width};
    return {std::max(6.0f, 4 * width), std::max(4.0f, 2.5f * width)};
}

Real contrast(Rgba8 a, Rgba8 b) {
    const Real la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace pliant::viewer
