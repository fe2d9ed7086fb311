#include "plot/range.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant::viewer {
namespace {

constexpr Real largest = largest_shown, smallest = smallest_shown;
// What an axis resolves at least, relative to the numbers on it: some thousand roundings.
constexpr Real finest = 1e-12;
// Room about a single value, as a part of it on a linear axis and in decades on a log axis.
constexpr Real room_linear = 0.1, room_decades = 0.5;
// Numbers that differ by less, relative to their size, are one number to whoever looks: an axis begins about as wide as
// `room_alike` of it, so that what agrees is seen to agree. Who zooms in sees more. What a clock or a place runs through, on an
// axis without margin, differs by less where it is looked at closely.
constexpr Real alike = 1e-4, alike_without_margin = 1e-6, room_alike = 1e-3;
// How far a growing range reaches beyond the data, in parts of the span of the data.
constexpr Real reserve = 0.25;
constexpr Real margin_part = 0.04;
constexpr Real rounding = 1e-9;

// Log axes work on exponents.
Real to_linear(Real value, AxisScale scale) { return scale == AxisScale::log ? std::log10(value) : value; }
Range to_linear(Range range, AxisScale scale) { return {to_linear(range.lo, scale), to_linear(range.hi, scale)}; }
Range from_linear(Range range, AxisScale scale) {
    if (scale == AxisScale::linear) return {std::clamp(range.lo, -largest, largest), std::clamp(range.hi, -largest, largest)};
    return {std::pow(10.0, std::clamp(range.lo, -300.0, 300.0)), std::pow(10.0, std::clamp(range.hi, -300.0, 300.0))};
}

// Widens by parts of the span, but not across zero, where data of one sign begin.
Range stretched(Range range, Real below, Real above, AxisScale scale) {
    Range wide{range.lo - below * range.span(), range.hi + above * range.span()};
    if (scale == AxisScale::linear) {
        if (range.lo >= 0) wide.lo = std::max(wide.lo, 0.0);
        if (range.hi <= 0) wide.hi = std::min(wide.hi, 0.0);
    }
    return wide;
}

// Outward to whole decades or, within about one decade, to 1, 2 or 5 times a power of ten.
Range round_exponents(Range exponents) {
    if (exponents.span() > 1) return {std::floor(exponents.lo + rounding), std::ceil(exponents.hi - rounding)};
    constexpr std::array<Real, 4> stops{0, 0.30102999566398120, 0.69897000433601880, 1};
    const Real decade_lo = std::floor(exponents.lo + rounding), decade_hi = std::floor(exponents.hi - rounding);
    Range round{decade_lo, decade_hi + 1};
    for (const Real stop : stops) {
        if (decade_lo + stop <= exponents.lo + rounding) round.lo = decade_lo + stop;
    }
    for (auto stop = stops.rbegin(); stop != stops.rend(); ++stop) {
        if (decade_hi + *stop >= exponents.hi - rounding) round.hi = decade_hi + *stop;
    }
    return round;
}

// Wide enough not to magnify what is alike.
Range apart(Range data, AxisScale scale, Margin margin) {
    const Real near = margin == Margin::some ? alike : alike_without_margin;
    const Real size = std::max(std::abs(data.lo), std::abs(data.hi)), span = data.span();
    if (scale == AxisScale::log || span <= finest * size || span > near * size || size <= smallest) return data;
    const Real middle = data.lo / 2 + data.hi / 2;
    return {middle - room_alike * size, middle + room_alike * size};
}

}  // namespace

std::optional<Range> data_range(std::span<const Real> values, AxisScale scale) {
    const Real lowest = scale == AxisScale::log ? smallest : -largest;
    Range range{largest, -largest};
    bool any = false;
    for (const Real value : values) {
        if (!(value >= lowest && value <= largest)) continue;
        range.lo = std::min(range.lo, value);
        range.hi = std::max(range.hi, value);
        any = true;
    }
    return any ? std::optional(range) : std::nullopt;
}

std::optional<Range> united(const std::optional<Range>& a, const std::optional<Range>& b) {
    if (!a || !b) return a ? a : b;
    return Range{std::min(a->lo, b->lo), std::max(a->hi, b->hi)};
}

Real nice_step(Real span, Real most) {
    const Real least = span / most;
    const Real decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const Real nice : {1.0, 2.0, 5.0}) {
        if (nice * decade >= least * (1 - rounding)) return nice * decade;
    }
    return 10 * decade;
}

Range widened(Range range, AxisScale scale) {
    if (range.lo > range.hi) std::swap(range.lo, range.hi);
    const Range line = to_linear(range, scale);
    const Real size = std::max(std::abs(line.lo), std::abs(line.hi));
    if (scale == AxisScale::log && line.span() <= finest * std::max(size, 1.0))
        return from_linear({line.lo - room_decades, line.hi + room_decades}, scale);
    if (scale == AxisScale::linear && range.span() <= finest * size) {
        const Real room = size > smallest ? room_linear * size : 1;
        return from_linear({line.lo - room, line.hi + room}, scale);
    }
    return range;
}

Range nice_range(Range data, AxisScale scale, Margin margin) {
    // A clock that has not moved yet.
    if (scale == AxisScale::linear && margin == Margin::none && data == Range{0, 0}) return {0, 1};
    const Range range = widened(apart(data, scale, margin), scale);
    const bool has_room = range != data || scale == AxisScale::log;
    const Real part = margin == Margin::some && !has_room ? margin_part : 0;
    const Range line = stretched(to_linear(range, scale), part, part, scale);
    Range round;
    if (scale == AxisScale::log) {
        round = round_exponents(line);
    } else {
        const Real step = nice_step(line.span(), 6);
        round = {std::floor(line.lo / step + rounding) * step, std::ceil(line.hi / step - rounding) * step};
    }
    // Never less than the data, whatever the rounding.
    const Range nice = from_linear(round, scale);
    return {std::min(nice.lo, data.lo), std::max(nice.hi, data.hi)};
}

void AutoRange::follow(Range data, AxisScale scale, Margin margin) {
    const bool usable = shown && (scale == AxisScale::linear || shown->lo > 0);
    if (usable && !provisional && shown->contains(data)) return;
    if (provisional && data.lo == data.hi && shown->contains(data)) return;
    Range line = to_linear(data, scale);
    if (usable && !provisional) {
        line = stretched(line, data.lo < shown->lo ? reserve : 0, data.hi > shown->hi ? reserve : 0, scale);
        shown = nice_range(*united(from_linear(line, scale), *shown), scale, margin);
    } else {
        shown = nice_range(data, scale, margin);
    }
    provisional = widened(data, scale) != data;
}

bool AutoRange::far_too_wide(Range data, AxisScale scale) const {
    if (!shown || provisional || data.lo == data.hi) return false;
    return to_linear(data, scale).span() < 0.25 * to_linear(*shown, scale).span();
}

Real position_on(Range range, AxisScale scale, Real value) {
    const Range line = to_linear(range, scale);
    return (to_linear(value, scale) - line.lo) / line.span();
}

Real value_at(Range range, AxisScale scale, Real position) {
    const Range line = to_linear(range, scale);
    const Real value = line.lo + position * line.span();
    return scale == AxisScale::log ? std::pow(10.0, value) : value;
}

Range zoomed(Range range, AxisScale scale, Real position, Real factor) {
    const Range line = to_linear(range, scale);
    const Real centre = line.lo + position * line.span();
    const Range next{centre - (centre - line.lo) / factor, centre + (line.hi - centre) / factor};
    const Real size = std::max({std::abs(next.lo), std::abs(next.hi), scale == AxisScale::log ? 1.0 : smallest});
    const bool resolved = next.span() > finest * size;
    const bool representable = size < (scale == AxisScale::log ? 300 : largest);
    return resolved && representable ? from_linear(next, scale) : range;
}

Range panned(Range range, AxisScale scale, Real fraction) {
    const Range line = to_linear(range, scale);
    const Range next{line.lo + fraction * line.span(), line.hi + fraction * line.span()};
    const Real size = std::max(std::abs(next.lo), std::abs(next.hi));
    const bool resolved = next.span() > finest * size;
    return resolved && size < (scale == AxisScale::log ? 300 : largest) ? from_linear(next, scale) : range;
}

}  // namespace pliant::viewer
