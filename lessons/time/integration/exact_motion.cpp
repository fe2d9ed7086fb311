#include "exact_motion.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace pliant::integration {
namespace {

using std::numbers::pi;
constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

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

// F(phi, k) for phi in [-pi/2, pi/2], given by its sine and cosine; dn2 = 1 - k^2 sin^2 phi.
Real first_kind(Real sine, Real cosine, Real dn2) { return sine * carlson_rf(cosine * cosine, dn2, 1); }

Real complete_first_kind(Real complement) {
    Real a = 1, b = complement;
    for (int k = 0; k < 40 && std::abs(a - b) > 4 * epsilon * a; ++k) {
        const Real mean = (a + b) / 2;
        b = std::sqrt(a * b), a = mean;
    }
    return pi / (a + b);
}

// The amplitude am(u, k) with the complementary modulus k' > 0: descending Landen transformation.
Real amplitude(Real u, Real complement) {
    std::array<Real, 40> ratio{};  // c_n / a_n
    Real a = 1, b = complement, c = std::sqrt((1 - b) * (1 + b));
    std::size_t n = 0;
    while (std::abs(c) > epsilon * a && n + 1 < ratio.size()) {
        c = (a - b) / 2;
        const Real mean = (a + b) / 2;
        b = std::sqrt(a * b), a = mean;
        ratio[++n] = c / a;
    }
    Real phi = std::ldexp(a * u, static_cast<int>(n));
    for (; n > 0; --n) phi = (phi + std::asin(ratio[n] * std::sin(phi))) / 2;
    return phi;
}

// A swing that turns back: sin(theta/2) = k sn, theta' = 2 omega k cn.
Motion swing(Real omega, Motion start, Real k, Real complement, Real t) {
    const Real sine = std::sin(start.x / 2) / k, cosine = start.v / (2 * omega * k), dn = std::cos(start.x / 2);
    const Real quarter = complete_first_kind(complement);
    Real u = first_kind(sine, cosine, dn * dn);
    if (cosine < 0) u = std::copysign(2 * quarter, sine) - u;
    const Real phi = amplitude(std::fmod(u + omega * t, 4 * quarter), complement);
    return {2 * std::asin(k * std::sin(phi)), 2 * omega * k * std::cos(phi)};
}

// Over the top, with k > 1: theta/2 = am(omega k t + u, 1/k), to the side that it turns to.
Motion turn(Real omega, Motion start, Real k, Real excess, Real t) {
    const Real side = std::copysign(1, start.v), half = side * start.x / 2;
    const Real complement = excess / k;  // of 1/k
    const Real u = first_kind(std::sin(half), std::cos(half), 1 - std::pow(std::sin(half) / k, 2));
    const Real phi = amplitude(u + omega * k * t, complement);
    const Real dn = std::hypot(std::cos(phi), complement * std::sin(phi));
    return {side * 2 * phi, side * 2 * omega * k * dn};
}

// Just to the top, which it never reaches: k = 1.
Motion to_the_top(Real omega, Motion start, Real t) {
    const Real side = std::copysign(1, start.v);
    const Real u = std::atanh(std::min(side * std::sin(start.x / 2), 1 - epsilon)) + omega * t;
    return {side * 2 * std::asin(std::tanh(u)), side * 2 * omega / std::cosh(u)};
}

// k^2, and 1 - k^2 without cancellation; whole turns of the angle are taken off.
struct Modulus {
    Real turns, square, complement_square;
};
Modulus modulus_of(Real omega, Motion& start) {
    const Real turns = 2 * pi * std::round(start.x / (2 * pi));
    start.x -= turns;
    const Real rate = start.v / (2 * omega), s = std::sin(start.x / 2), c = std::cos(start.x / 2);
    return {turns, s * s + rate * rate, (c - rate) * (c + rate)};
}

}  // namespace

Motion damped_oscillator(Real omega, Real zeta, Motion start, Real t) {
    const auto [x0, v0] = start;
    if (omega == 0) return {x0 + v0 * t, v0};
    if (zeta < 1) {
        const Real rate = zeta * omega, turning = omega * std::sqrt((1 - zeta) * (1 + zeta)), fading = std::exp(-rate * t);
        const Real c = std::cos(turning * t), s = std::sin(turning * t) / turning;
        return {fading * (x0 * c + (v0 + rate * x0) * s), fading * (v0 * c - (omega * omega * x0 + rate * v0) * s)};
    }
    const Real half_gap = omega * std::sqrt((zeta - 1) * (zeta + 1));
    const Real fast = zeta * omega + half_gap, slow = omega * (omega / fast), along = v0 + slow * x0;
    const Real spread = half_gap * t > 0 ? -std::expm1(-2 * half_gap * t) / (2 * half_gap) : t;
    const Real fading = std::exp(-slow * t), x = fading * (x0 + along * spread);
    return {x, along * std::exp(-fast * t) - slow * x};
}

Motion pendulum(Real omega, Motion start, Real t) {
    if (omega == 0) return {start.x + start.v * t, start.v};
    const auto [turns, square, complement_square] = modulus_of(omega, start);
    const Real k = std::sqrt(square);
    if (k == 0) return {turns, 0};
    Motion now;
    if (std::abs(complement_square) < 8 * epsilon)
        now = start.v == 0 ? start : to_the_top(omega, start, t);
    else if (complement_square > 0)
        now = swing(omega, start, k, std::sqrt(complement_square), t);
    else
        now = turn(omega, start, k, std::sqrt(-complement_square), t);
    return {now.x + turns, now.v};
}

Real pendulum_period(Real omega, Motion start) {
    const auto [turns, square, complement_square] = modulus_of(omega, start);
    if (complement_square > 0) return 4 * complete_first_kind(std::sqrt(complement_square)) / omega;
    const Real k = std::sqrt(square);
    return 2 * complete_first_kind(std::sqrt(-complement_square) / k) / (omega * k);
}

}  // namespace pliant::integration
