// The colours of a theme, by the role that a mark plays.
#pragma once
#include <pliant/lesson/scene.h>

#include "render/colour_map.h"

#include <array>
#include <utility>
#include <vector>

namespace pliant::viewer {

enum class Theme { dark, projector };

struct Palette {
    Rgba8 background;
    std::array<Rgba8, 9> inks;  // in the order of Ink
    Rgba8 of(Ink ink) const { return inks[static_cast<std::size_t>(ink)]; }
};

const Palette& palette(Theme theme);

// How numbers become colours in a picture.
struct ColourScale {
    Real min = 0, max = 1;
    ColourMap map = ColourMap::viridis;
    Rgba8 of(float value) const;
    // The range with some extent, so that a scale of one number alone has it in its middle.
    std::pair<Real, Real> wide() const;
    bool operator==(const ColourScale&) const = default;
};

// A scale for these numbers. What may have both signs has diverging colours about zero, also while it has one alone; anything
// else goes from the least to the greatest. natural: a size that these numbers could have; what is rounding beside it is 0, and
// what differs by rounding alone is one number.
ColourScale scale_for(const std::vector<Real>& values, bool both_signs, Real natural = 0);

}  // namespace pliant::viewer
