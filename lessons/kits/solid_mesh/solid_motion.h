// An elastic body in motion, in the plane or in space, as lessons step it: what ElasticSystem does, with the numbers of Solid.
#pragma once
#include "solid.h"

#include <pliant/solids/elastic_system.h>
#include <pliant/time/time_integrator.h>

namespace pliant::solid_mesh {

// What acts on the nodes from outside.
struct OuterLoad {
    Real gravity = 0;       // m/s², downwards
    MatX force;             // dim × nodes, N, constant; or none
    PullSpring<3> pull;     // of a hand
    Real mass_damping = 0;  // α of −α m v, 1/s
};

class SolidMotion {
public:
    // Body and positions at rest (dim × nodes, m) outlive this. node_mass: kg.
    template <int Dim>
    static std::unique_ptr<SolidMotion> of(const ElasticBody<Dim>& body, const MatX& rest, const VecX& node_mass,
                                           const std::vector<Index>& held);
    virtual ~SolidMotion() = default;

    virtual void set_load(const OuterLoad& load) = 0;
    const DiagonalMass& mass() const { return mass_; }
    TimeIntegrator& integrator() { return *integrator_; }
    const TimeIntegrator& integrator() const { return *integrator_; }

protected:
    explicit SolidMotion(DiagonalMass mass) : mass_(std::move(mass)) {}

    DiagonalMass mass_;
    std::unique_ptr<TimeIntegrator> integrator_;
};

// The mass of each node of a body of first order, kg: an equal share of each of its elements.
VecX lumped_mass(const Solid& solid, Real density);

}  // namespace pliant::solid_mesh
