// Linear elasticity with linear finite elements: triangles (per metre of thickness) or tetrahedra [Hughes2000 §2.7-§2.9].
#pragma once
#include <pliant/continuum/moduli.h>
#include <pliant/continuum/strain.h>
#include <pliant/math/element_assembly.h>
#include <pliant/mesh/simplex_mesh.h>

#include <vector>

namespace pliant {

// Displacements and forces are Dim × nodes; component k of node a is unknown Dim a + k of the stiffness matrix.
template <int Dim>
class LinearFem {
public:
    static constexpr int corners = Dim + 1;
    using ElementMatrix = Mat<Dim * corners>;

    // The mesh outlives this. One material for all elements, or one for each. In 2D IsotropicModuli::lame() gives plane strain
    // and plane_stress_lame() plane stress. Throws Refused, naming the element, for a material that is not stable.
    LinearFem(const SimplexMesh<Dim>& mesh, const Lame& material);
    LinearFem(const SimplexMesh<Dim>& mesh, std::vector<Lame> materials);

    const SimplexMesh<Dim>& mesh() const { return *mesh_; }
    const Lame& material(Index element) const { return materials_[static_cast<std::size_t>(element)]; }

    // K [N/m], symmetric to the bit, with every rigid motion in its null space.
    const SparseMatrix& stiffness() const { return stiffness_; }
    // See linear_element.h.
    ElementMatrix element_stiffness(Index element) const;

    // Strain and stress [Pa] of one element or of all; constant in each.
    Mat<Dim> element_strain(Index element, const Points<Dim>& displacement) const;
    Mat<Dim> element_stress(Index element, const Points<Dim>& displacement) const;
    void strain(const Points<Dim>& displacement, Tensors<Dim>& strain) const;
    void stress(const Points<Dim>& displacement, Tensors<Dim>& stress) const;

    // K u [N], summed element by element without the matrix: node a of an element takes V stress g_a.
    void internal_force(const Points<Dim>& displacement, Points<Dim>& force) const;
    // Half the integral of strain : stress [J].
    Real strain_energy(const Points<Dim>& displacement) const;

private:
    void assemble();

    const SimplexMesh<Dim>* mesh_;
    std::vector<Lame> materials_;
    ElementAssembly<Dim, corners> assembly_;
    SparseMatrix stiffness_;
};

}  // namespace pliant
