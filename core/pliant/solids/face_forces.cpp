#include <pliant/solids/face_forces.h>
#include <Eigen/Geometry>

namespace pliant {

// The gradient of the corner opposite a face points away from it with length 1/height, and area = Dim volume / height.
template <int Dim>
Vec<Dim> rest_face_area(const SimplexMesh<Dim>& mesh, Index element, int opposite) {
    return -Dim * mesh.volumes()[element] * mesh.gradients(element).col(opposite);
}

// In space the columns of the matrix of cofactors are products of two columns of F.
template <int Dim>
Vec<Dim> deformed_face_area(const Mat<Dim>& F, const Vec<Dim>& N) {
    if constexpr (Dim == 2)
        return {F(1, 1) * N[0] - F(1, 0) * N[1], F(0, 0) * N[1] - F(0, 1) * N[0]};
    else
        return N[0] * F.col(1).cross(F.col(2)) + N[1] * F.col(2).cross(F.col(0)) + N[2] * F.col(0).cross(F.col(1));
}

// A node takes part in all faces but the one opposite it, which together carry minus what that one does.
template <int Dim>
void add_shared_face_forces(const SimplexMesh<Dim>& mesh, const Tensors<Dim>& P, Points<Dim>& force) {
    for (Index e = 0; e < mesh.simplex_count(); ++e) {
        const Mat<Dim> stress = tensor<Dim>(P, e);
        for (int opposite = 0; opposite <= Dim; ++opposite) {
            const Vec<Dim> share = face_force<Dim>(mesh, e, opposite, stress) / Dim;
            for (int a = 0; a <= Dim; ++a)
                if (a != opposite) force.col(mesh.simplices()(a, e)) -= share;
        }
    }
}

template <int Dim>
void FaceForceBody<Dim>::internal_force(const Points<Dim>& displacement, Points<Dim>& force) const {
    elements_.stress(displacement, stress_);
    force.setZero(Dim, node_count());
    add_shared_face_forces(elements_.mesh(), stress_, force);
    force = -force;
}

#define PLIANT_INSTANTIATE(Dim)                                                                       \
    template Vec<Dim> rest_face_area(const SimplexMesh<Dim>&, Index, int);                            \
    template Vec<Dim> deformed_face_area(const Mat<Dim>&, const Vec<Dim>&);                           \
    template void add_shared_face_forces(const SimplexMesh<Dim>&, const Tensors<Dim>&, Points<Dim>&); \
    template class FaceForceBody<Dim>
PLIANT_INSTANTIATE(2);
PLIANT_INSTANTIATE(3);
#undef PLIANT_INSTANTIATE

}  // namespace pliant
