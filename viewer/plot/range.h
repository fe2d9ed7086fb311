// The intervals that axes show: how they follow data without jitter, and how they zoom and pan.
#pragma once
#include <pliant/math/types.h>

#include <optional>
#include <span>

namespace pliant::viewer {

enum class AxisScale { linear, log };

struct Range {
    Real lo = 0, hi = 1;

    Real span() const { return hi - lo; }
    bool contains(Real value) const { return value >= lo && value <= hi; }
    bool contains(Range other) const { return other.lo >= lo && other.hi <= hi; }
    bool operator==(const Range&) const = default;
};

// Can an axis show the value: is it finite and of a size up to 1e300 and, on a log axis, at least 1e-300?
inline constexpr Real largest_shown = 1e300, smallest_shown = 1e-300;
inline bool plottable(Real value, AxisScale scale) {
    return value >= (scale == AxisScale::log ? smallest_shown : -largest_shown) && value <= largest_shown;
}

// Least and greatest plottable value; empty when there is none.
std::optional<Range> data_range(std::span<const Real> values, AxisScale scale);
std::optional<Range> united(const std::optional<Range>& a, const std::optional<Range>& b);

// The smallest of 1, 2 or 5 times a power of ten that divides `span` > 0 into at most `most` > 0 steps.
Real nice_step(Real span, Real most);

// The interval itself where an axis can show it; else one about it: a single value gets room on both sides, and numbers that
// differ only in their last bits are spread apart.
Range widened(Range range, AxisScale scale);

// Room between the data and the ends of the axis; a log axis, which ends on powers of ten, has it anyway.
enum class Margin { none, some };

// An interval that holds the data and ends on round numbers.
Range nice_range(Range data, AxisScale scale, Margin margin);

// The interval that an axis in automatic mode shows. It grows, in large nice steps, only when the data leave it.
struct AutoRange {
    std::optional<Range> shown;
    bool provisional = false;  // made from a single value, whose room says nothing about the data to come

    void follow(Range data, AxisScale scale, Margin margin);
    // The data fill less than a quarter of what is shown, as after a reset of the lesson.
    bool far_too_wide(Range data, AxisScale scale) const;
    void forget() { *this = {}; }
};

// Positions along an axis are 0 at its low and 1 at its high end.
Real position_on(Range range, AxisScale scale, Real value);
Real value_at(Range range, AxisScale scale, Real position);

// Shows 1 / factor times as much, with the value at `position` staying where it is. Never further than numbers can resolve.
Range zoomed(Range range, AxisScale scale, Real position, Real factor);
// Moves what is shown by a fraction of the axis, towards higher values when positive.
Range panned(Range range, AxisScale scale, Real fraction);

}  // namespace pliant::viewer
