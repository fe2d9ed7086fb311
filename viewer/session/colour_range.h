// From which number to which the colours of a picture go.
#pragma once
#include "render/palette.h"

#include <vector>

namespace pliant::viewer {

// The colours of the picture: a range that stays, and is widened only when the numbers leave it by much.
struct ColourRange {
    bool automatic = true;
    ColourScale scale;
    // natural: as for scale_for; so are the numbers that were shown before.
    void update(const std::vector<Real>& values, bool both_signs, Real natural = 0);
    void forget() { fresh_ = true, largest_ = 0; }
    // The numbers are those of another quantity from now on.
    void forget_size() { largest_ = 0; }
    void begin_with(const ColourScale& wanted) { scale = wanted, fresh_ = false; }

private:
    bool fresh_ = true;  // the next numbers set the range, whatever it was
    Real largest_ = 0;   // size of what was shown
};

}  // namespace pliant::viewer
