// Numbers that are none, for tests of plots.
#pragma once
#include <pliant/math/types.h>

#include <limits>

namespace pliant::test {

inline constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();

}  // namespace pliant::test
