// Contact of nodes with a level ground, as a stage of its own after integration. The second coordinate is up.
#pragma once
#include <pliant/solids/springs.h>
#include <pliant/time/time_integrator.h>

#include <functional>
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

// How a node comes to the ground in one step. Speeds and accelerations count downwards.
struct Approach {
    Real height = 0;      // above the ground at the start, m, >= 0
    Real speed = 0;       // at the start, m/s
    Real free_speed = 0;  // at the end if there were no ground, m/s
    Real dt = 0;          // s
    // Semi-implicit Euler's velocities are those of the middle of the step that has led to a place: half a step late. Then also
    // the acceleration on the ground is needed, m/s^2.
    bool late = false;
    Real acceleration_there = 0;

    Real acceleration() const { return (free_speed - speed) / dt; }  // on the way, m/s^2
    Real speed_at_start() const { return late ? speed + dt / 2 * acceleration() : speed; }
    // With which it meets the ground, m/s: w^2 = u^2 + 2 h a, 0 where it would not reach it. The ground may be met anywhere in
    // the step, and a scheme that holds the node there has by then taken any part of the speed; this is the speed that the work
    // of the forces on the way down leaves, so that a node of restitution 1 keeps its energy.
    Real impact() const;
    // Velocity with which it leaves, m/s, upwards. A late one includes half a step of what pulls it back; where that would be on
    // the ground again within a step, it stays.
    Real rebound(Real restitution) const;
};

// begin() before a step, resolve() after it.
template <int Dim>
class GroundContact {
public:
    // Of the system, N, one long vector.
    using ForceAt = std::function<void(ConstDofs x, ConstDofs v, Dofs force)>;

    void begin(Real dt, PointsIn<Dim> x, PointsIn<Dim> v);
    // After an implicit step with set_ground_bounds(): the speed that the ground took from each node, m/s, the impulse of its
    // reaction over mass.
    void arrest(const TimeIntegrator& integrator, const DiagonalMass& mass);

    // Sets every node that touches the ground onto it. It leaves with `restitution` of its speed of impact, and friction takes
    // at most `friction` times the normal change of velocity from the speed along the ground, and never reverses it
    // [Bridson2002]. Where friction changes a velocity with which semi-implicit Euler has already moved the node, that way
    // changes with it, so that a node that sticks does not creep. Fixed nodes are left alone. force: asked where velocities are
    // late and a node touches. Returns how many nodes touched.
    Index resolve(const Ground& ground, const DiagonalMass& mass, Scheme scheme, const ForceAt& force, PointsOut<Dim> x,
                  PointsOut<Dim> v);

    // Of the latest step.
    const Points<Dim>& start() const { return start_x_; }  // m
    const std::vector<Real>& arrested() const { return arrested_; }
    Touch touch(Index node) const { return touches_[static_cast<std::size_t>(node)]; }
    const Approach& approach(Index node) const { return approaches_[static_cast<std::size_t>(node)]; }

private:
    Touch touch_of(const Ground& ground, const DiagonalMass& mass, PointsIn<Dim> x, Index node) const;
    Real taken(Index node) const { return arrested_.empty() ? 0 : arrested_[static_cast<std::size_t>(node)]; }

    Real dt_ = 0;
    Points<Dim> start_x_, start_v_;
    std::vector<Real> arrested_;  // empty for explicit steps
    std::vector<Touch> touches_;
    std::vector<Approach> approaches_;
    VecX force_;
};

// The ground as lower bounds of an implicit step, which then ends on it with its forces in balance: positions set right
// afterwards would load stiff springs with energy from nowhere. Nodes that are already below the ground may stay.
template <int Dim>
void set_ground_bounds(const Ground& ground, PointsIn<Dim> x, VecX& lower_bound);

}  // namespace pliant
