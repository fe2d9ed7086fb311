// Motions in closed form that the integrators are measured against.
#pragma once
#include <pliant/math/types.h>

namespace pliant::integration {

// A place and its velocity.
struct Motion {
    Real x = 0, v = 0;
};

// x'' = -omega^2 x - 2 zeta omega x' from `start`, at time t >= 0. omega, zeta >= 0; unless omega = 0, which is a free motion,
// it is written so that nothing cancels: with the real roots as r and omega^2/r, and the difference of their exponentials as
// expm1, from far below zeta = 1 to far above [Hairer1993 §I.6].
Motion damped_oscillator(Real omega, Real zeta, Motion start, Real t);

// theta'' = -omega^2 sin theta from `start` (rad, rad/s), at time t: by Jacobi's elliptic functions, for swings and for turns
// over the top [Abramowitz1964 §16.4, §17.6: arithmetic-geometric mean; Carlson1995: the integral of the first kind].
Motion pendulum(Real omega, Motion start, Real t);

// Of one swing of the pendulum with this energy, to and fro, s; of one turn when it goes over the top.
Real pendulum_period(Real omega, Motion start);

}  // namespace pliant::integration
