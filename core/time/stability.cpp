#include <pliant/time/stability.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

namespace pliant {
namespace {

using Complex = std::complex<Real>;
constexpr Real infinite = std::numeric_limits<Real>::infinity();

// Rate |mu| of the fastest mode exp(mu t).
Real fastest_rate(Real omega, Real zeta) { return zeta > 1 ? omega * (zeta + std::sqrt(zeta * zeta - 1)) : omega; }

// Roots mu dt of the oscillator, with w = omega dt.
std::array<Complex, 2> roots(Real w, Real zeta) {
    if (std::abs(zeta) < 1) {
        const Complex root(-zeta * w, w * std::sqrt(1 - zeta * zeta));
        return {root, std::conj(root)};
    }
    const Real fast = w * (zeta + std::copysign(std::sqrt(zeta * zeta - 1), zeta));
    return {Complex(-fast), Complex(-w * w / fast)};
}

// Larger modulus of the roots of z^2 - trace z + determinant.
Real spectral_radius(Real trace, Real determinant) {
    const Real discriminant = trace * trace / 4 - determinant;
    if (discriminant < 0) return std::sqrt(determinant);
    return std::abs(trace) / 2 + std::sqrt(discriminant);
}

// (I - Z/2)^-1 (I + Z/2) of the midpoint rule, and for linear forces of Newmark's average acceleration.
Real trapezoidal_radius(Real stiffness, Real damping) {
    const Real pivot = 1 + damping / 2 + stiffness / 4;
    return spectral_radius((2 - stiffness / 2) / pivot, (1 - damping / 2 + stiffness / 4) / pivot);
}

// The matrix on (x, dt v), whose second force takes the predicted velocity.
Real verlet_radius(Real stiffness, Real damping) {
    const Real xx = 1 - stiffness / 2, xv = 1 - damping / 2;
    const Real vx = -stiffness + stiffness * stiffness / 4 + damping * stiffness / 2;
    const Real vv = 1 - damping - stiffness / 2 + stiffness * damping / 4 + damping * damping / 2;
    return spectral_radius(xx + vv, xx * vv - xv * vx);
}

Real runge_kutta_radius(Real w, Real zeta) {
    Real largest = 0;
    for (const Complex z : roots(w, zeta))
        largest = std::max(largest, std::abs(1. + z * (1. + z / 2. * (1. + z / 3. * (1. + z / 4.)))));
    return largest;
}

// Roots r of (3/2 - z) r^2 - 2 r + 1/2 = 0.
Real bdf2_radius(Real w, Real zeta) {
    Real largest = 0;
    for (const Complex z : roots(w, zeta)) {
        const Complex root = std::sqrt(1. + 2. * z), pivot = 3. - 2. * z;
        largest = std::max({largest, std::abs((2. + root) / pivot), std::abs((2. - root) / pivot)});
    }
    return largest;
}

// The first dt at which amplitudes grow: found on a scan, then by halving. No explicit scheme here is stable beyond a fastest
// rate times dt of 6.
Real first_growth(Scheme scheme, Real omega, Real zeta) {
    constexpr Real scan = 0.05, furthest = 6, rounding = 1e-9;
    const Real unit = 1 / fastest_rate(omega, zeta);
    const auto grows = [&](Real s) { return amplification(scheme, omega, zeta, s * unit) > 1 + rounding; };
    Real low = 0, high = scan;
    while (high < furthest && !grows(high)) {
        low = high;
        high += scan;
    }
    for (int halving = 0; halving < 48; ++halving) {
        const Real middle = (low + high) / 2;
        (grows(middle) ? high : low) = middle;
    }
    return low * unit;
}

}  // namespace

Real stability_limit(Scheme scheme, Real omega, Real zeta) {
    if (is_implicit(scheme) || omega == 0) return infinite;
    switch (scheme) {
        case Scheme::explicit_euler:
            return zeta <= 1 ? 2 * zeta / omega : 2 / fastest_rate(omega, zeta);
        case Scheme::semi_implicit_euler:
            return 2 / (omega * (std::sqrt(1 + zeta * zeta) + zeta));
        case Scheme::velocity_verlet:
            return zeta == 0 ? 2 / omega : first_growth(scheme, omega, zeta);
        default:
            return zeta == 0 ? std::sqrt(Real{8}) / omega : first_growth(scheme, omega, zeta);
    }
}

Real amplification(Scheme scheme, Real omega, Real zeta, Real dt) {
    const Real w = omega * dt, stiffness = w * w, damping = 2 * zeta * w;
    switch (scheme) {
        case Scheme::explicit_euler:
            return spectral_radius(2 - damping, 1 - damping + stiffness);
        case Scheme::semi_implicit_euler:
            return spectral_radius(2 - damping - stiffness, 1 - damping);
        case Scheme::implicit_euler: {
            const Real pivot = 1 + damping + stiffness;
            return spectral_radius((2 + damping) / pivot, 1 / pivot);
        }
        case Scheme::velocity_verlet:
            return verlet_radius(stiffness, damping);
        case Scheme::runge_kutta_4:
            return runge_kutta_radius(w, zeta);
        case Scheme::bdf2:
            return bdf2_radius(w, zeta);
        default:
            return trapezoidal_radius(stiffness, damping);
    }
}

}  // namespace pliant
