#include "session/colour_range.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant::viewer {

void ColourRange::update(const std::vector<Real>& values, bool both_signs, Real natural) {
    if (values.empty() || (!automatic && !fresh_)) return;
    const ColourScale wanted = scale_for(values, both_signs, std::max(natural, largest_));
    largest_ = std::max({largest_, std::abs(wanted.min), std::abs(wanted.max)});
    const Real size = std::max(std::abs(scale.min), std::abs(scale.max)),
               wanted_size = std::max(std::abs(wanted.min), std::abs(wanted.max));
    // Follows when the numbers reach beyond the range or fill less than a third of it, so that colours do not flicker.
    const bool outside = wanted.min < scale.min || wanted.max > scale.max || wanted.map != scale.map;
    const bool lost = wanted_size < size / 3 || (wanted.max - wanted.min) < (scale.max - scale.min) / 3;
    if (std::exchange(fresh_, false) || outside || lost) scale = wanted;
}

}  // namespace pliant::viewer
