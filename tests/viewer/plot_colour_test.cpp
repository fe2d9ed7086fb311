// Colour maps and the colours of series.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include "plot/style.h"
#include "render/colour_map.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <vector>

using namespace pliant;
using namespace pliant::viewer;

namespace {

// CIE lightness L*, 0 to 100, of an sRGB colour.
Real lightness(Rgba8 colour) {
    const auto linear = [](int byte) {
        const Real v = byte / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    const Real y = 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

bool close(Rgba8 a, Rgba8 b, int amount) {
    return std::abs(a.r - b.r) <= amount && std::abs(a.g - b.g) <= amount && std::abs(a.b - b.b) <= amount;
}

}  // namespace

TEST_CASE("viridis passes through its published colours") {
    // Colours of the map as S. van der Walt and N. Smith published it, at the ends and at eighths of the way.
    CHECK(close(colour_at(ColourMap::viridis, 0), {68, 1, 84}, 0));
    CHECK(close(colour_at(ColourMap::viridis, 0.125), {71, 44, 122}, 2));
    CHECK(close(colour_at(ColourMap::viridis, 0.25), {59, 82, 139}, 2));
    CHECK(close(colour_at(ColourMap::viridis, 0.375), {44, 114, 142}, 2));
    CHECK(close(colour_at(ColourMap::viridis, 0.5), {33, 145, 140}, 2));
    CHECK(close(colour_at(ColourMap::viridis, 0.625), {40, 174, 128}, 2));
    CHECK(close(colour_at(ColourMap::viridis, 0.75), {94, 201, 98}, 2));
    CHECK(close(colour_at(ColourMap::viridis, 0.875), {173, 220, 48}, 2));
    CHECK(close(colour_at(ColourMap::viridis, 1), {253, 231, 37}, 0));
}

TEST_CASE("viridis grows lighter in even steps") {
    const ColourTable& table = colour_table(ColourMap::viridis);
    const Real mean = (lightness(table[255]) - lightness(table[0])) / 15;
    for (std::size_t i = 0; i + 17 < table.size(); i += 17) {
        const Real step = lightness(table[i + 17]) - lightness(table[i]);
        CHECK(step > 0.6 * mean);
        CHECK(step < 1.4 * mean);
    }
}

TEST_CASE("The diverging map has Moreland's ends and grey middle, and both halves are equally light") {
    CHECK(close(colour_at(ColourMap::diverging, 0), {59, 76, 192}, 1));
    CHECK(close(colour_at(ColourMap::diverging, 0.5), {221, 221, 221}, 2));
    CHECK(close(colour_at(ColourMap::diverging, 1), {180, 4, 38}, 1));
    // The quarter points of the published map.
    CHECK(close(colour_at(ColourMap::diverging, 0.25), {141, 176, 254}, 3));
    CHECK(close(colour_at(ColourMap::diverging, 0.75), {244, 154, 123}, 3));
    for (const Real d : {0.1, 0.2, 0.3, 0.4}) {
        CHECK(lightness(colour_at(ColourMap::diverging, 0.5 - d)) ==
              Catch::Approx(lightness(colour_at(ColourMap::diverging, 0.5 + d))).margin(4));
        CHECK(lightness(colour_at(ColourMap::diverging, 0.5 - d)) < lightness(colour_at(ColourMap::diverging, 0.6 - d)));
    }
}

TEST_CASE("Values beyond a map take the colour of its end") {
    for (const ColourMap map : {ColourMap::viridis, ColourMap::diverging}) {
        CHECK(colour_at(map, -3) == colour_at(map, 0));
        CHECK(colour_at(map, 7) == colour_at(map, 1));
        for (const Rgba8 colour : colour_table(map)) REQUIRE_FALSE(close(colour, undefined_colour, 8));
    }
}

TEST_CASE("Words and curves stand out from the background of every theme") {
    for (const PlotTheme theme : {PlotTheme::dark, PlotTheme::light, PlotTheme::projector}) {
        const PlotStyle style = plot_style(theme, 1);
        // What WCAG 2.1 asks of words, at its higher and its lower level, and of graphics.
        CHECK(contrast(style.text, style.background) >= 7);
        CHECK(contrast(style.faint_text, style.background) >= 4.5);
        CHECK(contrast(style.reference, style.background) >= 7);
        for (std::size_t i = 0; i < 3; ++i) CHECK(contrast(palette_colour(style, i), style.background) >= 3);
    }
}

TEST_CASE("Six curves differ in colour and in mark") {
    for (const PlotTheme theme : {PlotTheme::dark, PlotTheme::projector}) {
        const PlotStyle style = plot_style(theme, 1);
        std::set<Marker> marks;
        std::vector<Rgba8> colours;
        for (std::size_t i = 0; i < 6; ++i) {
            marks.insert(marker_by_place(i));
            CHECK(std::ranges::find(colours, palette_colour(style, i)) == colours.end());
            colours.push_back(palette_colour(style, i));
        }
        CHECK(marks.size() == 6);
        CHECK_FALSE(marks.contains(Marker::none));
    }
}

TEST_CASE("Lines grow with the scale and are never thinner than 2 px for the projector") {
    const PlotStyle projector = plot_style(PlotTheme::projector, 1), large = plot_style(PlotTheme::dark, 2.5f);
    for (const float length : {0.1f, projector.grid_width, projector.frame_width, projector.line_width})
        CHECK(projector.width(length) >= 2);
    CHECK(large.width(large.line_width) == Catch::Approx(2.5f * plot_style(PlotTheme::dark, 1).line_width));
    for (const Dash kind : {Dash::dashed, Dash::dotted}) {
        for (const float part : dash_pattern(kind, 2)) CHECK(part >= 2);
    }
}
