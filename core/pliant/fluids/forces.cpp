#include <pliant/fluids/forces.h>
#include <pliant/math/error.h>

#include <cmath>

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

template <int Dim>
void add_jet(const StaggeredGrid<Dim>& grid, FaceField<Dim>& velocity, Real dt, const Vec<Dim>& centre, Real radius,
             const Vec<Dim>& acceleration) {
    if (!(radius > 0)) throw Refused("radius", radius, "m", "a length above 0");
    constexpr Real reach = 16;  // squared, in radii
    // Squared distance from the centre along an axis, in radii, of a place in cells.
    const auto square = [&](int axis, Real place) {
        Real d = place * grid.dx() - centre[axis];
        const Real period = static_cast<Real>(grid.cell_counts()[axis]) * grid.dx();
        if (grid.periodic(axis)) d -= period * std::round(d / period);
        return d * d / (radius * radius);
    };
    for (int a = 0; a < Dim; ++a) {
        if (acceleration[a] == 0) continue;
        const Lattice<Dim>& faces = grid.faces(a);
        const bool walled = !grid.periodic(a);
        const Index first = walled && a == 0 ? 1 : 0, end = faces.count[0] - first;
        parallel_for_each_row(faces, [&](Index start, const Counts<Dim>& at, int) {
            // A row on a wall is closed, and most rows are out of reach.
            if (walled && a != 0 && (at[a] == 0 || at[a] == faces.count[a] - 1)) return;
            const GridPlace<Dim> place = faces.place(at);
            Real across = 0;
            for (int b = 1; b < Dim; ++b) across += square(b, place[b]);
            if (across > reach) return;
            for (Index i = first; i < end; ++i) {
                const Real r2 = across + square(0, place[0] + static_cast<Real>(i));
                if (r2 > reach || (grid.has_gaps() && grid.openness(a)[start + i] == 0)) continue;
                velocity[a][start + i] += dt * acceleration[a] * std::exp(Real(-0.5) * r2);
            }
        });
    }
}

template <int Dim>
void add_buoyancy(const StaggeredGrid<Dim>& grid, FaceField<Dim>& velocity, Real dt, int axis, Real acceleration,
                  const VecX& quantity) {
    const std::vector<Index>& closed = grid.closed_faces(axis);
    auto next_closed = closed.begin();
    for (Index face = 0; face < velocity[axis].size(); ++face) {
        if (next_closed != closed.end() && *next_closed == face) {
            ++next_closed;
            continue;
        }
        const Real mean = Real(0.5) * (quantity[grid.cell_beside(axis, face, 0)] + quantity[grid.cell_beside(axis, face, 1)]);
        velocity[axis][face] += dt * (acceleration * mean);
    }
}

template void add_jet(const StaggeredGrid<2>&, FaceField<2>&, Real, const Vec<2>&, Real, const Vec<2>&);
template void add_jet(const StaggeredGrid<3>&, FaceField<3>&, Real, const Vec<3>&, Real, const Vec<3>&);
template void add_uniform_force(const StaggeredGrid<2>&, FaceField<2>&, Real, const Vec<2>&);
template void add_uniform_force(const StaggeredGrid<3>&, FaceField<3>&, Real, const Vec<3>&);
template void add_buoyancy(const StaggeredGrid<2>&, FaceField<2>&, Real, int, Real, const VecX&);
template void add_buoyancy(const StaggeredGrid<3>&, FaceField<3>&, Real, int, Real, const VecX&);

}  // namespace pliant
