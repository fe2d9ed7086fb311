#include <pliant/lesson/unstructured_grid.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace pliant {

int nodes_of(CellKind kind) {
    constexpr std::array<int, 9> counts{1, 2, 3, 4, 4, 8, 3, 6, 10};
    return counts[static_cast<std::size_t>(kind)];
}

Index UnstructuredGrid::cell_count() const {
    return std::accumulate(cells.begin(), cells.end(), Index{0},
                           [](Index sum, const CellBlock& block) { return sum + block.nodes.cols(); });
}

bool UnstructuredGrid::of_points(On on, Index rows) const {
    return rows == points.cols() && std::ranges::find(on_points, on) != on_points.end();
}

bool UnstructuredGrid::of_cells(On on, Index rows) const {
    return rows == cell_count() && std::ranges::find(on_cells, on) != on_cells.end();
}

Points<3> in_space(const Eigen::Ref<const MatX>& points) {
    Points<3> all = Points<3>::Zero(3, points.cols());
    all.topRows(points.rows()) = points;
    return all;
}

UnstructuredGrid grid_of(Points<3> points, CellKind kind, Eigen::MatrixXi nodes, std::vector<On> on_cells) {
    return {.points = std::move(points), .cells = {{kind, std::move(nodes)}}, .on_cells = std::move(on_cells)};
}

UnstructuredGrid grid_of_points(Points<3> points, std::vector<On> on_points) {
    Eigen::MatrixXi nodes(1, points.cols());
    for (Index p = 0; p < points.cols(); ++p) nodes(0, p) = static_cast<int>(p);
    return {.points = std::move(points), .cells = {{CellKind::vertex, std::move(nodes)}}, .on_points = std::move(on_points)};
}

UnstructuredGrid regular_grid(const Vec<3>& corner, const Vec<3>& spacing, Index nx, Index ny, Index nz,
                              std::vector<On> on_cells) {
    const bool flat = nz == 0;
    const Index px = nx + 1, py = ny + 1, pz = nz + 1, layers = flat ? 1 : nz;
    UnstructuredGrid grid{.points = Points<3>(3, px * py * pz), .on_points = {}, .on_cells = std::move(on_cells)};
    const auto point = [&](Index i, Index j, Index k) { return static_cast<int>((k * py + j) * px + i); };
    for (Index k = 0; k < pz; ++k)
        for (Index j = 0; j < py; ++j)
            for (Index i = 0; i < px; ++i)
                grid.points.col(point(i, j, k)) = corner + Vec<3>(Real(i), Real(j), Real(k)).cwiseProduct(spacing);
    Eigen::MatrixXi nodes(flat ? 4 : 8, nx * ny * layers);
    Index cell = 0;
    for (Index k = 0; k < layers; ++k)
        for (Index j = 0; j < ny; ++j)
            for (Index i = 0; i < nx; ++i, ++cell)
                for (Index layer = 0; layer < (flat ? 1 : 2); ++layer)
                    nodes.col(cell).segment<4>(4 * layer) << point(i, j, k + layer), point(i + 1, j, k + layer),
                        point(i + 1, j + 1, k + layer), point(i, j + 1, k + layer);
    grid.cells = {{flat ? CellKind::quadrangle : CellKind::hexahedron, std::move(nodes)}};
    return grid;
}

}  // namespace pliant
