// Stability of the integrators on the damped oscillator x'' = -omega^2 x - 2 zeta omega x', with every force evaluated as the
// scheme evaluates it. omega: rad/s, >= 0; zeta: damping ratio, >= 0; dt: s.
#pragma once
#include <pliant/time/scheme.h>

#include <string>

namespace pliant {

// Largest stable dt, s: infinite when every one is. Undamped: none for explicit Euler (0), 2/omega for semi-implicit Euler and
// velocity Verlet, 2 sqrt(2)/omega for Runge–Kutta 4. Damped, explicit Euler has 2 zeta/omega up to zeta = 1 and beyond it
// (2/omega)(zeta - sqrt(zeta^2 - 1)), set by the faster of its two decays. Semi-implicit Euler, whose damping force is
// explicit, has (2/omega)(sqrt(1 + zeta^2) - zeta): its limit falls as damping grows, and is the smaller of the two from
// zeta = 1/sqrt(3) on. Those of velocity Verlet and Runge–Kutta 4 are found as the first dt at which the amplification passes 1.
Real stability_limit(Scheme scheme, Real omega, Real zeta);
// The scheme and, where it has one, the formula of its limit: "semi-implicit Euler, (2/ω)(√(1 + ζ²) − ζ)".
std::string limit_in_words(Scheme scheme);

// Largest factor by which one step multiplies an amplitude: the spectral radius of the step's matrix. Undamped, with
// w = omega dt: sqrt(1 + w^2) for explicit Euler, 1 (w <= 2) for semi-implicit Euler and velocity Verlet, 1/sqrt(1 + w^2) for
// implicit Euler, 1 for the midpoint rule and Newmark's. Here zeta may go down to -1: an oscillator that is driven, so that
// the roots -zeta w +- i w sqrt(1 - zeta^2) reach every point of the complex plane.
Real amplification(Scheme scheme, Real omega, Real zeta, Real dt);

// Does the scheme take energy out of an oscillation that nothing damps, if its steps are long enough?
bool dissipates(Scheme scheme);

// Part of the energy of its motion by which a run may come to exceed what it began with, though the time step is stable:
// symplectic schemes let the energy swing about its mean, between bounds that hold for ever [Hairer2006 §IX.3]. w = omega dt, of
// the fastest mode. 0 where energy is kept or lost; nonlinear forces let it swing by the order of the scheme.
Real energy_excess(Scheme scheme, Real w, bool linear, bool damped);

// By how much one step turns the oscillation in the plane of x and v, rad, from 0 to pi: omega dt for the motion itself without
// damping. pi where the steps alternate in sign.
Real phase_per_step(Scheme scheme, Real omega, Real zeta, Real dt);

}  // namespace pliant
