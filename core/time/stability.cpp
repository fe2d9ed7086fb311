#include <pliant/time/stability.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {
namespace {

constexpr Real infinite = std::numeric_limits<Real>::infinity();

// Rate |mu| of the faster of two real modes exp(mu t), zeta >= 1.
Real fastest_decay(Real omega, Real zeta) { return omega * (zeta + std::sqrt(zeta * zeta - 1)); }

// Larger modulus of the roots of z^2 - trace z + determinant.
Real spectral_radius(Real trace, Real determinant) {
    const Real discriminant = trace * trace / 4 - determinant;
    if (discriminant < 0) return std::sqrt(determinant);
    return std::abs(trace) / 2 + std::sqrt(discriminant);
}

}  // namespace

Real stability_limit(Scheme scheme, Real omega, Real zeta) {
    if (scheme == Scheme::implicit_euler || omega == 0) return infinite;
    if (scheme == Scheme::semi_implicit_euler) return 2 / (omega * (std::sqrt(1 + zeta * zeta) + zeta));
    return zeta <= 1 ? 2 * zeta / omega : 2 / fastest_decay(omega, zeta);
}

Real amplification(Scheme scheme, Real omega, Real zeta, Real dt) {
    const Real stiffness = omega * omega * dt * dt, damping = 2 * zeta * omega * dt;
    switch (scheme) {
        case Scheme::explicit_euler:
            return spectral_radius(2 - damping, 1 - damping + stiffness);
        case Scheme::semi_implicit_euler:
            return spectral_radius(2 - damping - stiffness, 1 - damping);
        case Scheme::implicit_euler:
            break;
    }
    const Real pivot = 1 + damping + stiffness;
    return spectral_radius((2 + damping) / pivot, 1 / pivot);
}

}  // namespace pliant
