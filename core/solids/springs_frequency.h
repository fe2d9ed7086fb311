// How fast a spring net can oscillate, and with it the time steps at which explicit schemes stay stable.
#pragma once
#include <pliant/solids/springs.h>
#include <pliant/time/mass.h>
#include <pliant/time/stability.h>

namespace pliant {

// Rates that bound a net's motion near positions x. A net without springs has zeros.
struct SpringRates {
    Real omega = 0;            // rad/s: no mode oscillates faster
    Real damping = 0;          // 1/s: no mode's damping rate 2 zeta omega is larger
    Real relaxation_time = 0;  // s: smallest damping/stiffness of a spring, 0 when one is undamped
};

// Rigorous bounds from every node's springs (Gershgorin discs of M^-1 K and M^-1 C by nodes, each spring counted along its own
// direction): omega^2 <= max_i 2 |sum_j K_ij| / m_i, where a fixed neighbour counts once instead of twice. Curvature across
// compressed springs is negative and left out: it makes buckling, not oscillation. One pass over the springs.
template <int Dim>
SpringRates spring_rate_bounds(const Springs& springs, const DiagonalMass& mass, SpringDamping mode, PointsIn<Dim> x);

// The same rates by power iterations on M^-1 K and M^-1 C: they approach the largest ones from below, those of a lattice within
// about 1 % after 100 iterations, and so make sharper estimates but no bounds.
template <int Dim>
SpringRates spring_rate_estimates(const Springs& springs, const DiagonalMass& mass, SpringDamping mode, PointsIn<Dim> x,
                                  int iterations = 100);

// Largest time step that a scheme can be trusted with, s, given a net's rates: semi-implicit Euler needs
// (omega dt)^2 + 2 damping dt <= 4; explicit Euler dt <= relaxation_time and dt <= 2/damping, so none without damping.
Real stability_limit(Scheme scheme, const SpringRates& rates);

}  // namespace pliant
