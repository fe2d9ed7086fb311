// Elastic bodies of linear finite elements under any energy density [Sifakis2012 §4]: the energy of the body is the sum of
// V psi(F) over its elements, F = I + du/dX being constant in each.
#pragma once
#include <pliant/continuum/energy_density.h>
#include <pliant/continuum/strain.h>
#include <pliant/math/element_assembly.h>
#include <pliant/mesh/simplex_mesh.h>

#include <vector>

namespace pliant {

// Displacements and forces are Dim × nodes; component k of node a is unknown Dim a + k of the stiffness matrix. In 2D: plane
// strain, per metre of thickness.
template <int Dim>
class HyperelasticFem {
public:
    static constexpr int corners = Dim + 1;
    using ElementMatrix = Mat<Dim * corners>;

    // The mesh outlives this. One material for all elements, or one for each. Throws Refused, naming the element, for a material
    // that is not stable.
    HyperelasticFem(const SimplexMesh<Dim>& mesh, Energy energy, const Lame& material);
    HyperelasticFem(const SimplexMesh<Dim>& mesh, Energy energy, const std::vector<Lame>& materials);

    const SimplexMesh<Dim>& mesh() const { return *mesh_; }
    const EnergyDensity<Dim>& density(Index element) const { return densities_[static_cast<std::size_t>(element)]; }

    Mat<Dim> deformation_gradient(Index element, const Points<Dim>& displacement) const;
    // First Piola-Kirchhoff stress [Pa]. Throws Diverged, naming the element, where the energy does not admit its F.
    void stress(const Points<Dim>& displacement, Tensors<Dim>& P) const;

    // Energy of the body [J]; infinite where an element's F is not admitted.
    Real energy(const Points<Dim>& displacement) const;
    // Its derivative [N]: node a of an element takes V P g_a, g the gradients of the shape functions. Throws as stress does.
    void internal_force(const Points<Dim>& displacement, Points<Dim>& force) const;
    // Its second derivative [N/m]. With `definite` the tangent of each element loses its negative eigenvalues, so that the matrix
    // is positive semi-definite and Newton's direction goes downhill [Teran2005 §6]. `matrix` has the pattern.
    void stiffness(const Points<Dim>& displacement, bool definite, SparseMatrix& matrix) const;
    const SparseMatrix& pattern() const { return assembly_.pattern(); }

    // The share, at most 1, of a change of the displacements [m] that can be made without turning an element inside out on the
    // way: F + s dF stays invertible up to s = 1/|F^-1 dF|. A margin is left. 1 for elements whose energy admits every F. The
    // displacements themselves are admitted.
    Real admissible_share(const Points<Dim>& displacement, const Points<Dim>& change) const;

private:
    ElementMatrix element_stiffness(Index element, const Points<Dim>& displacement, bool definite) const;

    const SimplexMesh<Dim>* mesh_;
    std::vector<EnergyDensity<Dim>> densities_;
    ElementAssembly<Dim, corners> assembly_;
};

}  // namespace pliant
