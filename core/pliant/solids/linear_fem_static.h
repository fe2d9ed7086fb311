// Static equilibrium of a linear elastic body: K u = f where u is free, and u prescribed elsewhere.
#pragma once
#include <pliant/math/conjugate_gradients.h>
#include <pliant/math/constrained_system.h>
#include <pliant/solids/displacement_constraints.h>
#include <pliant/solids/linear_fem.h>

namespace pliant {

// The equations for the free components, for any solver: a system in x, where x holds the free displacements.
template <int Dim>
class StaticProblem {
public:
    // The body outlives this. Throws Refused "singular: k rigid modes unconstrained" when the constraints let the body move.
    StaticProblem(const LinearFem<Dim>& body, const DisplacementConstraints<Dim>& constraints);

    const LinearFem<Dim>& body() const { return *body_; }
    const DisplacementConstraints<Dim>& constraints() const { return constraints_; }
    const ConstrainedSystem& system() const { return system_; }

    // Right side: the given forces (Dim × nodes, N) less those that the prescribed displacements cause.
    void right_side(const Points<Dim>& force, VecX& b) const;
    // All displacements [m] from the free ones.
    void displacement(const VecX& x, Points<Dim>& u) const;
    // A vector over free components as Dim × nodes, 0 where displacements are prescribed.
    void spread(const VecX& reduced, Points<Dim>& full) const;
    // What the supports do: K u - f where a displacement is prescribed, 0 elsewhere [N].
    void reaction(const Points<Dim>& u, const Points<Dim>& force, Points<Dim>& reaction) const;

private:
    const LinearFem<Dim>* body_;
    DisplacementConstraints<Dim> constraints_;
    ConstrainedSystem system_;
};

template <int Dim>
struct StaticSolution {
    Points<Dim> displacement;  // m
    Points<Dim> reaction;      // N
    Real residual = 0;         // |f - K u| / |f| over free components
    Index iterations = 0;      // of conjugate gradients; 0 for the direct solver
};

// By sparse Cholesky factorisation. Throws Refused as StaticProblem does, and Diverged when the factorisation fails.
template <int Dim>
StaticSolution<Dim> solve_static(const LinearFem<Dim>& body, const DisplacementConstraints<Dim>& constraints,
                                 const Points<Dim>& force);
// By conjugate gradients with incomplete Cholesky. Throws Diverged when the tolerance is not reached.
template <int Dim>
StaticSolution<Dim> solve_static(const LinearFem<Dim>& body, const DisplacementConstraints<Dim>& constraints,
                                 const Points<Dim>& force, const ConjugateGradients::Settings& settings);

}  // namespace pliant
