// Nets of springs as bodies: blocks, sheets and their static tests, against closed forms and invariants.
#include <pliant/math/error.h>
#include <pliant/solids/cloth_sheet.h>
#include <pliant/solids/sheet_levels.h>
#include <pliant/solids/spring_block.h>
#include <pliant/solids/static_tests.h>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <numbers>

using namespace pliant;
using Catch::Approx;

namespace {

constexpr std::array net_kinds{LatticeKind::cubic_face, LatticeKind::cubic_body, LatticeKind::square, LatticeKind::triangular,
                               LatticeKind::chain};

Mat<3> some_stretch() {
    Mat<3> F;
    F << 1.2, 0.3, -0.1, 0.05, 0.9, 0.2, -0.15, 0.1, 1.1;
    return F;
}

Points<3> moved(const Points<3>& x, const Mat<3>& F) {
    Points<3> y = F * x;
    y.colwise() += Vec<3>(3, -2, 1);
    return y;
}

}  // namespace

TEST_CASE("spring blocks: at rest there is no force, and the mass is shared out", "[nets]") {
    for (const LatticeKind kind : net_kinds) {
        SpringBlock block(SpringLattice(kind, {3, 4, 2}, 0.1));
        CHECK(block.set_springs({300, 200, 100}, 0.1, 1));
        block.set_mass(2.5, {0});
        CHECK(block.mass().sum() == Approx(2.5));
        CHECK(block.inertia().fixed(0));
        Points<3> force = Points<3>::Zero(3, block.rest().cols());
        add_spring_forces<3>(block.springs(), block.rest(), force);
        CHECK(force.norm() < 1e-10);
        CHECK(block.rest().row(1).minCoeff() == Approx(0).margin(1e-12));
        for (const SpringFamily family : {structural, shear, bending})
            CHECK(block.last(family) - block.first(family) == static_cast<Index>(block.lattice().pairs(family).size()));
    }
}

TEST_CASE("spring blocks: a slider changes springs in place, a family that comes or goes makes them anew", "[nets]") {
    SpringBlock block(SpringLattice(LatticeKind::square, {3, 3, 1}, 0.1));
    CHECK(block.set_springs({300, 200, 0}, 0.1, 1));
    CHECK_FALSE(block.set_springs({400, 100, 0}, 0.3, 1));
    CHECK(block.springs().stiffness().head(block.last(structural)).minCoeff() == 400);
    CHECK(block.springs().stiffness().tail(block.last(shear) - block.first(shear)).maxCoeff() == 100);
    CHECK(block.springs().damping().minCoeff() == 0.3);
    CHECK(block.set_springs({400, 0, 0}, 0.3, 1));
    CHECK(block.first(shear) == block.last(shear));
    const VecX lengths = block.springs().rest_length();
    CHECK(block.set_springs({400, 0, 0}, 0.3, 0.5));
    CHECK((block.springs().rest_length() - 0.5 * lengths).norm() < 1e-15);
}

TEST_CASE("spring blocks: the smallest cell of an affine motion is its change of volume, area or length", "[nets]") {
    const Mat<3> F = some_stretch();
    for (const LatticeKind kind : net_kinds) {
        const SpringBlock block(SpringLattice(kind, {3, 4, 2}, 0.1));
        const Real area = F.col(0).cross(F.col(1)).norm(), length = F.col(1).norm();
        const Real expected = block.dimension() == 3 ? F.determinant() : block.dimension() == 2 ? area : length;
        CHECK(block.smallest_cell(moved(block.rest(), F)) == Approx(expected));
        CHECK(block.smallest_cell(block.rest()) == Approx(1));
    }
    const SpringBlock cube(SpringLattice(LatticeKind::cubic_face, {2, 2, 2}, 0.1));
    CHECK(cube.smallest_cell(moved(cube.rest(), Vec<3>(1, -1, 1).asDiagonal())) == Approx(-1));
}

TEST_CASE("cloth sheets: mass, area and energy do not depend on how they lie", "[nets]") {
    ClothSheet sheet(9, 0.8);
    sheet.set_springs({1000, 100, 10}, 0.1);
    sheet.set_mass(0.2, {3, 5});
    CHECK(sheet.mass().sum() == Approx(0.2));
    CHECK(sheet.inertia().fixed(15));
    CHECK_FALSE(sheet.inertia().fixed(0));
    Real area = 0;
    for (const NodeTriple& t : sheet.triangles()) {
        const Vec<3> a = sheet.rest().col(t[1]) - sheet.rest().col(t[0]), b = sheet.rest().col(t[2]) - sheet.rest().col(t[0]);
        area += 0.5 * a.cross(b).norm();
    }
    CHECK(area == Approx(0.64));

    const Points<3> x = moved(sheet.rest(), some_stretch());
    Real sum = 0;
    for (const SpringFamily family : {structural, shear, bending}) {
        const Mat<3> turn = Eigen::AngleAxisd(0.7, Vec<3>(1, 2, -1).normalized()).toRotationMatrix();
        CHECK(sheet.energy(family, x) > 0);
        CHECK(sheet.energy(family, moved(x, turn)) == Approx(sheet.energy(family, x)));
        CHECK(sheet.energy(family, sheet.rest()) < 1e-20);
        sum += sheet.energy(family, x);
    }
    CHECK(sum == Approx(spring_energy<3>(sheet.springs(), x)));
    for (Index n = 0; n < sheet.rest().cols(); ++n)
        for (const Index s : sheet.springs_of(n)) CHECK((sheet.springs().i(s) == n || sheet.springs().j(s) == n));
}

TEST_CASE("cloth sheets: the shadow of a tilted sheet is that of a rectangle", "[nets]") {
    const ClothSheet sheet(6, 0.5);
    const Mat<3> level = Eigen::AngleAxisd(-std::numbers::pi / 2, Vec<3>::UnitX()).toRotationMatrix();
    for (const Real angle : {0.0, 0.4, 1.2}) {
        const Mat<3> tilt = Eigen::AngleAxisd(angle, Vec<3>::UnitX()).toRotationMatrix();
        CHECK(sheet.shadow(moved(sheet.rest(), tilt * level)) == Approx(0.25 * std::cos(angle)));
    }
    CHECK(sheet.shadow(sheet.rest()) < 1e-15);  // upright
}

TEST_CASE("levels of a sheet: their correction is a symmetric, positive operator", "[nets]") {
    constexpr Index nodes_x = 9, nodes_y = 13, nodes = nodes_x * nodes_y;
    SheetLevels levels(nodes_x, nodes_y);
    const SymmetricBlock spring{.xx = 3, .xy = 0.2, .xz = -0.1, .yy = 2, .yz = 0.3, .zz = 1};
    const SymmetricBlock own{.xx = 0.1, .xy = 0, .xz = 0, .yy = 0.1, .yz = 0, .zz = 0.1};
    levels.prepare(std::vector(nodes, spring), std::vector(nodes, own));
    const auto applied = [&](const VecX& r) {
        VecX z = VecX::Zero(3 * nodes);
        levels.add_corrections(r, z);
        return z;
    };
    std::srand(7);
    const VecX a = VecX::Random(3 * nodes), b = VecX::Random(3 * nodes);
    CHECK(a.dot(applied(b)) == Approx(b.dot(applied(a))).epsilon(1e-9));
    CHECK(a.dot(applied(a)) > 0);
    CHECK((applied(a + 2 * b) - applied(a) - 2 * applied(b)).norm() < 1e-9 * applied(b).norm());
}

TEST_CASE("blocks of three by three: an inverse, or none where it is not positive", "[nets]") {
    const SymmetricBlock block{.xx = 3, .xy = 0.2, .xz = -0.1, .yy = 2, .yz = 0.3, .zz = 1};
    SymmetricBlock inverse;
    REQUIRE(invert(block, inverse));
    const Vec<3> in(0.3, -1.2, 0.7);
    Vec<3> there = Vec<3>::Zero(), back = Vec<3>::Zero();
    add_product(block, in.data(), there.data());
    add_product(inverse, there.data(), back.data());
    CHECK((back - in).norm() < 1e-14);
    CHECK_FALSE(invert({.xx = 1, .xy = 2, .xz = 0, .yy = 1, .yz = 0, .zz = 1}, inverse));
    CHECK_FALSE(invert({}, inverse));
}

TEST_CASE("static tests: a solid between plates that let it slide is pulled as a bar is", "[nets]") {
    const SpringLattice cube(LatticeKind::cubic_face, {3, 6, 2}, 0.1), sheet(LatticeKind::square, {3, 6, 1}, 0.1);
    for (const Real nu : {0.0, 0.3}) {
        // K = E A / L: 0.3 m × 0.2 m, and a sheet of 0.3 m that is 0.1 m thick.
        CHECK(test_continuum(cube, 2000, nu, BlockTest::stretch).stiffness == Approx(2000 * 0.06 / 0.6));
        CHECK(test_continuum(sheet, 2000, nu, BlockTest::stretch).stiffness == Approx(2000 * 0.03 / 0.6));
    }
    const Points<3> u = test_continuum(sheet, 2000, 0.3, BlockTest::stretch).displacement;
    CHECK(u.row(1).maxCoeff() - u.row(1).minCoeff() == Approx(1));
    CHECK(u.row(0).maxCoeff() - u.row(0).minCoeff() == Approx(0.3 * 0.3 / 0.6));  // ν, of the width over the length
    const SpringLattice chain(LatticeKind::chain, {1, 4, 1}, 0.1);
    CHECK_THROWS_AS(test_continuum(chain, 2000, 0.3, BlockTest::stretch), Refused);
}

TEST_CASE("static tests: a beam that is bent comes to E I / L as it is refined", "[nets]") {
    const auto error = [](Index cells) {
        const SpringLattice beam(LatticeKind::square, {cells, 4 * cells, 1}, 0.1 / Real(cells));
        const Real inertia = std::pow(0.1, 3) / 12 * beam.edge();
        return test_continuum(beam, 1e4, 0, BlockTest::bend).stiffness / (1e4 * inertia / 0.4) - 1;
    };
    CHECK(error(2) > 0);
    CHECK(error(4) / error(8) == Approx(4).epsilon(0.15));
    CHECK(error(8) < 0.05);
}

TEST_CASE("static tests: couplings of the families add up to 1, and a shared piece is the endless lattice", "[nets]") {
    for (const LatticeKind kind : {LatticeKind::cubic_face, LatticeKind::square, LatticeKind::triangular, LatticeKind::chain}) {
        const StaticTests::Key key{.kind = kind,
                                   .cells = {3, 4, 3},
                                   .edge = 0.1,
                                   .stiffness = {200, 100, 20},
                                   .shared = true,
                                   .poisson_ratio = 0.25,
                                   .test = BlockTest::stretch};
        const SpringLattice lattice(kind, key.cells, key.edge);
        StaticTests tests;
        CHECK_FALSE(tests.knows(key));
        tests.run(lattice, key);
        CHECK(tests.knows(key));
        const int rows = kind == LatticeKind::chain ? 1 : 3;
        for (int row = 0; row < rows; ++row) CHECK(tests.coupling().row(row).sum() == Approx(1).epsilon(1e-9));
        CHECK(tests.continuum().has_value() == (kind != LatticeKind::chain));
        CHECK((tests.coupling().row(0).transpose() - Vec<3>(tests.response().coupling.data())).norm() < 1e-12);
    }
}

TEST_CASE("static tests: without bending springs shared pieces of any size have the modulus of the endless lattice", "[nets]") {
    for (const LatticeKind kind : {LatticeKind::cubic_face, LatticeKind::square}) {
        const StaticTests::Key key{.kind = kind, .cells = {2, 2, 2}, .edge = 0.1, .stiffness = {200, 100, 0}, .shared = true};
        StaticTests tests;
        tests.run(SpringLattice(kind, key.cells, key.edge), key);
        REQUIRE(tests.modulus_by_cells().size() == StaticTests::most_cells);
        for (const Real ratio : tests.modulus_by_cells()) CHECK(ratio == Approx(1).epsilon(1e-9));
    }
    const SpringLattice sheet(LatticeKind::square, {2, 2, 1}, 0.1), cube(LatticeKind::cubic_face, {2, 2, 2}, 0.1);
    CHECK(StaticTests().modulus_in_pascal(30, sheet) == Approx(300));
    CHECK(StaticTests().modulus_in_pascal(30, cube) == 30);
}
