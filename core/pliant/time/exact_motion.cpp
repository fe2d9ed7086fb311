#include <pliant/math/elliptic.h>
#include <pliant/time/exact_motion.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace pliant {

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

// The half angle of the start decides on all that follows, by what it and the speed leave to the top: with long doubles, since a
// start may be as near to the top as doubles come.
Pendulum::Pendulum(Real omega, Real gravity, Motion start) : omega_(omega), length_(gravity / (omega * omega)) {
    using Wide = long double;
    const Wide half = Wide{start.x} * omega * omega / (2 * Wide{gravity}), rate = Wide{start.v} * omega / (2 * Wide{gravity});
    Wide s = std::sin(half), c = std::cos(half);
    if (c < 0) s = -s, c = -c;
    const Wide turns = std::round((half - std::atan2(s, c)) / std::numbers::pi_v<Wide>);
    centre_ = static_cast<Real>(2 * std::numbers::pi_v<Wide> * turns * gravity / (Wide{omega} * omega));

    const Wide k = std::hypot(s, rate), to_the_top = (c - rate) * (c + rate);  // 1 - k^2
    if (k == 0) return;
    const Real sine = static_cast<Real>(s), cosine = static_cast<Real>(c), v = static_cast<Real>(rate);
    modulus_ = static_cast<Real>(k);
    side_ = v == 0 ? std::copysign(Real{1}, sine) : std::copysign(Real{1}, v);
    if (to_the_top > 0) {
        kind_ = Kind::swings;
        complement_ = static_cast<Real>(std::sqrt(to_the_top));
        phase_ = elliptic_integral(static_cast<Real>(s / k), static_cast<Real>(rate / k), cosine);
        if (v < 0) phase_ = std::copysign(2 * complete_elliptic_integral(complement_), sine) - phase_;
    } else if (to_the_top < 0) {
        kind_ = Kind::turns;
        complement_ = static_cast<Real>(std::sqrt(-to_the_top) / k);
        phase_ = elliptic_integral(side_ * sine, cosine, std::abs(static_cast<Real>(rate / k)));
    } else {
        kind_ = Kind::comes_to_the_top;
        phase_ = std::asinh(side_ * static_cast<Real>(s / c));
    }
}

// Half the angle from the lowest point is told by its sine and cosine, so that next to the top no digit is lost.
Motion Pendulum::at(Real t) const {
    const auto on_arc = [this](Real half_angle, Real half_rate) {
        return Motion{centre_ + 2 * length_ * half_angle, 2 * length_ * omega_ * half_rate};
    };
    switch (kind_) {
        case Kind::rests:
            break;
        case Kind::swings: {
            // sin(theta/2) = k sn, cos(theta/2) = dn, theta' = 2 omega k cn
            const Real lap = 4 * complete_elliptic_integral(complement_);
            const auto [am, sn, cn, dn] = elliptic_functions(std::fmod(phase_ + omega_ * t, lap), complement_);
            return on_arc(std::atan2(modulus_ * sn, dn), modulus_ * cn);
        }
        case Kind::turns: {
            // theta/2 = am(omega k t + u, 1/k) to the side that it turns to
            const EllipticFunctions now = elliptic_functions(phase_ + omega_ * modulus_ * t, complement_);
            return on_arc(side_ * now.am, side_ * modulus_ * now.dn);
        }
        case Kind::comes_to_the_top:
            // k = 1, which the top is never left with: sin(theta/2) = tanh u
            return on_arc(side_ * std::atan(std::sinh(phase_ + omega_ * t)), side_ / std::cosh(phase_ + omega_ * t));
    }
    return {centre_, 0};
}

Real Pendulum::period() const {
    switch (kind_) {
        case Kind::rests:
        case Kind::swings:
            return 4 * complete_elliptic_integral(complement_) / omega_;
        case Kind::turns:
            return 2 * complete_elliptic_integral(complement_) / (omega_ * modulus_);
        case Kind::comes_to_the_top:
            break;
    }
    return std::numeric_limits<Real>::infinity();
}

}  // namespace pliant
