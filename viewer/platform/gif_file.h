// Animated GIFs (GIF89a, CompuServe 1990) of frames of one size, repeated without end.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "platform/image.h"

namespace pliant::viewer {

// Takes frames one by one and keeps them compressed, since one palette for all of them is found only when the last is known.
// The same frames give the same bytes.
class GifRecording {
public:
    // frames_per_second: 1 to 50. A GIF counts hundredths of a second: each frame begins at the one that is nearest to its time,
    // so that the whole lasts as long as it should. Throws Refused.
    explicit GifRecording(int frames_per_second);
    // The last frame stays until this time, in s from the start of the first; without it as long as any other.
    void end_at(Real seconds) { end_ = seconds; }

    // Throws Refused for a frame whose size is not that of the first, or without pixels.
    void add(const Image& frame);
    std::size_t frames() const { return frames_.size(); }
    // How long a frame is shown, in hundredths of a second; frames are counted from 0.
    int delay(std::size_t frame) const;
    // The whole file. Throws Refused when there is no frame.
    std::string encoded() const;

private:
    friend class GifWriting;
    Image frame(std::size_t number) const;

    int frames_per_second_;
    std::optional<Real> end_;
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
