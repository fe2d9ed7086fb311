#include <pliant/fluids/parallel_rows.h>
#include <pliant/fluids/pressure_gradient.h>

namespace pliant {
namespace {

// u −= scale (above − below) on n faces; open is 1 or 0 by face, or null where all are open.
void subtract_difference(const Real* above, const Real* below, Real scale, Index n, const Real* open, Real* u) {
    using Row = Eigen::Map<const VecX>;
    Eigen::Map<VecX> out(u, n);
    if (open)
        out -= scale * (Row(above, n) - Row(below, n)).cwiseProduct(Row(open, n));
    else
        out -= scale * (Row(above, n) - Row(below, n));
}

}  // namespace

template <int Dim>
void subtract_gradient(const StaggeredGrid<Dim>& grid, const VecX& p, Real scale, FaceField<Dim>& velocity) {
    const Lattice<Dim>& cells = grid.cells();
    const Index n = cells.count[0], faces_along = grid.faces(0).count[0];
    const Real s = scale / grid.dx();
    const auto open = [&](int axis, Index face) { return grid.has_gaps() ? grid.openness(axis).data() + face : nullptr; };
    parallel_for_each_row(cells, [&](Index start, const Counts<Dim>& at, int) {
        // Faces across axis 0 between the cells of this row; on a periodic axis face 0 joins its ends.
        const Index face = start / n * faces_along;
        const Real* row = p.data() + start;
        Real* u = velocity[0].data() + face;
        if (n > 1) subtract_difference(row + 1, row, s, n - 1, open(0, face + 1), u + 1);
        if (grid.periodic(0)) subtract_difference(row, row + n - 1, s, 1, open(0, face), u);
        // Faces between this row and the one below it along the other axes.
        for (int a = 1; a < Dim; ++a) {
            const Index below = cells.neighbour(at, a, -1);
            if (below < 0) continue;
            const Index across = grid.faces(a).index(at);
            subtract_difference(row, p.data() + below, s, n, open(a, across), velocity[a].data() + across);
        }
    });
}

template <int Dim>
void subtract_gradient(const StaggeredGrid<Dim>& grid, const VecX& p, const SurfaceFractions<Dim>& fractions, Real scale,
                       FaceField<Dim>& velocity) {
    subtract_gradient(grid, p, scale, velocity);
    for (int a = 0; a < Dim; ++a) {
        const std::vector<Index>& faces = grid.surface_faces(a);
        for (std::size_t k = 0; k < faces.size(); ++k) {
            const Real steeper = 1 / fractions[a][static_cast<Index>(k)] - 1;
            const Real rise = p[grid.cell_beside(a, faces[k], 1)] - p[grid.cell_beside(a, faces[k], 0)];
            velocity[a][faces[k]] -= scale / grid.dx() * steeper * rise;
        }
    }
}

template void subtract_gradient(const StaggeredGrid<2>&, const VecX&, Real, FaceField<2>&);
template void subtract_gradient(const StaggeredGrid<3>&, const VecX&, Real, FaceField<3>&);
template void subtract_gradient(const StaggeredGrid<2>&, const VecX&, const SurfaceFractions<2>&, Real, FaceField<2>&);
template void subtract_gradient(const StaggeredGrid<3>&, const VecX&, const SurfaceFractions<3>&, Real, FaceField<3>&);

}  // namespace pliant
