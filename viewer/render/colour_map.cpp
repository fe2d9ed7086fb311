#include "render/colour_map.h"

#include "render/assets.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace pliant::viewer {
namespace {

// Takes "r,g,b" and the end of its line off the front of the text.
Rgba8 next_colour(std::string_view& text) {
    Rgba8 colour;
    for (std::uint8_t* part : {&colour.r, &colour.g, &colour.b}) {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), *part);
        if (error != std::errc{}) throw std::logic_error("a colour map has a row that is not three whole numbers up to 255");
        text.remove_prefix(std::min(text.size(), static_cast<std::size_t>(end - text.data()) + 1));
    }
    return colour;
}

// A table of assets/colour_maps: a line of names, then a line for each colour.
ColourTable read_table(std::string_view name) {
    std::string_view text = asset("colour_maps/" + std::string(name) + ".csv");
    text.remove_prefix(std::min(text.size(), text.find('\n') + 1));
    ColourTable table;
    for (Rgba8& colour : table) colour = next_colour(text);
    return table;
}

}  // namespace

const ColourTable& colour_table(ColourMap map) {
    static const ColourTable viridis = read_table("viridis"), diverging = read_table("diverging");
    return map == ColourMap::viridis ? viridis : diverging;
}

Rgba8 colour_at(ColourMap map, Real t) {
    return colour_table(map)[static_cast<std::size_t>(std::lround(255 * std::clamp(t, 0.0, 1.0)))];
}

}  // namespace pliant::viewer
