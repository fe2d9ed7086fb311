// How fast a spring net can oscillate, and with it the time steps at which explicit schemes stay stable.
#pragma once
#include <pliant/solids/springs.h>
#include <pliant/time/mass.h>
#include <pliant/time/stability.h>

namespace pliant {

// How fast a net can move near positions x. A net without springs has zeros.
struct SpringRates {
    Real omega = 0;            // rad/s, of the fastest mode
    Real damping = 0;          // 1/s: the largest damping rate 2 zeta omega of a mode
    Real relaxation_time = 0;  // s: smallest damping/stiffness of a spring, 0 when one is undamped
};

// By power iterations on M^-1 K and M^-1 C, each spring counted along its own direction: they approach the largest rates from
// below, those of a lattice within about 1 % after 100 iterations. Curvature across compressed springs is negative and left out:
// it makes buckling, not oscillation.
template <int Dim>
SpringRates spring_rate_estimates(const Springs& springs, const DiagonalMass& mass, SpringDamping mode, PointsIn<Dim> x,
                                  int iterations = 100);

// With one more spring [N/m], from a point in space to a node of this mass [kg]: what it adds to omega^2 is at most its own.
SpringRates with_spring_to(const SpringRates& rates, Real stiffness, Real mass);

// Largest time step that a scheme can be trusted with, s, given a net's rates: semi-implicit Euler needs
// (omega dt)^2 + 2 damping dt <= 4; explicit Euler dt <= relaxation_time and dt <= 2/damping, so none without damping.
Real stability_limit(Scheme scheme, const SpringRates& rates);

}  // namespace pliant
