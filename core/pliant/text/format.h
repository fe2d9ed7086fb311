// Numbers as people read them, and as programs read them back.
#pragma once
#include <pliant/math/types.h>

#include <string>
#include <string_view>

namespace pliant {

// "412.3 kPa", "0.05", "1.2×10⁻⁷ m²/s": a value with its unit, SI-prefixed where the unit takes a prefix, else scientific when
// very large or small. `digits` counts significant digits. An empty unit means dimensionless. A value that is not finite
// reads "undefined".
std::string format_quantity(Real value, std::string_view unit, int digits = 4);

// The unit in which format_quantity writes this number: "kPa".
std::string unit_shown(Real value, std::string_view unit, int digits = 4);

// The shortest decimal text that reads back as exactly this number.
std::string format_exact(Real value);

// The largest number of so many significant digits that is at most this one: 0.00478 gives 0.0047.
Real rounded_down(Real value, int digits = 2);

// "in s", "in Pa" or, without a unit, "dimensionless": for tables and messages.
std::string unit_or_dimensionless(std::string_view unit);

}  // namespace pliant
