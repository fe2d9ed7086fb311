// Stability of the integrators on the damped oscillator x'' = -omega^2 x - 2 zeta omega x', with every force evaluated as the
// scheme evaluates it. omega: rad/s, >= 0; zeta: damping ratio, >= 0; dt: s.
#pragma once
#include <pliant/time/scheme.h>

namespace pliant {

// Largest stable dt, s: infinite when every one is. Undamped: none for explicit Euler (0), 2/omega for semi-implicit Euler and
// velocity Verlet, 2 sqrt(2)/omega for Runge–Kutta 4. Damped, explicit Euler has 2 zeta/omega (zeta <= 1) and semi-implicit
// Euler, whose damping force is explicit, (2/omega)(sqrt(1 + zeta^2) - zeta): its limit falls as damping grows. Those of
// velocity Verlet and Runge–Kutta 4 are found as the first dt at which the amplification passes 1.
Real stability_limit(Scheme scheme, Real omega, Real zeta);

// Largest factor by which one step multiplies an amplitude: the spectral radius of the step's matrix. Undamped, with
// w = omega dt: sqrt(1 + w^2) for explicit Euler, 1 (w <= 2) for semi-implicit Euler and velocity Verlet, 1/sqrt(1 + w^2) for
// implicit Euler, 1 for the midpoint rule and Newmark's. Here zeta may go down to -1: an oscillator that is driven, so that
// the roots -zeta w +- i w sqrt(1 - zeta^2) reach every point of the complex plane.
Real amplification(Scheme scheme, Real omega, Real zeta, Real dt);

// By how much one step turns the oscillation in the plane of x and v, rad, from 0 to pi: omega dt for the motion itself without
// damping. pi where the steps alternate in sign.
Real phase_per_step(Scheme scheme, Real omega, Real zeta, Real dt);

}  // namespace pliant
