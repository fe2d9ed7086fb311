// External forces: the body force per unit mass, scaled by the time step and added to the velocity [Stam1999 §2.2].
#pragma once
#include <pliant/fluids/parallel_rows.h>
#include <pliant/fluids/staggered_grid.h>

#include <algorithm>

namespace pliant {

// velocity += Δt f on the open faces, where f, which several threads may call at once, maps a place (metres from the corner of
// the domain) to an acceleration, m/s². For gravity f is g: a force per unit mass, not ρg, which is one per unit volume.
template <int Dim, class Acceleration>
void add_force(const StaggeredGrid<Dim>& grid, FaceField<Dim>& velocity, Real dt, Acceleration&& f) {
    for (int a = 0; a < Dim; ++a) {
        const Lattice<Dim>& faces = grid.faces(a);
        const std::vector<Index>& closed = grid.closed_faces(a);
        parallel_for_each_row(faces, [&](Index start, const Counts<Dim>& at, int) {
            auto next_closed = std::lower_bound(closed.begin(), closed.end(), start);
            const GridPlace<Dim> first = faces.place(at);
            Vec<Dim> x;
            for (int b = 0; b < Dim; ++b) x[b] = first[b] * grid.dx();
            for (Index i = 0; i < faces.count[0]; ++i) {
                if (next_closed != closed.end() && *next_closed == start + i) {
                    ++next_closed;
                    continue;
                }
                x[0] = (first[0] + static_cast<Real>(i)) * grid.dx();
                const Vec<Dim> acceleration = f(static_cast<const Vec<Dim>&>(x));
                velocity[a][start + i] += dt * acceleration[a];
            }
        });
    }
}

// The same acceleration everywhere, m/s². A component of 0 costs nothing.
template <int Dim>
void add_uniform_force(const StaggeredGrid<Dim>& grid, FaceField<Dim>& velocity, Real dt, const Vec<Dim>& acceleration);

// A jet: the acceleration times exp(−r²/(2 radius²)) at the distance r from `centre` (metres from the corner of the domain), and
// nothing beyond four radii. Along a periodic axis the nearest image of the centre counts. Throws Refused for a radius that is
// not above 0.
template <int Dim>
void add_jet(const StaggeredGrid<Dim>& grid, FaceField<Dim>& velocity, Real dt, const Vec<Dim>& centre, Real radius,
             const Vec<Dim>& acceleration);

// Buoyancy: along `axis`, the acceleration times the mean of a cell-centred quantity on the two sides of each open face, m/s² for
// a quantity of 1.
template <int Dim>
void add_buoyancy(const StaggeredGrid<Dim>& grid, FaceField<Dim>& velocity, Real dt, int axis, Real acceleration,
                  const VecX& quantity);

extern template void add_jet(const StaggeredGrid<2>&, FaceField<2>&, Real, const Vec<2>&, Real, const Vec<2>&);
extern template void add_jet(const StaggeredGrid<3>&, FaceField<3>&, Real, const Vec<3>&, Real, const Vec<3>&);
extern template void add_uniform_force(const StaggeredGrid<2>&, FaceField<2>&, Real, const Vec<2>&);
extern template void add_uniform_force(const StaggeredGrid<3>&, FaceField<3>&, Real, const Vec<3>&);
extern template void add_buoyancy(const StaggeredGrid<2>&, FaceField<2>&, Real, int, Real, const VecX&);
extern template void add_buoyancy(const StaggeredGrid<3>&, FaceField<3>&, Real, int, Real, const VecX&);

}  // namespace pliant
