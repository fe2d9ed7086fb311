// Finite volumes on simplices [Teran2003]: the stress of each element pulls at its faces, and each face shares its force evenly
// among its nodes.
#pragma once
#include <pliant/continuum/strain.h>
#include <pliant/mesh/simplex_mesh.h>
#include <pliant/solids/hyperelastic_fem.h>

namespace pliant {

// Outward area vector at rest of the face of an element opposite its corner [m^(Dim-1)]. The faces of an element close: these sum
// to 0.
template <int Dim>
Vec<Dim> rest_face_area(const SimplexMesh<Dim>& mesh, Index element, int opposite);

// f_A = P N [N], which the rest of the body exerts on the element through that face: P the first Piola-Kirchhoff stress [Pa], N
// the area vector at rest.
template <int Dim>
Vec<Dim> face_force(const SimplexMesh<Dim>& mesh, Index element, int opposite, const Mat<Dim>& P) {
    return P * rest_face_area(mesh, element, opposite);
}

// a = J F^-T N: the area vector of the same face of the deformed element, of any F. With Cauchy's stress P F^T / J it carries the
// same force, sigma a = P N.
template <int Dim>
Vec<Dim> deformed_face_area(const Mat<Dim>& F, const Vec<Dim>& N);

// Adds to each node the force [N] that its elements exert on it: 1/Dim of that of every face it belongs to, turned round, since
// what pulls at the element pulls back at the nodes; the sum is - V P grad(shape function).
template <int Dim>
void add_shared_face_forces(const SimplexMesh<Dim>& mesh, const Tensors<Dim>& P, Points<Dim>& force);

// The same body with its forces from the faces of its elements. Energy and stiffness are those of the finite elements, whose
// derivatives the forces are too.
template <int Dim>
class FaceForceBody final : public ElasticBody<Dim> {
public:
    // Outlives this.
    explicit FaceForceBody(const HyperelasticFem<Dim>& elements) : elements_(elements) {}

    Index node_count() const override { return elements_.node_count(); }
    void check_support(const DisplacementConstraints<Dim>& constraints) const override { elements_.check_support(constraints); }
    bool is_linear() const override { return elements_.is_linear(); }
    Real energy(const Points<Dim>& displacement) const override { return elements_.energy(displacement); }
    void internal_force(const Points<Dim>& displacement, Points<Dim>& force) const override;
    void stiffness(const Points<Dim>& displacement, bool definite, SparseMatrix& matrix) const override {
        elements_.stiffness(displacement, definite, matrix);
    }
    const SparseMatrix& pattern() const override { return elements_.pattern(); }
    Real admissible_share(const Points<Dim>& displacement, const Points<Dim>& change) const override {
        return elements_.admissible_share(displacement, change);
    }

private:
    const HyperelasticFem<Dim>& elements_;
    mutable Tensors<Dim> stress_;
};

}  // namespace pliant
