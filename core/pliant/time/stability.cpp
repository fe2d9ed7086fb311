#include <pliant/time/stability.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

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

// Trace and determinant of the matrix of one step on (x, dt v), with s = (omega dt)^2 and d = 2 zeta omega dt.
struct Invariants {
    Real trace, determinant;
};

Invariants invariants(Scheme scheme, Real s, Real d) {
    switch (scheme) {
        case Scheme::explicit_euler:
            return {2 - d, 1 - d + s};
        case Scheme::semi_implicit_euler:
            return {2 - d - s, 1 - d};
        case Scheme::implicit_euler:
            return {(2 + d) / (1 + d + s), 1 / (1 + d + s)};
        case Scheme::velocity_verlet: {
            // The second force takes the predicted velocity.
            const Real xx = 1 - s / 2, xv = 1 - d / 2, vx = -s + s * s / 4 + d * s / 2;
            const Real vv = 1 - d - s / 2 + s * d / 4 + d * d / 2;
            return {xx + vv, xx * vv - xv * vx};
        }
        default: {
            // (I - Z/2)^-1 (I + Z/2) of the midpoint rule, and for linear forces of Newmark's average acceleration.
            const Real pivot = 1 + d / 2 + s / 4;
            return {(2 - s / 2) / pivot, (1 - d / 2 + s / 4) / pivot};
        }
    }
}

// The factor of one root z of the oscillator, of a scheme that treats each root for itself. BDF2 has two: the roots r of
// (3/2 - z) r^2 - 2 r + 1/2 = 0, of which the larger counts.
Complex factor_of(Scheme scheme, Complex z) {
    if (scheme == Scheme::runge_kutta_4) return 1. + z * (1. + z / 2. * (1. + z / 3. * (1. + z / 4.)));
    const Complex root = std::sqrt(1. + 2. * z), pivot = 3. - 2. * z;
    const Complex one = (2. + root) / pivot, other = (2. - root) / pivot;
    return std::abs(one) >= std::abs(other) ? one : other;
}

bool root_by_root(Scheme scheme) { return scheme == Scheme::runge_kutta_4 || scheme == Scheme::bdf2; }

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

std::string limit_in_words(Scheme scheme) {
    const std::string name(info_of(scheme).name);
    switch (scheme) {
        case Scheme::explicit_euler:
            return name + ", 2ζ/ω up to ζ = 1, beyond it (2/ω)(ζ − √(ζ² − 1))";
        case Scheme::semi_implicit_euler:
            return name + ", (2/ω)(√(1 + ζ²) − ζ)";
        default:
            return name;
    }
}

Real amplification(Scheme scheme, Real omega, Real zeta, Real dt) {
    const Real w = omega * dt;
    if (root_by_root(scheme)) {
        const auto [one, other] = roots(w, zeta);
        return std::max(std::abs(factor_of(scheme, one)), std::abs(factor_of(scheme, other)));
    }
    const auto [trace, determinant] = invariants(scheme, w * w, 2 * zeta * w);
    return spectral_radius(trace, determinant);
}

bool dissipates(Scheme scheme) { return scheme == Scheme::implicit_euler || scheme == Scheme::bdf2; }

Real energy_excess(Scheme scheme, Real w, bool linear, bool damped) {
    constexpr Real closest = 1e-3;  // to the limit of stability, where the bound has a pole
    switch (scheme) {
        case Scheme::explicit_euler:
            return damped ? 2 * w : 0;
        case Scheme::semi_implicit_euler:
            return 2 * w / std::max(2 - w, closest);
        case Scheme::velocity_verlet:
            return 2 * w * w / std::max(4 - w * w, closest);
        case Scheme::runge_kutta_4:
            return linear && !damped ? 0 : w * w * w * w;
        case Scheme::implicit_euler:
            return 0;
        default:
            return linear && scheme != Scheme::bdf2 ? 0 : std::min(w * w, Real{1});
    }
}

Real phase_per_step(Scheme scheme, Real omega, Real zeta, Real dt) {
    const Real w = omega * dt;
    if (root_by_root(scheme)) return std::abs(std::arg(factor_of(scheme, roots(w, zeta)[0])));
    const auto [trace, determinant] = invariants(scheme, w * w, 2 * zeta * w);
    const Real discriminant = trace * trace / 4 - determinant;
    if (discriminant < 0) return std::atan2(std::sqrt(-discriminant), trace / 2);
    return trace < 0 ? std::numbers::pi : 0;
}

}  // namespace pliant
