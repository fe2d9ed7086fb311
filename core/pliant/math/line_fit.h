// The straight line that fits measured points best.
#pragma once
#include <pliant/math/types.h>

#include <optional>
#include <span>

namespace pliant {

struct LineFit {
    Real slope = 0, intercept = 0;
    Real largest_deviation = 0;  // of a value from the line
};

// Least squares of value against position. Empty where no line is defined: fewer than two points, or all at one position.
std::optional<LineFit> fit_line(std::span<const Real> position, std::span<const Real> value);

}  // namespace pliant
