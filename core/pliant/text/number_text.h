// Numbers as a person writes them, read the same everywhere: decimal, with a point or a comma, whatever the language of the
// machine. A comma that may separate thousands is not guessed at. A zero in front counts for nothing ("010" is ten), one sign may
// stand before the digits.
#pragma once
#include <pliant/math/types.h>

#include <optional>
#include <string_view>
#include <system_error>

namespace pliant {

struct NumberText {
    Real value = 0;          // may be infinite or NaN, where "inf" or "nan" was written
    bool ambiguous = false;  // "1,250" may be 1.25 or 1250; then it is no number
    std::errc error{};       // invalid_argument: no number; result_out_of_range: beyond all numbers, or too close to 0
    bool good() const { return error == std::errc(); }
};
NumberText read_number(std::string_view text);

// Finite ones alone.
std::optional<Real> finite_number(std::string_view text);
// Whole ones, however they are written: "1e4" is one. Up to 9e15, so that all of them are exact.
std::optional<Index> whole_number(std::string_view text);

// Is this a whole number that a Real holds exactly?
bool is_whole(Real value);

}  // namespace pliant
