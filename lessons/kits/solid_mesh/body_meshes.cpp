#include "body_meshes.h"

#include <pliant/mesh/block_mesh.h>

#include <algorithm>

namespace pliant::solid_mesh {
namespace {

SimplexMesh<2> cut_square(int cells_x, int cells_y) {
    return block_mesh<2>({Vec<2>::Ones(), {cells_x, cells_y}, Vec<2>::Zero(), CellSplit::diagonal});
}

}  // namespace

SimplexMesh<3> beam_mesh(const Vec<3>& size, const std::array<int, 3>& cells) {
    SimplexMesh<3> mesh = block_mesh<3>({size, cells, Vec<3>::Zero(), CellSplit::diagonal});
    mesh.name_facets("fixed", mesh.facets("x_min"));
    mesh.name_facets("loaded", mesh.facets("x_max"));
    return mesh;
}

SimplexMesh<2> panel_mesh(const Vec<2>& size, int cells_x, int cells_y) {
    SimplexMesh<2> mesh = block_mesh<2>({size, {cells_x, cells_y}, Vec<2>::Zero(), CellSplit::alternating});
    mesh.name_facets("fixed", mesh.facets("x_min"));
    mesh.name_facets("loaded", mesh.facets("x_max"));
    return mesh;
}

SimplexMesh<2> cook_mesh(int cells_x, int cells_y) {
    const SimplexMesh<2> square = cut_square(cells_x, cells_y);
    Points<2> points(2, square.node_count());
    for (Index i = 0; i < points.cols(); ++i) {
        const Real s = square.points()(0, i), t = square.points()(1, i);
        points.col(i) << 48 * s, (1 - t) * 44 * s + t * (44 + 16 * s);
    }
    SimplexMesh<2> mesh = square.with_points(points);
    mesh.name_facets("fixed", mesh.facets("x_min"));
    mesh.name_facets("loaded", mesh.facets("x_max"));
    return mesh;
}

SimplexMesh<2> square_mesh(int cells_x, int cells_y) {
    SimplexMesh<2> mesh = cut_square(cells_x, cells_y);
    std::vector<Index> all(static_cast<std::size_t>(mesh.facet_count()));
    for (std::size_t f = 0; f < all.size(); ++f) all[f] = static_cast<Index>(f);
    mesh.name_facets("fixed", all);
    mesh.name_facets("loaded", {});
    return mesh;
}

}  // namespace pliant::solid_mesh
