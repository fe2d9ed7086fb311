// A picture in memory.
#pragma once
#include <pliant/math/types.h>

#include <cstdint>
#include <span>
#include <vector>

#include "platform/context.h"

namespace pliant::viewer {

// Red, green and blue, 8 bits each; rows from the top down, without padding.
struct Image {
    int width = 0, height = 0;  // px
    std::vector<std::uint8_t> rgb;

    std::size_t row_bytes() const { return std::size_t{3} * static_cast<std::size_t>(width); }
    std::span<const std::uint8_t> row(int y) const {
        return {rgb.data() + row_bytes() * static_cast<std::size_t>(y), row_bytes()};
    }
    bool operator==(const Image&) const = default;
};

// The part of a picture that lies in a rectangle given in px from the top left corner; what reaches beyond the picture is left
// out.
Image crop(const Image& image, int left, int top, int width, int height);

struct ImageDifference {
    int largest = 0;         // over all pixels and colours, 0 to 255
    Real fraction_over = 0;  // pixels with a colour that differs by more than the given amount, over all pixels
};

// Throws Refused when the sizes differ.
ImageDifference compare(const Image& a, const Image& b, int amount = 0);

// What framebuffer 0 of the context holds; the context becomes current. Call before Context::present.
Image read_pixels(Context& context);

}  // namespace pliant::viewer
