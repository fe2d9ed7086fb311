// From which number to which the colours of a picture go.
#pragma once
#include "render/palette.h"

#include <vector>

namespace pliant::viewer {

// The colours of the picture: a range that stays, and is widened only when the numbers leave it by much.
struct ColourRange {
    bool automatic = true;
    ColourScale scale;
    void update(const std::vector<Real>& values, bool both_signs);
    void forget() { fresh_ = true; }
    void begin_with(const ColourScale& wanted) { scale = wanted, fresh_ = false; }

private:
    bool fresh_ = true;  // the next numbers set the range, whatever it was
};

}  // namespace pliant::viewer
