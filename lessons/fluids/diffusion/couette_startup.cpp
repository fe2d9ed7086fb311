#include "couette_startup.h"

#include <cmath>
#include <numbers>

namespace pliant::diffusion {

Real couette_startup(Real x, Real tau, Real low, Real high) {
    using std::numbers::pi;
    constexpr int most_terms = 2000;
    constexpr Real negligible = 40;  // of the exponent
    if (!(tau > 0)) return 0;
    Real sum = low + (high - low) * x;
    // sin(mθ) from the two before it.
    const Real twice_cos = 2 * std::cos(pi * x);
    Real before = 0, sine = std::sin(pi * x), sign = -1;
    for (int m = 1; m <= most_terms && m * m * pi * pi * tau < negligible; ++m) {
        sum += 2 / (m * pi) * (sign * high - low) * sine * std::exp(-m * m * pi * pi * tau);
        const Real next = twice_cos * sine - before;
        before = sine, sine = next, sign = -sign;
    }
    return sum;
}

}  // namespace pliant::diffusion
