#include <pliant/math/error.h>
#include <pliant/mesh/disc_mesh.h>

#include <cmath>
#include <numbers>

namespace pliant {
namespace {

// Number of node i of ring k; rings are closed.
int node_of_ring(int k, int i) { return k == 0 ? 0 : 1 + 3 * k * (k - 1) + i % (6 * k); }

}  // namespace

SimplexMesh<2> disc_mesh(Real radius, int rings, const Vec<2>& centre) {
    if (!(radius > 0) || !std::isfinite(radius)) throw Refused("radius of the disc", radius, "m", "(0, inf)");
    if (rings < 1) throw Refused("rings of the disc", rings, "", "a whole number from 1 on");
    Points<2> points(2, 1 + 3 * Index(rings) * (rings + 1));
    points.col(0) = centre;
    for (int k = 1; k <= rings; ++k)
        for (int i = 0; i < 6 * k; ++i) {
            const Real angle = std::numbers::pi * i / (3 * k), r = radius * k / rings;
            points.col(node_of_ring(k, i)) = centre + r * Vec<2>(std::cos(angle), std::sin(angle));
        }
    SimplexMesh<2>::Simplices triangles(3, 6 * Index(rings) * rings);
    Index next = 0;
    for (int k = 0; k < rings; ++k)
        for (int sector = 0; sector < 6; ++sector)
            for (int i = 0; i <= k; ++i) {
                const int inner = node_of_ring(k, sector * k + i), outer = node_of_ring(k + 1, sector * (k + 1) + i),
                          beyond = node_of_ring(k + 1, sector * (k + 1) + i + 1);
                triangles.col(next++) << inner, outer, beyond;
                if (i < k) triangles.col(next++) << inner, beyond, node_of_ring(k, sector * k + i + 1);
            }
    return {std::move(points), std::move(triangles)};
}

}  // namespace pliant
