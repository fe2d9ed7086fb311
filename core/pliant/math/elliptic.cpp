#include <pliant/math/elliptic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace pliant {
namespace {

constexpr Real rounding = std::numeric_limits<Real>::epsilon();

// R_F(x, y, z) by duplication: half the integral of 1/sqrt((t + x)(t + y)(t + z)) over t > 0 [Carlson1995].
Real carlson_rf(Real x, Real y, Real z) {
    for (int doubling = 0; doubling < 60; ++doubling) {
        const Real mean = (x + y + z) / 3;
        const Real dx = 1 - x / mean, dy = 1 - y / mean, dz = 1 - z / mean;
        if (std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) < 1e-3) {
            const Real e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
            return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(mean);
        }
        const Real shift = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
        x = (x + shift) / 4, y = (y + shift) / 4, z = (z + shift) / 4;
    }
    return 1 / std::sqrt((x + y + z) / 3);
}

}  // namespace

Real complete_elliptic_integral(Real complement) {
    if (complement == 0) return std::numeric_limits<Real>::infinity();
    Real a = 1, b = complement;
    for (int k = 0; k < 40 && std::abs(a - b) > 4 * rounding * a; ++k) {
        const Real mean = (a + b) / 2;
        b = std::sqrt(a * b), a = mean;
    }
    return std::numbers::pi / (a + b);
}

Real elliptic_integral(Real sine, Real cosine, Real dn) { return sine * carlson_rf(cosine * cosine, dn * dn, 1); }

EllipticFunctions elliptic_functions(Real u, Real complement) {
    struct Means {
        Real a, b, c;
    };
    std::array<Means, 40> means{};
    means[0] = {1, complement, std::sqrt((1 - complement) * (1 + complement))};
    std::size_t n = 0;
    while (std::abs(means[n].c) > rounding * means[n].a && n + 1 < means.size()) {
        const auto [a, b, c] = means[n];
        means[++n] = {(a + b) / 2, std::sqrt(a * b), (a - b) / 2};
    }
    Real phi = std::ldexp(means[n].a * u, static_cast<int>(n));
    for (; n > 0; --n) {
        // The arcsine of c/a sin(phi), by its cosine as well: near 1 the sine alone has lost it.
        const auto [a, b, c] = means[n];
        const Real sine = std::sin(phi), cosine = std::cos(phi);
        phi = (phi + std::atan2(c * sine, std::hypot(a * cosine, b * sine))) / 2;
    }
    const Real sn = std::sin(phi), cn = std::cos(phi);
    return {phi, sn, cn, std::hypot(cn, complement * sn)};
}

}  // namespace pliant
