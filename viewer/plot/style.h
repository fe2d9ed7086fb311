// How plots look: colours of a theme, and lines and marks that can be told apart without colour.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "render/colour_map.h"

namespace pliant::viewer {

class MathType;

enum class Dash { solid, dashed, dotted };
enum class Marker { none, circle, square, triangle, diamond, cross, plus };

enum class PlotTheme {
    dark,
    light,
    projector,  // light, of the highest contrast, no line thinner than 2 px
};

// Lengths in px at UI scale 1; `scale` multiplies them.
struct PlotStyle {
    float scale = 1;
    float line_width = 1.75f, grid_width = 1, frame_width = 1, marker_radius = 3.5f;
    float least_width = 1;  // px, whatever the scale

    Rgba8 background, frame, grid, minor_grid, text, faint_text;
    Rgba8 reference;  // exact and published curves
    Rgba8 plate;      // behind words that lie over the picture
    std::span<const Rgba8> palette;
    const MathType* mathematics = nullptr;  // for names with symbols in them; without it they are words

    float px(float length) const { return length * scale; }
    float width(float length) const { return px(length) > least_width ? px(length) : least_width; }
};

PlotStyle plot_style(PlotTheme theme, float ui_scale);

// What is left out is chosen by the place of the series in its plot.
struct SeriesStyle {
    std::optional<std::size_t> colour{};  // index in the palette, taken modulo its size
    Dash dash = Dash::solid;
    std::optional<Marker> marker{};
    std::optional<float> width{};  // px at UI scale 1
};

Rgba8 palette_colour(const PlotStyle& style, std::size_t index);
Marker marker_by_place(std::size_t index);  // never none

// Strokes and gaps, in px, of a line `width` px wide that is not solid.
std::array<float, 2> dash_pattern(Dash dash, float width);

// Of the brighter colour to the darker one: 1 to 21 (WCAG 2.1, contrast ratio). Opacity does not count.
Real contrast(Rgba8 a, Rgba8 b);

}  // namespace pliant::viewer
