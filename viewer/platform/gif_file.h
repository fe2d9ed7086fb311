// Animated GIFs (GIF89a, CompuServe 1990) of frames of one size, repeated without end.
#pragma once
#include <string>

#include "platform/image.h"

namespace pliant::viewer {

// Takes frames one by one and keeps them compressed, since one palette for all of them is found only when the last is known.
// The same frames give the same bytes.
class GifRecording {
public:
    // frames_per_second: 1 to 50, shown to the nearest hundredth of a second a frame. Throws Refused.
    explicit GifRecording(int frames_per_second);

    // Throws Refused for a frame whose size is not that of the first, or without pixels.
    void add(const Image& frame);
    std::size_t frames() const { return frames_.size(); }
    // The whole file. Throws Refused when there is no frame.
    std::string encoded() const;

private:
    Image frame(std::size_t number) const;

    int delay_;  // hundredths of a second
    int width_ = 0, height_ = 0;
    std::vector<std::vector<unsigned char>> frames_;  // deflated
};

// A picture made smaller to this width in px, each new pixel the mean of those that it covers; as it is when it is no wider.
Image narrowed(const Image& image, int width);

}  // namespace pliant::viewer
