// Animated GIFs (GIF89a, CompuServe 1990) of frames of one size, repeated without end.
#pragma once
#include <memory>
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
    friend class GifWriting;
    Image frame(std::size_t number) const;

    int delay_;  // hundredths of a second
    int width_ = 0, height_ = 0;
    std::vector<std::vector<unsigned char>> frames_;  // deflated
};

// The same file made frame by frame, so that a window stays awake meanwhile.
class GifWriting {
public:
    // The recording outlives this. Throws Refused when it has no frame.
    explicit GifWriting(const GifRecording& recording);
    ~GifWriting();
    GifWriting(const GifWriting&) = delete;
    GifWriting& operator=(const GifWriting&) = delete;

    // Encodes the next frame; false when there was none left.
    bool next();
    std::size_t frames() const { return done_; }
    // The whole file, once no frame is left.
    std::string finished();

private:
    struct Parts;
    const GifRecording& recording_;
    std::unique_ptr<Parts> parts_;
    std::size_t done_ = 0;
};

// A picture made smaller to this width in px, each new pixel the mean of those that it covers; as it is when it is no wider.
Image narrowed(const Image& image, int width);

}  // namespace pliant::viewer
