// Simplex meshes: measures, boundary, generators, quadrature, and what is refused.
#include <pliant/math/error.h>
#include <pliant/mesh/block_mesh.h>
#include <pliant/mesh/simplex_quadrature.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <limits>
#include <set>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

template <int Dim>
BlockShape<Dim> odd_block(CellSplit split) {
    BlockShape<Dim> block;
    for (int k = 0; k < Dim; ++k) {
        block.size[k] = 1.5 + 0.7 * k;
        block.origin[k] = -0.3 + k;
        block.cells[static_cast<std::size_t>(k)] = 3 + k;
    }
    block.split = split;
    return block;
}

// Every simplex as the set of the lattice positions of its corners, after a map of the unit cube onto itself.
template <int Dim, class Map>
std::set<std::set<std::vector<int>>> simplices_as_sets(const SimplexMesh<Dim>& mesh, int cells, Map map) {
    std::set<std::set<std::vector<int>>> all;
    for (Index e = 0; e < mesh.simplex_count(); ++e) {
        std::set<std::vector<int>> corners;
        for (int a = 0; a <= Dim; ++a) {
            const Vec<Dim> x = map(Vec<Dim>(mesh.points().col(mesh.simplices()(a, e))));
            std::vector<int> position;
            for (int k = 0; k < Dim; ++k) position.push_back(static_cast<int>(std::lround(x[k] * cells)));
            corners.insert(position);
        }
        all.insert(corners);
    }
    return all;
}

SimplexMesh<2> triangle(const Points<2>& points) {
    SimplexMesh<2>::Simplices simplices(3, 1);
    simplices << 0, 1, 2;
    return {points, simplices};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("A block has the volume, the boundary and the faces of its box", "[mesh]", ((int Dim), Dim), 2, 3) {
    for (const auto split : {CellSplit::alternating, CellSplit::diagonal}) {
        const BlockShape<Dim> block = odd_block<Dim>(split);
        const SimplexMesh<Dim> mesh = block_mesh<Dim>(block);
        CHECK_THAT(mesh.volume(), WithinRel(block.size.prod(), 1e-14));
        CHECK(mesh.volumes().minCoeff() > 0);

        // A closed surface has no net area, and the divergence theorem gives the volume back.
        CHECK(mesh.facet_areas().rowwise().sum().norm() < 1e-14);
        Real flux = 0;
        for (Index f = 0; f < mesh.facet_count(); ++f) {
            Vec<Dim> centre = Vec<Dim>::Zero();
            for (int a = 0; a < Dim; ++a) centre += mesh.points().col(mesh.facets()(a, f)) / Dim;
            flux += centre.dot(mesh.facet_areas().col(f)) / Dim;
        }
        CHECK_THAT(flux, WithinRel(block.size.prod(), 1e-13));

        // Each face: its area vector points outward, its nodes lie on it, and the faces make up the whole boundary.
        std::size_t facets = 0;
        const char* axes[] = {"x", "y", "z"};
        for (int k = 0; k < Dim; ++k)
            for (const bool upper : {false, true}) {
                const std::string name = std::string(axes[k]) + (upper ? "_max" : "_min");
                Vec<Dim> area = Vec<Dim>::Zero();
                for (const Index f : mesh.facets(name)) area += mesh.facet_areas().col(f);
                const Vec<Dim> expected = (upper ? 1 : -1) * block.size.prod() / block.size[k] * Vec<Dim>::Unit(k);
                CHECK((area - expected).norm() < 1e-14);
                for (const Index n : mesh.nodes(name))
                    CHECK_THAT(mesh.points()(k, n), WithinAbs(block.origin[k] + (upper ? block.size[k] : 0), 1e-15));
                facets += mesh.facets(name).size();
            }
        CHECK(facets == static_cast<std::size_t>(mesh.facet_count()));
    }
}

TEMPLATE_TEST_CASE_SIG("Facets wind around their outward area", "[mesh]", ((int Dim), Dim), 2, 3) {
    const SimplexMesh<Dim> mesh = block_mesh<Dim>(odd_block<Dim>(CellSplit::alternating));
    for (Index f = 0; f < mesh.facet_count(); ++f) {
        const Vec<Dim> a = mesh.points().col(mesh.facets()(0, f)), b = mesh.points().col(mesh.facets()(1, f));
        Vec<Dim> area;
        if constexpr (Dim == 2) {
            area = Vec<2>(b[1] - a[1], a[0] - b[0]);
        } else {
            const Vec<3> c = mesh.points().col(mesh.facets()(2, f));
            area = 0.5 * (b - a).cross(c - a);
        }
        CHECK((area - mesh.facet_areas().col(f)).norm() < 1e-14);
    }
}

TEMPLATE_TEST_CASE_SIG("Shape functions reproduce linear fields", "[mesh]", ((int Dim), Dim), 2, 3) {
    const SimplexMesh<Dim> mesh = block_mesh<Dim>(odd_block<Dim>(CellSplit::alternating));
    Mat<Dim> gradient;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) gradient(i, j) = std::sin(1 + 3 * i + j);
    const Points<Dim> values = (gradient * mesh.points()).colwise() + Vec<Dim>::Constant(2.5);
    for (Index e = 0; e < mesh.simplex_count(); ++e) {
        CHECK(mesh.gradients(e).rowwise().sum().norm() < 1e-13);
        CHECK((mesh.field_gradient(e, values) - gradient).norm() < 1e-13);
    }
}

TEST_CASE("Alternating splits prefer no direction", "[mesh]") {
    const auto mesh = block_mesh<3>({Vec<3>::Ones(), {2, 2, 2}, Vec<3>::Zero(), CellSplit::alternating});
    const auto plain = simplices_as_sets<3>(mesh, 2, [](const Vec<3>& x) { return x; });
    CHECK(mesh.simplex_count() == 5 * 8);
    CHECK(plain == simplices_as_sets<3>(mesh, 2, [](const Vec<3>& x) { return Vec<3>(1 - x[0], x[1], x[2]); }));
    CHECK(plain == simplices_as_sets<3>(mesh, 2, [](const Vec<3>& x) { return Vec<3>(x[0], x[1], 1 - x[2]); }));
    CHECK(plain == simplices_as_sets<3>(mesh, 2, [](const Vec<3>& x) { return Vec<3>(x[1], x[2], x[0]); }));

    const auto skewed = block_mesh<3>({Vec<3>::Ones(), {2, 2, 2}, Vec<3>::Zero(), CellSplit::diagonal});
    CHECK(skewed.simplex_count() == 6 * 8);
    CHECK(simplices_as_sets<3>(skewed, 2, [](const Vec<3>& x) { return x; }) !=
          simplices_as_sets<3>(skewed, 2, [](const Vec<3>& x) { return Vec<3>(1 - x[0], x[1], x[2]); }));

    const auto plane = block_mesh<2>({Vec<2>::Ones(), {2, 2}, Vec<2>::Zero(), CellSplit::alternating});
    const auto flat = simplices_as_sets<2>(plane, 2, [](const Vec<2>& x) { return x; });
    CHECK(flat == simplices_as_sets<2>(plane, 2, [](const Vec<2>& x) { return Vec<2>(1 - x[0], x[1]); }));
    CHECK(flat == simplices_as_sets<2>(plane, 2, [](const Vec<2>& x) { return Vec<2>(x[1], x[0]); }));
}

TEST_CASE("Broken meshes are refused by number", "[mesh]") {
    Points<2> points(2, 3);
    points << 0, 1, 0, 0, 0, 1;
    CHECK_NOTHROW(triangle(points));

    Points<2> flat = points, bad = points;
    flat.col(2) << 2, 0;
    CHECK_THROWS_WITH(triangle(flat), ContainsSubstring("element 0") && ContainsSubstring("degenerate"));
    flat.col(2) = flat.col(0);
    CHECK_THROWS_WITH(triangle(flat), ContainsSubstring("degenerate"));
    flat.setZero();
    CHECK_THROWS_WITH(triangle(flat), ContainsSubstring("degenerate"));
    bad(1, 2) = std::numeric_limits<Real>::quiet_NaN();
    CHECK_THROWS_WITH(triangle(bad), ContainsSubstring("node 2"));
    bad(1, 2) = std::numeric_limits<Real>::infinity();
    CHECK_THROWS_WITH(triangle(bad), ContainsSubstring("node 2"));

    using Simplices = SimplexMesh<2>::Simplices;
    const auto with = [&points](std::initializer_list<int> corners) {
        Simplices simplices(3, static_cast<Index>(corners.size()) / 3);
        std::copy(corners.begin(), corners.end(), simplices.data());
        return SimplexMesh<2>(points, simplices);
    };
    CHECK_THROWS_WITH(with({0, 2, 1}), ContainsSubstring("element 0") && ContainsSubstring("inverted"));
    CHECK_THROWS_WITH(with({0, 1, 3}), ContainsSubstring("element 0") && ContainsSubstring("node 3"));
    CHECK_THROWS_WITH(with({0, 1, -1}), ContainsSubstring("node -1"));
    CHECK_THROWS_WITH(with({0, 1, 1}), ContainsSubstring("node 1 twice"));
    CHECK_THROWS_WITH(with({0, 1, 2, 0, 1, 2, 0, 1, 2}), ContainsSubstring("share one facet"));
    points.conservativeResize(2, 4);
    points.col(3) << 5, 5;
    CHECK_THROWS_WITH(with({0, 1, 2}), ContainsSubstring("node 3") && ContainsSubstring("no element"));
}

TEST_CASE("Blocks with impossible sizes are refused by name", "[mesh]") {
    CHECK_THROWS_WITH(block_mesh<2>({{0, 1}, {1, 1}}), ContainsSubstring("size of the block along x"));
    CHECK_THROWS_WITH(block_mesh<2>({{1, -2}, {1, 1}}), ContainsSubstring("along y"));
    CHECK_THROWS_WITH(block_mesh<3>({{1, 1, 1}, {1, 1, 0}}), ContainsSubstring("cells of the block along z"));
    CHECK_THROWS_WITH(block_mesh<3>({{1, 1, 1}, {2000, 2000, 2000}}), ContainsSubstring("too large"));
    CHECK_THROWS_WITH(block_mesh<2>({{1, std::numeric_limits<Real>::quiet_NaN()}, {1, 1}}), ContainsSubstring("along y"));
    CHECK_THROWS_WITH(block_mesh<2>({{1, 1}, {1, 1}}).nodes("left"), ContainsSubstring("left") && ContainsSubstring("x_min"));
}

TEST_CASE("Size decides nothing: tiny, huge and thin meshes are measured alike", "[mesh]") {
    for (const Real unit : {1e-9, 1e-6, 1.0, 1e6, 1e9}) {
        const auto mesh = block_mesh<3>({unit * Vec<3>(1, 2, 3), {2, 2, 2}});
        CHECK_THAT(mesh.volume() / (unit * unit * unit), WithinRel(6.0, 1e-13));
    }
    // A tetrahedron with dihedral angles of 0.1 degree is thin, not degenerate.
    Points<3> points(3, 4);
    points << 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1.7e-3;
    SimplexMesh<3>::Simplices simplices(4, 1);
    simplices << 0, 1, 2, 3;
    CHECK_NOTHROW(SimplexMesh<3>(points, simplices));
}

TEST_CASE("Moved meshes keep their sets, and parts that share no node are told apart", "[mesh]") {
    const auto mesh = block_mesh<2>({{1, 1}, {2, 2}});
    const auto moved = mesh.with_points(3 * mesh.points());
    CHECK(moved.nodes("x_max") == mesh.nodes("x_max"));
    CHECK_THAT(moved.volume(), WithinRel(9.0, 1e-14));
    CHECK_THROWS_WITH(mesh.with_points(-1.0 * Points<2>(mesh.points().colwise().reverse())), ContainsSubstring("inverted"));

    Points<2> points(2, 6);
    points << 0, 1, 0, 5, 6, 5, 0, 0, 1, 0, 0, 1;
    SimplexMesh<2>::Simplices simplices(3, 2);
    simplices << 0, 3, 1, 4, 2, 5;
    CHECK(SimplexMesh<2>(points, simplices).connected_parts() == std::vector<int>{0, 1});
    CHECK(mesh.connected_parts() == std::vector<int>(8, 0));
}

TEST_CASE("Quadrature is exact up to its degree", "[mesh]") {
    const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
    for (int degree = 0; degree <= 9; ++degree) {
        const auto triangles = simplex_rule<2>(degree);
        const auto tetrahedra = simplex_rule<3>(degree);
        CHECK_THAT(triangles.weights.sum(), WithinRel(1.0, 1e-14));
        CHECK(triangles.barycentric.minCoeff() > 0);
        CHECK(tetrahedra.barycentric.minCoeff() > 0);
        // Mean of x^i y^j z^k over the unit simplex: Dim! i! j! k! / (i + j + k + Dim)!.
        for (int i = 0; i <= degree; ++i)
            for (int j = 0; i + j <= degree; ++j) {
                Real mean = 0;
                for (Index q = 0; q < triangles.weights.size(); ++q)
                    mean += triangles.weights[q] * std::pow(triangles.barycentric(1, q), i) *
                            std::pow(triangles.barycentric(2, q), j);
                CHECK_THAT(mean, WithinRel(2 * factorial(i) * factorial(j) / factorial(i + j + 2), 1e-13));
                const int k = degree - i - j;
                Real mean3 = 0;
                for (Index q = 0; q < tetrahedra.weights.size(); ++q)
                    mean3 += tetrahedra.weights[q] * std::pow(tetrahedra.barycentric(1, q), i) *
                             std::pow(tetrahedra.barycentric(2, q), j) * std::pow(tetrahedra.barycentric(3, q), k);
                CHECK_THAT(mean3, WithinRel(6 * factorial(i) * factorial(j) * factorial(k) / factorial(degree + 3), 1e-13));
            }
    }
    const GaussRule gauss = gauss_legendre(2);
    CHECK_THAT(gauss.points[0], WithinRel(0.5 - 0.5 / std::sqrt(3.0), 1e-15));
    CHECK_THROWS_AS(simplex_rule<2>(-1), Refused);
}
