// Loads from outside on the nodes of a body of any kind: gravity, and a hand that pulls.
#pragma once
#include <pliant/solids/springs.h>

namespace pliant {

// A spring of rest length 0 from a node to a point in space, as a hand pulls.
template <int Dim>
struct PullSpring {
    Index node = -1;                     // none when negative
    Vec<Dim> target = Vec<Dim>::Zero();  // m
    Real stiffness = 0;                  // N/m

    bool active() const { return node >= 0 && stiffness > 0; }
    Vec<Dim> force(const Vec<Dim>& x) const { return stiffness * (target - x); }                   // N
    Real energy(const Vec<Dim>& x) const { return 0.5 * stiffness * (target - x).squaredNorm(); }  // J
};

// Loads on the nodes from outside of the body.
template <int Dim>
struct ExternalLoad {
    Vec<Dim> gravity = Vec<Dim>::Zero();  // m/s^2
    PullSpring<Dim> pull;
};

// f_i += m_i g, and the pull on its node, N. mass: kg, one per node.
template <int Dim>
void add_external_forces(const ExternalLoad<Dim>& load, const VecX& mass, PointsIn<Dim> x, PointsOut<Dim> f);

// Potential of those forces, J.
template <int Dim>
Real external_energy(const ExternalLoad<Dim>& load, const VecX& mass, PointsIn<Dim> x);

}  // namespace pliant
