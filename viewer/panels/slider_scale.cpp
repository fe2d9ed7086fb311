#include "panels/slider_scale.h"

#include <pliant/text/number_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant::viewer {
namespace {

constexpr Real zero_part = 0.04;         // of a logarithmic slider
constexpr Real far_beyond = 50;          // times what is useful: such a span is not shown evenly
constexpr Real useful_part_linear = 4;   // asinh: linear up to the useful width over this
constexpr Real steps_along = 50;         // sensible ones from end to end
constexpr Real smallest_extreme = 1e-6;  // of the least useful value, where a logarithm needs a left end

struct RoundStep {
    int digit = 1, exponent = 0;  // digit · 10^exponent
    Real value() const { return digit * std::pow(10.0, exponent); }
    RoundStep smaller() const {
        return digit == 5 ? RoundStep{2, exponent} : digit == 2 ? RoundStep{1, exponent} : RoundStep{5, exponent - 1};
    }
};

// The largest 1, 2 or 5 times a power of ten that is at most this.
RoundStep round_step(Real at_most) {
    RoundStep step{5, static_cast<int>(std::floor(std::log10(at_most) + 1e-12))};
    while (step.value() > at_most * (1 + 1e-12)) step = step.smaller();
    return step;
}

// As if its digits had been typed: 3 · 10⁻² is 0.03 to the bit.
Real multiple(Real count, RoundStep step) {
    return finite_number(fmt::format("{:.0f}e{}", count * step.digit, step.exponent)).value_or(count * step.value());
}

}  // namespace

Real roundest(Real from, Real to) {
    if (from <= 0 && to >= 0) return 0;
    if (!(to > from)) return from;
    const Real middle = (from + to) / 2;
    for (RoundStep step = round_step(std::max(std::abs(from), std::abs(to)));; step = step.smaller()) {
        const Real first = std::ceil(from / step.value() * (1 - std::copysign(1e-13, from))),
                   last = std::floor(to / step.value() * (1 + std::copysign(1e-13, to)));
        if (first > last) continue;
        return multiple(std::clamp(std::round(middle / step.value()), first, last), step);
    }
}

SliderScale::SliderScale(const Parameter& p, bool extreme, Real value)
    : span_(extreme ? p.accepted() : p.info.useful), default_(p.info.initial), whole_(p.info.kind == Kind::whole) {
    const Interval& useful = p.info.useful;
    const Interval& accepted = p.accepted();
    const bool log = p.info.scale == Scale::log && useful.min > 0 && accepted.min >= 0;
    if (log) {
        shape_ = Shape::log;
        least_positive_ = span_.min > 0 ? span_.min : useful.min * smallest_extreme;
        if (value > 0) least_positive_ = std::min(least_positive_, value);
        if (accepted.contains(0)) left_ = zero_part;
        span_.min = zero_on_the_left() ? 0 : least_positive_;
    } else {
        const Real hair = whole_ ? 1 : 1e-6 * (span_.max - span_.min);
        if (span_.open_min) span_.min += hair;
    }
    if (span_.open_max) span_.max -= whole_ ? 1 : 1e-6 * (span_.max - span_.min);
    span_.min = std::min(span_.min, value), span_.max = std::max(span_.max, value);
    const Real useful_width = useful.max - useful.min;
    if (!log && (p.info.scale == Scale::log || span_.max - span_.min > far_beyond * useful_width)) {
        shape_ = Shape::asinh;
        linear_to_ = std::max(useful_width / useful_part_linear, whole_ ? Real{1} : Real{0});
    }
}

Real SliderScale::shaped(Real value) const {
    switch (shape_) {
        case Shape::linear:
            return value;
        case Shape::log:
            return std::log(value);
        case Shape::asinh:
            return std::asinh(value / linear_to_);
    }
    return value;
}

Real SliderScale::unshaped(Real coordinate) const {
    switch (shape_) {
        case Shape::linear:
            return coordinate;
        case Shape::log:
            return std::exp(coordinate);
        case Shape::asinh:
            return linear_to_ * std::sinh(coordinate);
    }
    return coordinate;
}

Real SliderScale::place(Real value) const {
    if (zero_on_the_left() && value <= 0) return 0;
    const Real from = shaped(shape_ == Shape::log ? least_positive_ : span_.min), to = shaped(span_.max);
    if (!(to > from)) return 0;
    return std::clamp(left_ + (1 - left_) * (shaped(value) - from) / (to - from), Real{0}, Real{1});
}

Real SliderScale::value_at(Real place) const {
    if (place >= 1) return span_.max;
    if (place <= 0) return span_.min;
    if (place < left_) return place < left_ / 2 ? 0 : least_positive_;
    const Real from = shaped(shape_ == Shape::log ? least_positive_ : span_.min), to = shaped(span_.max);
    return std::clamp(unshaped(from + (to - from) * (place - left_) / (1 - left_)), span_.min, span_.max);
}

Real SliderScale::within(Real value) const { return std::clamp(value, span_.min, span_.max); }

Real SliderScale::snapped(Real place, Real pixel) const {
    // An end has what is left of its pixel, and all that lies beyond.
    if (place <= pixel / 2) return span_.min;
    if (place >= 1 - pixel / 2) return span_.max;
    if (place < left_) return value_at(place);
    const Real from = value_at(std::max(place - pixel / 2, left_)), to = value_at(place + pixel / 2);
    if (default_ >= from && default_ <= to) return default_;
    if (whole_ && std::ceil(from) > to) return within(std::round(value_at(place)));
    const Real round = roundest(from, to);
    return within(whole_ ? std::round(round) : round);
}

Real SliderScale::one_step(Real value, int direction, bool fine) const {
    if (zero_on_the_left() && value <= least_positive_ && direction < 0) return 0;
    if (zero_on_the_left() && value <= 0) return direction > 0 ? least_positive_ : 0;
    // As long as the slider is dense on the side to which it goes, so that a step back leads to where one came from.
    const Real here = place(value), part = 1 / (fine ? 10 * steps_along : steps_along);
    const Real length =
        direction > 0 ? value_at(std::min(here + part, Real{1})) - value : value - value_at(std::max(here - part, left_));
    const Real least = whole_ ? 1 : 1e-15 * std::max(std::abs(span_.min), std::abs(span_.max));
    RoundStep step = round_step(std::max({length, least, std::abs(value) * 1e-12}));
    if (whole_ && step.exponent < 0) step = {1, 0};
    const Real count = value / step.value(), near = std::round(count);
    const Real on = std::abs(count - near) < 1e-6 ? near + direction : direction > 0 ? std::ceil(count) : std::floor(count);
    const Real next = multiple(on, step);
    if (shape_ == Shape::log && next < least_positive_) return span_.min;
    return within(next);
}

Real SliderScale::stepped(Real value, int steps, bool fine) const {
    for (int i = 0; i < std::abs(steps); ++i) value = one_step(value, steps > 0 ? 1 : -1, fine);
    return value;
}

}  // namespace pliant::viewer
