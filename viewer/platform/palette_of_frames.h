// The colours of an animation reduced to one palette.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "platform/image.h"

namespace pliant::viewer {

class FramePalette {
public:
    static constexpr int size = 255;  // one more index says "as in the frame before"

    // From frames that show what occurs: median cut (giflib), then each colour moved to the mean of the pixels that it stands
    // for, so that flat areas keep their colour.
    explicit FramePalette(const std::vector<Image>& samples);

    const std::array<std::uint8_t, 3>& colour(int index) const { return colours_[static_cast<std::size_t>(index)]; }
    // The index for each pixel. Where colours lie between two of the palette, they are mixed by an ordered pattern.
    std::vector<std::uint8_t> indices(const Image& image) const;

private:
    int nearest(int red, int green, int blue) const;
    void make_table();
    std::uint8_t looked_up(const std::uint8_t* rgb, int shift) const;

    std::array<std::array<std::uint8_t, 3>, size> colours_{};
    std::vector<std::uint8_t> table_;  // by 6 bits of red, green and blue
};

}  // namespace pliant::viewer
