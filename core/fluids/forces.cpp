#include <pliant/fluids/forces.h>

namespace pliant {

template <int Dim>
void add_uniform_force(const StaggeredGrid<Dim>& grid, FaceField<Dim>& velocity, Real dt, const Vec<Dim>& acceleration) {
    for (int a = 0; a < Dim; ++a) {
        const Real change = dt * acceleration[a];
        if (change == 0) continue;
        // The stretches between closed faces.
        VecX& u = velocity[a];
        Index start = 0;
        for (Index face : grid.closed_faces(a)) {
            u.segment(start, face - start).array() += change;
            start = face + 1;
        }
        u.tail(u.size() - start).array() += change;
    }
}

template void add_uniform_force(const StaggeredGrid<2>&, FaceField<2>&, Real, const Vec<2>&);
template void add_uniform_force(const StaggeredGrid<3>&, FaceField<3>&, Real, const Vec<3>&);

}  // namespace pliant
