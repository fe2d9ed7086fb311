// Lattices of springs as materials: elastic constants, static tests of pieces, mechanisms.
#include <pliant/math/error.h>
#include <pliant/solids/lattice_elasticity.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <set>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

struct Row {
    LatticeKind kind;
    FamilyStiffness stiffness;
    Real c11, c12, c44, youngs, poisson;
};

// Reference catalogue P6.3, every row, in units of the stiffness and the edge.
const Real root3 = std::sqrt(3.0);
const std::vector<Row> rows{{LatticeKind::triangular, {1, 0, 0}, 3 * root3 / 4, root3 / 4, root3 / 4, 2 / root3, 1.0 / 3},
                            {LatticeKind::square, {1, 0.5, 0}, 1.5, 0.5, 0.5, 4.0 / 3, 1.0 / 3},
                            {LatticeKind::cubic_face, {1, 1, 0}, 3, 1, 1, 2.5, 0.25},
                            {LatticeKind::cubic_body, {8.0 / 3, 1, 0}, 4, 4.0 / 3, 4.0 / 3, 10.0 / 3, 0.25},
                            {LatticeKind::cubic_body, {1, 1, 0}, 7.0 / 3, 4.0 / 3, 4.0 / 3, 1.363636364, 0.363636364},
                            {LatticeKind::cubic_face, {1, 0, 0}, 1, 0, 0, 1, 0}};

SpringLattice piece(LatticeKind kind, Index n, Real edge = 1) { return {kind, {n, n, n}, edge}; }

}  // namespace

TEST_CASE("six lattices have the elastic constants of the catalogue", "[springs][lattice]") {
    for (const Row& row : rows)
        for (const Real edge : {1.0, 0.05}) {
            const LatticeConstants c = lattice_constants(row.kind, row.stiffness, edge);
            const Real unit = std::pow(edge, 2 - c.dimension);
            CHECK_THAT(c.c11, WithinRel(row.c11 * unit, 1e-12));
            CHECK_THAT(c.c12, WithinAbs(row.c12 * unit, 1e-12 * unit));
            CHECK_THAT(c.c44, WithinAbs(row.c44 * unit, 1e-12 * unit));
            CHECK_THAT(c.youngs_modulus(), WithinRel(row.youngs * unit, 1e-9));
            CHECK_THAT(c.poisson_ratio(), WithinAbs(row.poisson, 1e-9));
            CHECK(c.c12 == c.c44);  // Cauchy
        }
    CHECK_THAT(lattice_constants(LatticeKind::cubic_body, {1, 1, 0}, 1).zener_ratio(), WithinRel(8.0 / 3, 1e-12));
    CHECK_THAT(lattice_constants(LatticeKind::chain, {3, 0, 0}, 0.5).youngs_modulus(), WithinRel(1.5, 1e-15));
}

TEST_CASE("a piece whose outer springs are shared out measures the same, at every size", "[springs][lattice]") {
    for (const Row& row : rows) {
        if (row.c44 == 0) continue;
        for (const Index n : {1, 3}) {
            const BlockResponse r = test_block(piece(row.kind, n, 0.5), row.stiffness, BlockTest::stretch, true);
            const Real unit = dimension_of(row.kind) == 3 ? 2 : 1;
            CHECK_THAT(r.youngs_modulus, WithinRel(row.youngs * unit, 1e-9));
            CHECK_THAT(r.poisson_ratio, WithinRel(row.poisson, 1e-8));
        }
    }
}

TEST_CASE("a piece with whole springs on its faces is stiffer, the more so the coarser it is", "[springs][lattice]") {
    for (const LatticeKind kind :
         {LatticeKind::triangular, LatticeKind::square, LatticeKind::cubic_face, LatticeKind::cubic_body}) {
        const FamilyStiffness k{1, 0.5, 0};
        const Real material = lattice_constants(kind, k, 1).youngs_modulus();
        Real before = 10;
        for (const Index n : {1, 2, 4}) {
            const Real ratio = test_block(piece(kind, n), k, BlockTest::stretch).youngs_modulus / material;
            CHECK(ratio > 1.02);
            CHECK(ratio < before);
            before = ratio;
        }
    }
}

TEST_CASE("edges alone: the static test reports mechanisms and how many", "[springs][lattice]") {
    for (const BlockTest test : {BlockTest::stretch, BlockTest::shear, BlockTest::bend}) {
        CHECK_THROWS_AS(test_block(piece(LatticeKind::cubic_face, 2), {1, 0, 0}, test), Diverged);
        CHECK_THROWS_WITH(test_block(piece(LatticeKind::square, 3), {1, 0, 0}, test),
                          ContainsSubstring("singular") && ContainsSubstring("mechanisms unconstrained"));
    }
    // Two plates and one row of 2 nodes each: the square leans over, with both plates free to slide.
    CHECK_THROWS_WITH(test_block(piece(LatticeKind::square, 1), {1, 0, 0}, BlockTest::stretch),
                      ContainsSubstring("singular: 1 mechanisms unconstrained"));
    CHECK_THROWS_AS(test_block(SpringLattice(LatticeKind::chain, {0, 4, 0}, 1), {1, 0, 0}, BlockTest::shear), Refused);
}

TEST_CASE("the coupling is the logarithmic derivative of the stiffness", "[springs][lattice]") {
    const FamilyStiffness k{2, 0.7, 0.3};
    for (const LatticeKind kind : {LatticeKind::square, LatticeKind::cubic_face, LatticeKind::cubic_body})
        for (const BlockTest test : {BlockTest::stretch, BlockTest::shear, BlockTest::bend}) {
            const SpringLattice lattice(kind, {2, 3, 2}, 0.4);
            const BlockResponse r = test_block(lattice, k, test);
            Real sum = 0;
            for (const SpringFamily family : {structural, shear, bending}) {
                const Real h = 1e-4;
                FamilyStiffness more = k, less = k;
                more[family] *= std::exp(h), less[family] *= std::exp(-h);
                const Real slope =
                    std::log(test_block(lattice, more, test).stiffness / test_block(lattice, less, test).stiffness) / (2 * h);
                CHECK_THAT(r.coupling[family], WithinAbs(slope, 1e-7));
                sum += r.coupling[family];
            }
            CHECK_THAT(sum, WithinRel(1, 1e-12));
        }
}

TEST_CASE("a chain is its springs one after another", "[springs][lattice]") {
    const BlockResponse r = test_block(SpringLattice(LatticeKind::chain, {7, 5, 9}, 0.2), {3, 1, 0}, BlockTest::stretch);
    CHECK_THAT(r.stiffness, WithinRel(0.6, 1e-12));
    CHECK(r.poisson_ratio == 0);
}

TEST_CASE("springs of a lattice join nodes at their distance, each pair once", "[springs][lattice]") {
    for (const LatticeKind kind :
         {LatticeKind::chain, LatticeKind::triangular, LatticeKind::square, LatticeKind::cubic_face, LatticeKind::cubic_body}) {
        const SpringLattice lattice(kind, {3, 4, 2}, 1);
        const Points<3> x = lattice.points();
        std::set<NodePair> seen;
        for (const SpringFamily family : {structural, shear, bending})
            for (const NodePair& pair : lattice.pairs(family)) {
                CHECK(pair[0] < pair[1]);
                CHECK(seen.insert(pair).second);
                const Real length = (x.col(pair[1]) - x.col(pair[0])).norm();
                const Real diagonal = kind == LatticeKind::cubic_body ? root3 : std::sqrt(2.0);
                CHECK_THAT(length, WithinRel(family == structural ? 1 : family == bending ? 2 : diagonal, 1e-12));
            }
    }
    CHECK(SpringLattice(LatticeKind::triangular, {3, 2, 0}, 1).pairs(structural).size() == 3 * 3 + 2 * 7);
    CHECK(SpringLattice(LatticeKind::cubic_face, {3, 4, 2}, 1).pairs(shear) ==
          NodeLattice<3>({3, 4, 2}, Vec<3>::Ones()).face_diagonals());
}
