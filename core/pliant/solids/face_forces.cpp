#include <pliant/solids/face_forces.h>

namespace pliant {

// The gradient of the corner opposite a face points away from it with length 1/height, and area = Dim volume / height.
template <int Dim>
Vec<Dim> rest_face_area(const SimplexMesh<Dim>& mesh, Index element, int opposite) {
    return -Dim * mesh.volumes()[element] * mesh.gradients(element).col(opposite);
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

#define PLIANT_INSTANTIATE(Dim)                                            \
    template Vec<Dim> rest_face_area(const SimplexMesh<Dim>&, Index, int); \
    template void add_shared_face_forces(const SimplexMesh<Dim>&, const Tensors<Dim>&, Points<Dim>&)
PLIANT_INSTANTIATE(2);
PLIANT_INSTANTIATE(3);
#undef PLIANT_INSTANTIATE

}  // namespace pliant
