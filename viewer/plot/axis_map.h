// From values to pixels and back, along one axis.
#pragma once
#include <algorithm>
#include <cmath>

#include "plot/range.h"

namespace pliant::viewer {

class AxisMap {
public:
    // The low end of the range lies at pixel `low`, the high end at pixel `high`; for an axis that points up, low > high. The
    // range must not be empty and, on a log axis, positive.
    AxisMap(Range range, AxisScale scale, Real low, Real high)
        : range_(range),
          scale_(scale),
          low_(low),
          high_(high),
          start_(exponent(range.lo)),
          per_unit_((high - low) / (exponent(range.hi) - start_)) {}

    // The pixel of a plottable value. Values far outside are drawn in as to a billion pixels, so that differences stay exact.
    Real pixel(Real value) const { return std::clamp(low_ + (exponent(value) - start_) * per_unit_, -far, far); }
    Real value(Real pixel) const { return value_at(range_, scale_, (pixel - low_) / (high_ - low_)); }
    bool plots(Real value) const { return plottable(value, scale_); }

    Range range() const { return range_; }
    AxisScale scale() const { return scale_; }
    Real low() const { return low_; }
    Real high() const { return high_; }

private:
    static constexpr Real far = 1e9;
    Real exponent(Real value) const { return scale_ == AxisScale::log ? std::log10(value) : value; }

    Range range_;
    AxisScale scale_;
    Real low_, high_, start_, per_unit_;
};

}  // namespace pliant::viewer
