// The implicit time integrators of M a = f(x, v) with a mass matrix, each as the ImplicitForm that it gives to an
// ImplicitSolver (implicit.h); the explicit ones are tables (scheme.h), and TimeIntegrator runs both. Degrees of freedom are one
// long vector (see mass.h); a fixed degree of freedom keeps its velocity. Notation: dt time step s, x m, v m/s, f N.
#pragma once
#include <pliant/time/mass.h>

namespace pliant {

// Throws Refused unless dt is positive and finite.
void require_time_step(Real dt);

// What an implicit scheme asks for: the positions x with
//   M acceleration_rate (x - acceleration_origin) = f(x, v),   v = velocity_rate (x - velocity_origin).
// Backward differentiation, the implicit midpoint rule and Newmark's schemes all have this form with other rates and origins.
struct ImplicitForm {
    Real velocity_rate = 0;      // 1/s
    Real acceleration_rate = 0;  // 1/s^2
    VecX velocity_origin;        // m
    VecX acceleration_origin;    // m: where a body that no force acts on would be, and where a fixed one is
    VecX frozen_at;              // m: where the system takes what it freezes for the step
    VecX lower_bound;            // m: no position goes below; empty when there is no bound
};

// Implicit (backward) Euler: v' = v + dt M^-1 f(x', v'), x' = x + dt v'. The solution's x and v are those of the new time.
void implicit_euler(Real dt, ConstDofs x, ConstDofs v, ImplicitForm& form);

// Implicit midpoint rule: the solution is the middle of the step, x_m = x + dt/2 v_m with v_m = v + dt/2 M^-1 f(x_m, v_m). The
// new time has x' = 2 x_m - x, v' = 2 v_m - v [Hairer2006 §II.1.3].
void implicit_midpoint(Real dt, ConstDofs x, ConstDofs v, ImplicitForm& form);

// Newmark's scheme with beta = 1/4, gamma = 1/2 (average acceleration): x' = x + dt v + dt^2 (a + a')/4, v' = v + dt (a + a')/2,
// with the acceleration a of the start, m/s^2 [Newmark1959].
void newmark(Real dt, ConstDofs x, ConstDofs v, const VecX& a, ImplicitForm& form);

// Backward differentiation of second order, from the state before the start, at a step of dt_before [Hairer1993 §III.5]: with
// r = dt/dt_before, both x and v fulfil y' = ((1 + r)^2 y - r^2 y_before)/(1 + 2r) + dt (1 + r)/(1 + 2r) dy'/dt.
void bdf2(Real dt, Real dt_before, ConstDofs x, ConstDofs v, ConstDofs x_before, ConstDofs v_before, ImplicitForm& form);

}  // namespace pliant
