// A body in motion, in the plane or in space: one face for both.
#pragma once
#include "kits/solid_mesh/solid.h"

#include <pliant/solids/contact.h>
#include <pliant/time/time_integrator.h>

#include <memory>

namespace pliant::fem {

// What acts on it in a step.
struct Acting {
    MatX load;                                     // N, constant, dim × nodes
    Real gravity = 0;                              // m/s², downwards
    Real mass_damping = 0, stiffness_damping = 0;  // α [1/s], β [s]
    Index pulled = -1;                             // node, or none
    Vec<3> target = Vec<3>::Zero();                // m, of the hand
    Real pull_stiffness = 0;                       // N/m
    bool ground = false;                           // a floor at y = 0
    Real friction = 0;
};

class Motion {
public:
    virtual ~Motion() = default;

    virtual void follow(const Acting& acting) = 0;
    // Of all forces at a place and velocity (dim × nodes), N.
    virtual MatX force(const MatX& x, const MatX& v) = 0;
    // Elastic energy, and that of all that acts from outside, J.
    virtual Real potential(const MatX& x) = 0;

    // A step, pass by pass. force: at the start [N].
    virtual void begin(Scheme scheme, Real dt, const MatX& x, const MatX& v, const MatX& force, const NewtonOptions& options) = 0;
    virtual bool again() const = 0;
    virtual void pass(MatX& x, MatX& v) = 0;  // to where the pass has led
    virtual void finish(MatX& x, MatX& v) = 0;
    // After it: nodes on the ground stay there, and rub. How many.
    virtual Index meet_ground(MatX& x, MatX& v) = 0;
    virtual Touch touch(Index node) const = 0;

    virtual const TimeIntegrator& integrator() const = 0;
    virtual const Mass& mass() const = 0;
    virtual const VecX& node_mass() const = 0;  // kg, what gravity acts on
};

// Nodes that the solid holds stay where they are; it outlives this. A ground needs lumped masses.
std::unique_ptr<Motion> make_motion(const solid_mesh::Solid& solid, std::unique_ptr<Mass> mass);

}  // namespace pliant::fem
