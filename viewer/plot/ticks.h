// The numbers along an axis and the text of its unit.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "plot/range.h"

namespace pliant::viewer {

struct Tick {
    Real value = 0;
    std::string text;  // empty for a minor tick
};

// The ticks of one axis, from low to high. Numbers along a linear axis are in `unit`, which may carry an SI prefix or a power of
// ten
// ("kPa", "10³ N/m³"), and are counted from `offset` when they would differ only in late digits.
struct Ticks {
    std::vector<Tick> ticks;
    std::string unit;    // empty: dimensionless
    std::string offset;  // "1000000 Pa": what is left out of every number; empty when nothing is
};

// At most `most` >= 1 labelled ticks. Linear: multiples of 1, 2 or 5 times a power of ten. Log: powers of ten, with minor ticks,
// and numbers in between when less than two decades are shown.
Ticks make_ticks(Range range, AxisScale scale, int most, std::string_view unit);

// "10³", "10⁻¹²".
std::string power_of_ten(int exponent);

// "time t [s]", "σ - 1000000 Pa [mPa]"; without the name when that is empty, without the unit when dimensionless.
std::string axis_text(std::string_view label, const Ticks& ticks);

}  // namespace pliant::viewer
