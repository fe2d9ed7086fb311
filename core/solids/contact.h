// Contact of nodes with a level ground, as a stage of its own after integration. The second coordinate is up.
#pragma once
#include <pliant/solids/springs.h>
#include <pliant/time/implicit.h>

#include <span>
#include <vector>

namespace pliant {

struct Ground {
    Real height = 0;       // m
    Real restitution = 0;  // rebound speed over impact speed, 0 (inelastic) to 1
    Real friction = 0.5;   // Coulomb's coefficient, >= 0
};

// Throws Refused, naming the number.
void require_valid(const Ground& ground);

// How a node meets the ground: not at all; held above it while integrating, with a speed taken from it; or below it.
enum class Touch : char { none, arrested, below };
// arrested: as below. Fixed nodes touch nothing.
template <int Dim>
Touch touch_of(const Ground& ground, const DiagonalMass& mass, PointsIn<Dim> x, std::span<const Real> arrested, Index node);

// Puts every node below the ground back onto it. A node that moves down rebounds with `restitution` of its speed, and friction
// takes at most `friction` times the normal change of velocity from the speed along the ground, and never reverses it
// [Bridson2002]. Where friction changes a velocity, the distance that it had moved the node during `moved_for` seconds
// changes with it: the time step for semi-implicit Euler, so that a node that sticks does not creep; 0 for explicit Euler, which
// has not moved with that velocity, and for implicit schemes, whose stiff springs a moved node would load. arrested: speed that
// the ground already took from each node while integrating, m/s, or empty. Fixed nodes are left alone. Returns how many
// nodes touched.
template <int Dim>
Index resolve_ground_contact(const Ground& ground, const DiagonalMass& mass, Real moved_for, PointsOut<Dim> x, PointsOut<Dim> v,
                             std::span<const Real> arrested = {});

// The ground as lower bounds of an implicit step, which then ends on it with its forces in balance: positions set right
// afterwards would load stiff springs with energy from nowhere. Nodes that are already below the ground may stay.
template <int Dim>
void set_ground_bounds(const Ground& ground, PointsIn<Dim> x, VecX& lower_bound);

// Speed that the ground took from each node in an implicit step of such bounds, m/s: dt times reaction over mass.
template <int Dim>
void arrested_speeds(const ImplicitSolver& solver, const DiagonalMass& mass, Real dt, std::vector<Real>& arrested);

}  // namespace pliant
