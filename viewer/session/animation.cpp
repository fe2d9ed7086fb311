#include "session/animation.h"

#include <pliant/math/error.h>

#include <chrono>
#include <cmath>
#include <limits>

namespace pliant::viewer {
namespace {

Real accepted(Real seconds) {
    if (!(seconds >= 1 && seconds <= 30)) throw Refused("seconds of an animation", seconds, "s", "a number from 1 to 30");
    return seconds;
}

}  // namespace

Animation::Animation(Real seconds, int frames_per_second, int width)
    : gif_(frames_per_second),
      wanted_(static_cast<std::size_t>(std::floor(accepted(seconds) * frames_per_second + 1e-9))),
      frame_seconds_(Real{1} / frames_per_second),
      width_(width) {
    gif_.end_at(seconds);
}

void Animation::advance(Session& session) {
    if (gif_.frames() > 0) session.update(frame_seconds_, std::numeric_limits<Real>::infinity());
}

bool Animation::encode_some(Real budget_ms) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    if (!writing_) writing_ = std::make_unique<GifWriting>(gif_);
    while (writing_->next())
        if (std::chrono::duration<Real, std::milli>(Clock::now() - start).count() > budget_ms) return true;
    return false;
}

void Animation::add(const Image& picture) { gif_.add(narrowed(picture, width_)); }

}  // namespace pliant::viewer
