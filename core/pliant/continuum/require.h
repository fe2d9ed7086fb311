// What every elastic constant must be.
#pragma once
#include <pliant/math/error.h>

#include <cmath>
#include <string_view>

namespace pliant {

// Throws Refused, naming the modulus, unless it is a finite value above 0 Pa.
inline void require_positive_modulus(std::string_view name, Real value) {
    if (!(value > 0) || !std::isfinite(value)) throw Refused(name, value, "Pa", "a finite value > 0 Pa");
}

}  // namespace pliant
