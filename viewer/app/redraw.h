// When the window draws: while something changes and a little longer, until all has settled; else not at all. It knows no clock
// of its own: the caller tells the time.
#pragma once
#include <pliant/math/types.h>

#include <limits>

namespace pliant::viewer {

class Redraw {
public:
    static constexpr Real frame_seconds = Real{1} / 60;
    // What follows an input without another one: tips that come late, popups that fade in, windows that learn their sizes.
    static constexpr Real settle_seconds = 0.5;
    static constexpr int settle_frames = 4;
    static constexpr Real longest_wait = 1;  // s
    static constexpr Real never = std::numeric_limits<Real>::infinity();

    // Mouse, keys, a new size: all that comes from outside.
    void input(Real now);
    // A frame was begun then; without an input the picture changes `change_in` seconds later, or never.
    void drawn(Real now, Real change_in);

    bool due(Real now) const { return now >= next(now); }
    // How long to wait for inputs, s: 0 when a frame is due.
    Real wait(Real now) const;
    // Nothing changes until the next input, or only now and then: the cursor in a text, a share of work that is done.
    bool resting(Real now) const { return !settling(now) && change_in_ > frame_seconds; }

private:
    bool settling(Real now) const { return frames_to_settle_ > 0 || now < settled_at_; }
    Real next(Real now) const;

    Real last_ = -frame_seconds, change_in_ = 0;
    Real settled_at_ = 0;
    int frames_to_settle_ = settle_frames;
};

}  // namespace pliant::viewer
