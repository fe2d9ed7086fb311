// A field on the unit square that vanishes on its edges, and the force that makes it the exact solution of plane elasticity
// [Roache2002]: u = (0.1 sin πx sin πy, 0.05 sin πx sin 2πy) m.
#pragma once
#include <pliant/math/types.h>

#include <cmath>
#include <numbers>

namespace pliant::manufactured {

inline Vec<2> displacement(const Vec<2>& X) {
    const Real p = std::numbers::pi, sx = std::sin(p * X[0]);
    return {0.1 * sx * std::sin(p * X[1]), 0.05 * sx * std::sin(2 * p * X[1])};
}
inline Mat<2> gradient(const Vec<2>& X) {
    const Real p = std::numbers::pi, x = p * X[0], y = p * X[1];
    Mat<2> H;
    H << 0.1 * p * std::cos(x) * std::sin(y), 0.1 * p * std::sin(x) * std::cos(y), 0.05 * p * std::cos(x) * std::sin(2 * y),
        0.1 * p * std::sin(x) * std::cos(2 * y);
    return H;
}
// The body force is - div σ = λ times this one plus μ times the next [1/m].
inline Vec<2> force_of_lambda(const Vec<2>& X) {
    const Real pp = std::numbers::pi * std::numbers::pi, x = std::numbers::pi * X[0], y = std::numbers::pi * X[1];
    return {pp * (0.1 * std::sin(x) * std::sin(y) - 0.1 * std::cos(x) * std::cos(2 * y)),
            pp * (0.2 * std::sin(x) * std::sin(2 * y) - 0.1 * std::cos(x) * std::cos(y))};
}
inline Vec<2> force_of_mu(const Vec<2>& X) {
    const Real pp = std::numbers::pi * std::numbers::pi, x = std::numbers::pi * X[0], y = std::numbers::pi * X[1];
    return force_of_lambda(X) + Vec<2>(0.2 * pp * std::sin(x) * std::sin(y), 0.25 * pp * std::sin(x) * std::sin(2 * y));
}

}  // namespace pliant::manufactured
