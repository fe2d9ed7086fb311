// What static and implicit solvers need to know of an elastic body, whatever it is made of. Displacements and forces are Dim ×
// nodes; component k of node a is unknown Dim a + k of the stiffness matrix.
#pragma once
#include <pliant/solids/displacement_constraints.h>

namespace pliant {

template <int Dim>
class ElasticBody {
public:
    virtual ~ElasticBody() = default;

    virtual Index node_count() const = 0;
    // Throws Refused "singular: k rigid modes unconstrained" where the constraints leave the body free to move.
    virtual void check_support(const DisplacementConstraints<Dim>& constraints) const = 0;

    // Is the force linear in the displacements? The stiffness is then the same everywhere.
    virtual bool is_linear() const { return false; }

    // Energy of the body [J]; infinite where an element's F is not admitted.
    virtual Real energy(const Points<Dim>& displacement) const = 0;
    // Size of the terms that the energy is the sum of where they cancel, at rest above all [J]: rounding leaves a part of it.
    virtual Real energy_scale() const { return 0; }
    // Its derivative [N]. Throws Diverged, naming the element, where the energy does not admit its F.
    virtual void internal_force(const Points<Dim>& displacement, Points<Dim>& force) const = 0;
    // Its second derivative [N/m]. With `definite` the tangent of each element loses its negative eigenvalues, so that the matrix
    // is positive semi-definite and Newton's direction goes downhill [Teran2005 §6]. `matrix` has the pattern.
    virtual void stiffness(const Points<Dim>& displacement, bool definite, SparseMatrix& matrix) const = 0;
    virtual const SparseMatrix& pattern() const = 0;

    // The share, at most 1, of a change of the displacements [m] that can be made without turning an element inside out on the
    // way: F + s dF stays invertible up to s = 1/|F^-1 dF|. A margin is left. 1 for elements whose energy admits every F. The
    // displacements themselves are admitted.
    virtual Real admissible_share(const Points<Dim>& displacement, const Points<Dim>& change) const = 0;
};

}  // namespace pliant
