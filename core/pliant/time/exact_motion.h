// Motions in closed form that integrators are measured against.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

// A place and its velocity.
struct Motion {
    Real x = 0, v = 0;
};

// x'' = -omega^2 x - 2 zeta omega x' from `start`, at time t >= 0. omega, zeta >= 0; unless omega = 0, which is a free motion,
// it is written so that nothing cancels: with the real roots as r and omega^2/r, and the difference of their exponentials as
// expm1, from far below zeta = 1 to far above [Hairer1993 §I.6].
Motion damped_oscillator(Real omega, Real zeta, Motion start, Real t);

// The undamped pendulum theta'' = -omega^2 sin theta by Jacobi's elliptic functions, for swings, for turns over the top and for
// the motion between both, which comes to rest on the top [Abramowitz1964 §16]. Places and velocities are measured along the arc
// of radius gravity / omega^2 [m, m/s]. How near a start is to the top is told by the energy that it lacks, or has too much, and
// that is computed without cancellation: the closed form holds up to a start that is next to the top.
class Pendulum {
public:
    // omega > 0 [rad/s], gravity > 0 [m/s^2].
    Pendulum(Real omega, Real gravity, Motion start);

    Motion at(Real t) const;
    // Of one swing to and fro, or of one turn; infinite where it comes to rest on the top [s].
    Real period() const;
    // Reaches the top, or goes over it.
    bool reaches_top() const { return kind_ == Kind::turns || kind_ == Kind::comes_to_the_top; }

private:
    enum class Kind { rests, swings, turns, comes_to_the_top };

    Real omega_, length_;
    Kind kind_ = Kind::rests;
    Real centre_ = 0;      // place of the lowest point that the start is nearest to
    Real side_ = 1;        // to which it turns
    Real modulus_ = 0;     // k: sine of half the largest angle; above 1 it turns, by Jacobi's functions of 1/k
    Real complement_ = 1;  // of the modulus of Jacobi's functions
    Real phase_ = 0;       // their argument at the start
};

}  // namespace pliant
