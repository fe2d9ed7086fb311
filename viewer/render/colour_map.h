// Colour maps that are perceptually uniform and can be told apart by the colour-blind.
#pragma once
#include <pliant/math/types.h>

#include <array>
#include <cstdint>

namespace pliant::viewer {

struct Rgba8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    bool operator==(const Rgba8&) const = default;
};

enum class ColourMap {
    viridis,    // from dark blue to yellow, for values of one sign
    diverging,  // from blue over light grey to red, for values about a middle, usually 0
};

// 256 colours from the lowest value to the highest, contiguous: upload as a 256x1 texture of four bytes.
using ColourTable = std::array<Rgba8, 256>;
const ColourTable& colour_table(ColourMap map);

// The colour at t, 0 lowest to 1 highest; t beyond that takes the colour of the end. t must be a number.
Rgba8 colour_at(ColourMap map, Real t);

// For values that are not numbers: a grey that neither map holds.
inline constexpr Rgba8 undefined_colour{128, 128, 128, 255};

}  // namespace pliant::viewer
