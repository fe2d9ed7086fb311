#include "app/redraw.h"

#include <algorithm>

namespace pliant::viewer {

void Redraw::input(Real now) {
    settled_at_ = now + settle_seconds;
    frames_to_settle_ = settle_frames;
}

void Redraw::drawn(Real now, Real change_in) {
    last_ = now;
    change_in_ = change_in;
    frames_to_settle_ = std::max(0, frames_to_settle_ - 1);
}

Real Redraw::next(Real now) const { return last_ + (settling(now) ? frame_seconds : std::max(change_in_, frame_seconds)); }

Real Redraw::wait(Real now) const { return std::clamp(next(now) - now, Real{0}, longest_wait); }

}  // namespace pliant::viewer
