#include <pliant/math/error.h>
#include <pliant/mesh/lattice.h>

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <limits>
#include <set>

using namespace pliant;
using Catch::Matchers::WithinRel;

namespace {

std::size_t count(Index n) { return static_cast<std::size_t>(n); }

template <int Dim>
bool lengths_are(const NodeLattice<Dim>& lattice, const std::vector<NodePair>& pairs, Real length) {
    const Points<Dim> points = lattice.points();
    return std::all_of(pairs.begin(), pairs.end(), [&](const NodePair& pair) {
        return std::abs((points.col(pair[1]) - points.col(pair[0])).norm() - length) < 1e-12 * length;
    });
}

}  // namespace

TEST_CASE("a block has the counted springs of every family", "[lattice]") {
    const Index a = 4, b = 3, c = 2;
    const NodeLattice<3> block({a, b, c}, Vec<3>::Constant(0.5));
    CHECK(block.node_count() == (a + 1) * (b + 1) * (c + 1));
    CHECK(block.structural().size() == count(a * (b + 1) * (c + 1) + (a + 1) * b * (c + 1) + (a + 1) * (b + 1) * c));
    CHECK(block.face_diagonals().size() == count(2 * (a * b * (c + 1) + a * (b + 1) * c + (a + 1) * b * c)));
    CHECK(block.body_diagonals().size() == count(4 * a * b * c));
    CHECK(block.bending().size() ==
          count((a - 1) * (b + 1) * (c + 1) + (a + 1) * (b - 1) * (c + 1) + (a + 1) * (b + 1) * (c - 1)));
    CHECK(lengths_are(block, block.structural(), 0.5));
    CHECK(lengths_are(block, block.face_diagonals(), 0.5 * std::sqrt(2.0)));
    CHECK(lengths_are(block, block.body_diagonals(), 0.5 * std::sqrt(3.0)));
    CHECK(lengths_are(block, block.bending(), 1.0));
}

TEST_CASE("no pair occurs twice, in one family or in two", "[lattice]") {
    const NodeLattice<3> block({3, 3, 3}, Vec<3>::Ones());
    std::set<NodePair> seen;
    std::size_t total = 0;
    for (const auto& family : {block.structural(), block.face_diagonals(), block.body_diagonals(), block.bending()})
        for (const NodePair& pair : family) {
            CHECK(pair[0] < pair[1]);
            seen.insert(pair);
            ++total;
        }
    CHECK(seen.size() == total);
}

TEST_CASE("chains and sheets are lattices with axes of no cells", "[lattice]") {
    const NodeLattice<2> chain({5, 0}, {0.1, 1});
    CHECK(chain.node_count() == 6);
    CHECK(chain.structural() == std::vector<NodePair>{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}});
    CHECK(chain.bending().size() == 4);
    CHECK(chain.face_diagonals().empty());
    CHECK(chain.body_diagonals().empty());
    CHECK_THAT(chain.points()(0, 5), WithinRel(0.5, 1e-15));

    const NodeLattice<3> sheet({2, 0, 2}, Vec<3>::Ones(), {0, 7, 0});
    CHECK(sheet.node_count() == 9);
    CHECK(sheet.face_diagonals().size() == 8);
    CHECK((sheet.points().row(1).array() == 7).all());

    const NodeLattice<2> single({0, 0}, Vec<2>::Ones());
    CHECK(single.node_count() == 1);
    CHECK(single.structural().empty());
}

TEST_CASE("numbers and positions of nodes are each other's inverse", "[lattice]") {
    const NodeLattice<3> block({2, 3, 4}, {0.1, 0.2, 0.3}, {1, 2, 3});
    for (Index n = 0; n < block.node_count(); ++n) CHECK(block.node(block.position(n)) == n);
    CHECK(block.points().col(block.node({1, 2, 3})).isApprox(Vec<3>(1.1, 2.4, 3.9), 1e-15));
}

TEST_CASE("the surface of a block is closed, faces outwards and encloses its volume", "[lattice]") {
    const NodeLattice<3> block({3, 2, 4}, {0.1, 0.2, 0.3}, {5, -1, 2});
    const Points<3> x = block.points();
    Real volume = 0;
    Vec<3> area = Vec<3>::Zero();
    for (const auto& [a, b, c] : surface_triangles(block)) {
        const Vec<3> normal = (x.col(b) - x.col(a)).eval().cross((x.col(c) - x.col(a)).eval()) / 2;
        area += normal;
        volume += normal.dot(x.col(a)) / 3;
    }
    CHECK(area.norm() < 1e-12);
    CHECK_THAT(volume, WithinRel(0.3 * 0.4 * 1.2, 1e-12));
}

TEST_CASE("lattices that make no sense are refused by name", "[lattice]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    CHECK_THROWS_AS(NodeLattice<2>({-1, 2}, Vec<2>::Ones()), Refused);
    CHECK_THROWS_AS(NodeLattice<2>({2, 2}, {1, 0}), Refused);
    CHECK_THROWS_AS(NodeLattice<2>({2, 2}, {1, nan}), Refused);
    CHECK_THROWS_AS(NodeLattice<2>({2, 2}, Vec<2>::Ones(), {nan, 0}), Refused);
    CHECK_THROWS_AS(NodeLattice<3>({100000, 100000, 100000}, Vec<3>::Ones()), Refused);
    CHECK_THROWS_AS(surface_triangles(NodeLattice<3>({2, 0, 2}, Vec<3>::Ones())), Refused);
}
