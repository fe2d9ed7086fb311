// Numbers with their unit, as a person writes them: "0.02", "2e-2 s", "20 ms", "0,5 m".
#pragma once
#include <pliant/math/types.h>

#include <string>
#include <string_view>

namespace pliant {

struct QuantityText {
    enum class Problem {
        none,
        no_number,     // "2*3"
        out_of_range,  // beyond all numbers, or too close to 0
        ambiguous,     // "1,250" may be 1.25 or 1250
        other_unit     // "3 kg" for a length
    };
    Real value = 0;  // in the unit that was asked for
    Problem problem = Problem::none;
    std::string_view unit{};  // that was written; empty when none was
};

// The number in `unit`; one that has no unit of its own is in `unit_if_none`, or, where that is empty, in `unit`. The unit may
// bear an SI prefix, ms for s, and a power may be written as "m/s^2" or "m/s2". Blanks around the number count for nothing.
QuantityText read_quantity(std::string_view text, std::string_view unit, std::string_view unit_if_none = "");

// All digits of the number in this unit, which is `unit` or differs from it by a prefix: read_quantity reads exactly the same
// number back. "12.345678901 ms".
std::string quantity_in(Real value, std::string_view unit, std::string_view written_unit);

// What may be written behind a number in `unit`, for messages: "s, ms or µs". Empty without a unit.
std::string units_accepted(std::string_view unit);

}  // namespace pliant
