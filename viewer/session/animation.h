// A run recorded as an animation: each frame is so much simulated time later, however long the machine takes.
#pragma once
#include <memory>
#include <string>

#include "platform/gif_file.h"
#include "session/session.h"

namespace pliant::viewer {

class Animation {
public:
    // seconds of the file, 1 to 30, whose last frame stays until they are over; frames per second, 1 to 50; the widest that a
    // frame may be in px. Throws Refused.
    Animation(Real seconds, int frames_per_second, int width);

    // Moves a playing run on to the next frame, in whole steps at the session's speed; the first frame shows it as it is.
    void advance(Session& session);
    // Throws Refused when the size differs from that of the first.
    void add(const Image& picture);
    bool complete() const { return gif_.frames() >= wanted_; }
    Real progress() const { return static_cast<Real>(gif_.frames()) / static_cast<Real>(wanted_); }
    // The whole file, made in one go or, for a window, in parts of some milliseconds: false once it is whole.
    std::string encoded() const { return gif_.encoded(); }
    bool encode_some(Real budget_ms = 15);
    Real encoded_share() const { return writing_ ? static_cast<Real>(writing_->frames()) / static_cast<Real>(wanted_) : 0; }
    std::string take_encoded() { return writing_->finished(); }

private:
    GifRecording gif_;
    std::unique_ptr<GifWriting> writing_;
    std::size_t wanted_;  // frames
    Real frame_seconds_;
    int width_;
};

}  // namespace pliant::viewer
