// Stability of the integrators on the damped oscillator x'' = -omega^2 x - 2 zeta omega x', with every force evaluated as the
// scheme evaluates it. omega: rad/s, >= 0; zeta: damping ratio, >= 0; dt: s.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

enum class Scheme { explicit_euler, semi_implicit_euler, implicit_euler };

// Largest stable dt, s: infinite when every one is. Undamped, explicit Euler has none (0) and semi-implicit Euler 2/omega.
// Damped, explicit Euler has 2 zeta/omega (zeta <= 1) and semi-implicit Euler, whose damping force is explicit,
// (2/omega)(sqrt(1 + zeta^2) - zeta): its limit falls as damping grows.
Real stability_limit(Scheme scheme, Real omega, Real zeta);

// Largest factor by which one step multiplies an amplitude: the spectral radius of the step's matrix. Undamped, with
// w = omega dt: sqrt(1 + w^2) for explicit Euler, 1 (w <= 2) for semi-implicit Euler, 1/sqrt(1 + w^2) for implicit Euler.
Real amplification(Scheme scheme, Real omega, Real zeta, Real dt);

}  // namespace pliant
