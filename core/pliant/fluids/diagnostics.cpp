#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/parallel_rows.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

// Face rows below and above the row of cells that starts at `at`, across `axis` other than 0.
template <int Dim>
std::array<Index, 2> face_rows(const StaggeredGrid<Dim>& grid, Counts<Dim> at, int axis) {
    const Lattice<Dim>& faces = grid.faces(axis);
    const Index low = faces.index(at);
    at[axis] = (at[axis] + 1) % faces.count[axis];
    return {low, faces.index(at)};
}

// Calls body(row of cells, its coordinates, its row of faces across axis 0) for every row of cells.
template <int Dim, class Body>
void for_each_cell_row(const StaggeredGrid<Dim>& grid, Body&& body) {
    const Index faces_along = grid.faces(0).count[0], cells_along = grid.cells().count[0];
    parallel_for_each_row(grid.cells(),
                          [&](Index start, const Counts<Dim>& at, int) { body(start, at, start / cells_along * faces_along); });
}

// out = high − low (or high + low) of the faces across axis 0.
void difference_along(const Real* faces, Index cells, bool periodic, Eigen::Ref<VecX> out) {
    const Index inner = periodic ? cells - 1 : cells;
    out.head(inner) = Eigen::Map<const VecX>(faces + 1, inner) - Eigen::Map<const VecX>(faces, inner);
    if (periodic) out[cells - 1] = faces[0] - faces[cells - 1];
}

}  // namespace

template <int Dim>
void divergence(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity, VecX& out) {
    const Index n = grid.cells().count[0];
    const Real inverse_dx = 1 / grid.dx();
    out.resize(grid.cells().size());
    for_each_cell_row(grid, [&](Index start, const Counts<Dim>& at, Index faces) {
        auto row = out.segment(start, n);
        difference_along(velocity[0].data() + faces, n, grid.periodic(0), row);
        for (int a = 1; a < Dim; ++a) {
            const auto [low, high] = face_rows<Dim>(grid, at, a);
            row += velocity[a].segment(high, n) - velocity[a].segment(low, n);
        }
        row *= inverse_dx;
    });
    if (!grid.has_gaps()) return;
    for (Index c = 0; c < out.size(); ++c)
        if (!grid.is_fluid(c)) out[c] = 0;
}

template <int Dim>
Real max_divergence(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity) {
    VecX div;
    divergence(grid, velocity, div);
    return div.cwiseAbs().maxCoeff();
}

template <int Dim>
Real inner_product(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& u, const FaceField<Dim>& v) {
    Real sum = 0;
    for (int a = 0; a < Dim; ++a) {
        sum += u[a].dot(v[a]);
        // Take back what the closed faces do not have: half of the volume on a wall, all of it inside a solid.
        const std::vector<Index>& closed = grid.closed_faces(a);
        for (std::size_t k = 0; k < closed.size(); ++k)
            sum -= (1 - Real(0.5) * grid.fluid_beside_closed(a)[k]) * u[a][closed[k]] * v[a][closed[k]];
        // Half of the volume at a surface is air.
        for (const Index face : grid.surface_faces(a)) sum -= Real(0.5) * u[a][face] * v[a][face];
    }
    return grid.cell_volume() * sum;
}

template <int Dim>
Real kinetic_energy(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity) {
    return Real(0.5) * inner_product(grid, velocity, velocity);
}

template <int Dim>
Real max_speed(const FaceField<Dim>& velocity) {
    Real speed = 0;
    for (const VecX& u : velocity.components) speed = std::max(speed, parallel_max_norm(u));
    return speed;
}

template <int Dim>
Real courant_number(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity, Real dt) {
    return max_speed(velocity) * dt / grid.dx();
}

template <int Dim>
void cell_velocity(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity, Points<Dim>& out) {
    const Index n = grid.cells().count[0];
    out.resize(Dim, grid.cells().size());
    for_each_cell_row(grid, [&](Index start, const Counts<Dim>& at, Index faces) {
        for (Index i = 0; i < n; ++i) {
            const Index next = i + 1 < grid.faces(0).count[0] ? i + 1 : 0;
            out(0, start + i) = Real(0.5) * (velocity[0][faces + i] + velocity[0][faces + next]);
        }
        for (int a = 1; a < Dim; ++a) {
            const auto [low, high] = face_rows<Dim>(grid, at, a);
            out.row(a).segment(start, n) = Real(0.5) * (velocity[a].segment(low, n) + velocity[a].segment(high, n)).transpose();
        }
    });
}

void vorticity(const StaggeredGrid<2>& grid, const VelocitySampler<2>& flow, VecX& out) {
    const PaddedField<2>&u = flow.component(0), &v = flow.component(1);
    const Index n = grid.cells().count[0];
    const Real quarter = Real(0.25) / grid.dx();
    out.resize(grid.cells().size());
    for_each_row(grid.cells(), [&](Index start, const Counts<2>& at) {
        const Real* ur = u.data() + u.position(at);
        const Real* vr = v.data() + v.position(at);
        const Index up = u.stride(1), vp = v.stride(1);
        for (Index i = 0; i < n; ++i) {
            // Summed over the four corners, the differences across the corner's own faces leave those one cell further out.
            const Real dv = (vr[i + 1] - vr[i - 1]) + (vr[i + 1 + vp] - vr[i - 1 + vp]);
            const Real du = (ur[i + up] - ur[i - up]) + (ur[i + 1 + up] - ur[i + 1 - up]);
            out[start + i] = quarter * (dv - du);
        }
    });
}

template void divergence(const StaggeredGrid<2>&, const FaceField<2>&, VecX&);
template void divergence(const StaggeredGrid<3>&, const FaceField<3>&, VecX&);
template Real max_divergence(const StaggeredGrid<2>&, const FaceField<2>&);
template Real max_divergence(const StaggeredGrid<3>&, const FaceField<3>&);
template Real inner_product(const StaggeredGrid<2>&, const FaceField<2>&, const FaceField<2>&);
template Real inner_product(const StaggeredGrid<3>&, const FaceField<3>&, const FaceField<3>&);
template Real kinetic_energy(const StaggeredGrid<2>&, const FaceField<2>&);
template Real kinetic_energy(const StaggeredGrid<3>&, const FaceField<3>&);
template Real max_speed(const FaceField<2>&);
template Real max_speed(const FaceField<3>&);
template Real courant_number(const StaggeredGrid<2>&, const FaceField<2>&, Real);
template Real courant_number(const StaggeredGrid<3>&, const FaceField<3>&, Real);
template void cell_velocity(const StaggeredGrid<2>&, const FaceField<2>&, Points<2>&);
template void cell_velocity(const StaggeredGrid<3>&, const FaceField<3>&, Points<3>&);

}  // namespace pliant
