// Cubic interpolation between two samples that never leaves their range.
#pragma once
#include <pliant/math/pair.h>

#include <array>
#include <cmath>

namespace pliant {

// The cubic Hermite polynomial between the samples q[1] and q[2] at t in [0, 1], with the central differences of the four
// samples as slopes, each limited to between 0 and three times the difference of the two: the polynomial is then monotone
// [FritschCarlson1980 §3; Fedkiw2001, appendix B]. Exact for parabolas where no slope is limited. T: a number or a pair of them.
template <class T>
[[gnu::always_inline]] inline T monotone_cubic(const std::array<T, 4>& q, Real t) {
    const T rise = q[2] - q[1], none = Real(0) * rise, steep = Real(3) * rise;
    const T low = smaller(steep, none), high = larger(steep, none);
    const auto limited = [&](const T& slope) -> T { return smaller(larger(slope, low), high); };
    const T d1 = limited(Real(0.5) * (q[2] - q[0])), d2 = limited(Real(0.5) * (q[3] - q[1]));
    const T value = q[1] + t * (d1 + t * ((steep - Real(2) * d1 - d2) + t * (d1 + d2 - Real(2) * rise)));
    return smaller(larger(value, smaller(q[1], q[2])), larger(q[1], q[2]));  // against rounding
}

// The same polynomial as weights of the four samples, which depend on the samples where a slope is limited. They add up to 1.
inline std::array<Real, 4> monotone_cubic_weights(const std::array<Real, 4>& q, Real t) {
    const Real rise = q[2] - q[1];
    const Real at1 = t * (1 - t) * (1 - t), at2 = t * t * (t - 1), step = t * t * (3 - 2 * t);
    std::array<Real, 4> w{0, 1 - step, step, 0};
    // A slope is half the difference of the samples beside it, three times the rise, or 0.
    const auto add = [&](std::size_t k, Real basis) {
        const Real slope = (q[k + 1] - q[k - 1]) / 2;
        if (slope * rise <= 0) return;
        const bool limited = std::abs(slope) > 3 * std::abs(rise);
        w[limited ? 2 : k + 1] += (limited ? 3 : 0.5) * basis;
        w[limited ? 1 : k - 1] -= (limited ? 3 : 0.5) * basis;
    };
    add(1, at1);
    add(2, at2);
    return w;
}

}  // namespace pliant
