// Boundary elements in space: a cavity under pressure, a cube that is pulled, rigid motions.
#include <pliant/continuum/moduli.h>
#include <pliant/math/error.h>
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/bem/space_boundary_elements.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <Eigen/LU>
#include <cmath>
#include <map>
#include <numbers>

using namespace pliant;

namespace {

// An icosahedron, each triangle cut into four again and again, on the unit sphere; seen from inside, as the wall of a cavity is.
struct Sphere {
    Points<3> nodes;
    SpaceBoundaryElements::Triangles triangles;
};
Sphere cavity(int cuts) {
    const Real golden = (1 + std::sqrt(5.0)) / 2;
    std::vector<Vec<3>> nodes{{-1, golden, 0}, {1, golden, 0}, {-1, -golden, 0}, {1, -golden, 0},
                              {0, -1, golden}, {0, 1, golden}, {0, -1, -golden}, {0, 1, -golden},
                              {golden, 0, -1}, {golden, 0, 1}, {-golden, 0, -1}, {-golden, 0, 1}};
    std::vector<Eigen::Vector3i> faces{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int k = 0; k < cuts; ++k) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [place, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(nodes.size()));
            if (is_new)
                nodes.push_back(
                    (nodes[static_cast<std::size_t>(a)].normalized() + nodes[static_cast<std::size_t>(b)].normalized()) / 2);
            return place->second;
        };
        std::vector<Eigen::Vector3i> finer;
        for (const auto& f : faces) {
            const int a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
            for (const Eigen::Vector3i& n : {Eigen::Vector3i(f[0], a, c), Eigen::Vector3i(f[1], b, a),
                                             Eigen::Vector3i(f[2], c, b), Eigen::Vector3i(a, b, c)})
                finer.push_back(n);
        }
        faces = finer;
    }
    Sphere s{Points<3>(3, static_cast<Index>(nodes.size())),
             SpaceBoundaryElements::Triangles(3, static_cast<Index>(faces.size()))};
    for (std::size_t n = 0; n < nodes.size(); ++n) s.nodes.col(static_cast<Index>(n)) = nodes[n].normalized();
    for (std::size_t f = 0; f < faces.size(); ++f)
        s.triangles.col(static_cast<Index>(f)) = Eigen::Vector3i(faces[f][0], faces[f][2], faces[f][1]);
    // Blown up until it has the volume of the sphere.
    Real volume = 0;
    for (Index t = 0; t < s.triangles.cols(); ++t) volume -= Mat<3>(s.nodes(Eigen::all, s.triangles.col(t))).determinant() / 6;
    s.nodes *= std::cbrt(4 * std::numbers::pi / 3 / volume);
    return s;
}

// Largest error of u_r = p a/(4 G), relative.
Real cavity_error(int cuts) {
    const auto material = IsotropicModuli::from_young_poisson(1e4, 0.3);
    const Sphere sphere = cavity(cuts);
    SpaceBoundaryElements bem(sphere.nodes, sphere.triangles, material.lame(), true);
    bem.assemble();
    BoundaryConditions conditions = bem.system().free_boundary();
    for (Index t = 0; t < sphere.triangles.cols(); ++t)
        for (int a = 0; a < 3; ++a) conditions.value.segment<3>(3 * bem.system().slot_of(t, a)) = -bem.normal(t);
    const auto s = bem.system().solve(conditions);
    Real worst = 0;
    for (Index n = 0; n < sphere.nodes.cols(); ++n)
        worst = std::max(
            worst, std::abs(s.displacement.col(n).dot(sphere.nodes.col(n).normalized()) * 4 * material.shear_modulus() - 1));
    return worst;
}

}  // namespace

TEST_CASE("a cavity under pressure widens by p a/(4 G), at second order", "[bem]") {
    const Real coarse = cavity_error(1), fine = cavity_error(2);
    INFO("errors " << coarse << " (80 triangles), " << fine << " (320)");
    CHECK(fine < 0.04);
    CHECK(std::log2(coarse / fine) > 1.8);
}

TEST_CASE("a cube that is held at one face and pulled at the other has a uniform strain and stress", "[bem]") {
    const SimplexMesh<3> mesh = block_mesh<3>({.size = Vec<3>::Ones(), .cells = {2, 2, 2}, .split = CellSplit::diagonal});
    // The surface with nodes of its own: one for each face that meets in an edge would be needed for tractions that jump, so the
    // whole boundary is held, and gives the tractions.
    std::vector<int> number(static_cast<std::size_t>(mesh.node_count()), -1);
    Points<3> nodes(3, 0);
    SpaceBoundaryElements::Triangles triangles(3, mesh.facet_count());
    for (Index f = 0; f < mesh.facet_count(); ++f)
        for (int a = 0; a < 3; ++a) {
            int& n = number[static_cast<std::size_t>(mesh.facets()(a, f))];
            if (n < 0) {
                n = static_cast<int>(nodes.cols());
                nodes.conservativeResize(3, n + 1);
                nodes.col(n) = mesh.points().col(mesh.facets()(a, f));
            }
            triangles(a, f) = n;
        }
    SpaceBoundaryElements bem(nodes, triangles, IsotropicModuli::from_young_poisson(1e4, 0.3).lame(), false);
    bem.assemble();
    // H u = G t of a uniform state, whose tractions are known on every triangle.
    Mat<3> strain = Vec<3>(0.01, -0.003, 0.002).asDiagonal();
    strain(0, 1) = strain(1, 0) = 0.004;
    const Mat<3> stress = hooke_stress<3>(IsotropicModuli::from_young_poisson(1e4, 0.3).lame(), strain);
    BoundarySolution<3> s{strain * nodes, Points<3>(3, bem.system().slot_count())};
    for (Index t = 0; t < triangles.cols(); ++t)
        for (int a = 0; a < 3; ++a) s.traction.col(bem.system().slot_of(t, a)) = stress * bem.normal(t);
    const VecX left = bem.system().H() * flat(s.displacement), right = bem.system().G() * flat(s.traction);
    CHECK((left - right).norm() < 2e-5 * left.norm());
    CHECK((bem.displacement(s, {0.4, 0.5, 0.6}) - strain * Vec<3>(0.4, 0.5, 0.6)).norm() < 1e-7);
    CHECK((bem.stress(s, {0.4, 0.5, 0.6}) - stress).norm() < 1e-4 * stress.norm());
}

TEST_CASE("a surface that bounds no body is refused", "[bem]") {
    const Sphere s = cavity(0);
    const Lame material{1, 1};
    CHECK_THROWS_WITH(SpaceBoundaryElements(s.nodes, s.triangles.leftCols(19), material, true),
                      Catch::Matchers::ContainsSubstring("the surface is not closed"));
    auto turned = s.triangles;
    std::swap(turned(0, 3), turned(1, 3));
    CHECK_THROWS_WITH(SpaceBoundaryElements(s.nodes, turned, material, true),
                      Catch::Matchers::ContainsSubstring("turn one of them over"));
}
