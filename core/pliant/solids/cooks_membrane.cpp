#include <pliant/math/error.h>
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/cooks_membrane.h>
#include <pliant/solids/fem_loads.h>
#include <pliant/solids/linear_fem_static.h>

namespace pliant {
namespace {

SimplexMesh<2> tapered_panel(int n) {
    if (n < 2 || n % 2 != 0) throw Refused("cells of Cook's membrane", n, "", "even numbers from 2");
    const auto square = block_mesh<2>({Vec<2>::Ones(), {n, n}, Vec<2>::Zero(), CellSplit::diagonal});
    Points<2> points(2, square.node_count());
    for (Index i = 0; i < points.cols(); ++i) {
        const Real s = square.points()(0, i), t = square.points()(1, i);
        points.col(i) << 48 * s, (1 - t) * 44 * s + t * (44 + 16 * s);
    }
    return square.with_points(points);
}

}  // namespace

CooksMembrane::CooksMembrane(int n) : mesh_(tapered_panel(n)), unit_load_(Points<2>::Zero(2, mesh_.node_count())) {
    constexpr Real loaded_edge = 16;
    add_traction<2>(mesh_, mesh_.facets("x_max"), Vec<2>(0, 1 / loaded_edge), unit_load_);
}

Points<2> CooksMembrane::displacement(const Lame& material, Real force) const {
    const LinearFem<2> body(mesh_, material);
    DisplacementConstraints<2> clamp(mesh_.node_count());
    clamp.prescribe(mesh_.nodes("x_min"), Vec<2>::Zero());
    return solve_static<2>(body, clamp, force * unit_load_).displacement;
}

}  // namespace pliant
