// What the measures of strain cost: the floating-point operations that their formulas take for a 3 × 3 matrix, counted while they
// run.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

struct OperationCounts {
    Index right_cauchy_green = 0, green = 0, cauchy = 0;
};

// Of the functions of core/pliant/continuum/strain.h as they stand, additions and multiplications alike.
OperationCounts count_operations();

}  // namespace pliant
