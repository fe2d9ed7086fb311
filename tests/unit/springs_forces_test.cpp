// Spring and damping forces: analytic values, consistency of energy, force and Jacobian, conservation, refusals.
#include "spring_body.h"

#include <pliant/math/dense_matrix.h>
#include <pliant/math/error.h>
#include <pliant/mesh/lattice.h>

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>
#include <random>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

template <int Dim>
Points<Dim> random_points(Index count, unsigned seed, Real scale) {
    std::mt19937 random(seed);
    return Points<Dim>::NullaryExpr(Dim, count, [&] { return scale * (Real(random()) / Real(random.max()) - 0.5); });
}

// A small block with springs of all families, its nodes pushed about at random: stretched and compressed springs.
template <int Dim>
struct ShakenBlock {
    explicit ShakenBlock(Real length_unit = 1) {
        std::array<Index, Dim> cells;
        cells.fill(2);
        const NodeLattice<Dim> lattice(cells, Vec<Dim>::Constant(0.5 * length_unit));
        const Points<Dim> rest = lattice.points();
        append_springs<Dim>(rest, lattice.structural(), 100, 0.7, list);
        append_springs<Dim>(rest, lattice.face_diagonals(), 40, 0.3, list);
        append_springs<Dim>(rest, lattice.bending(), 15, 0.1, list);
        x = rest + random_points<Dim>(rest.cols(), 1, 0.4 * length_unit);
        v = random_points<Dim>(rest.cols(), 2, 2 * length_unit);
    }
    std::vector<Spring> list;
    Points<Dim> x, v;
};

template <int Dim>
void check_gradient_and_jacobian() {
    ShakenBlock<Dim> block;
    const Springs springs(block.x.cols(), block.list);
    SpringMatrix<Dim> matrix(springs);
    matrix.add_stiffness(springs, block.x, SpringCurvature::exact);
    const MatX K = matrix.matrix();
    CHECK((K - K.transpose()).norm() == 0);

    Points<Dim> f = Points<Dim>::Zero(Dim, block.x.cols());
    add_spring_forces<Dim>(springs, block.x, f);
    const Real h = 1e-6;
    for (Index d = 0; d < block.x.size(); ++d) {
        Points<Dim> ahead = block.x, behind = block.x, f_ahead = Points<Dim>::Zero(Dim, f.cols()), f_behind = f_ahead;
        ahead.data()[d] += h, behind.data()[d] -= h;
        add_spring_forces<Dim>(springs, ahead, f_ahead);
        add_spring_forces<Dim>(springs, behind, f_behind);
        const Real slope = (spring_energy<Dim>(springs, ahead) - spring_energy<Dim>(springs, behind)) / (2 * h);
        CHECK_THAT(slope, WithinAbs(-f.data()[d], 1e-7 * f.norm()));
        const VecX column = -flat((f_ahead - f_behind).eval()) / (2 * h);
        CHECK((column - K.col(d)).norm() < 1e-8 * K.norm());
    }
}

}  // namespace

TEST_CASE("a spring pulls with k (|x_ij| - l) along itself", "[springs]") {
    const Springs springs(2, {{0, 1, 2, 10}});
    Points<2> x(2, 2), f = Points<2>::Zero(2, 2);
    x << 1, 4, 1, 5;  // length 5
    add_spring_forces<2>(springs, x, f);
    CHECK(f.col(0).isApprox(Vec<2>(18, 24), 1e-15));
    CHECK(f.col(1) == -f.col(0));
    CHECK_THAT(spring_energy<2>(springs, x), WithinRel(45, 1e-15));

    VecX tension(1), strain(1);
    spring_tension<2>(springs, x, tension);
    spring_strain<2>(springs, x, strain);
    CHECK_THAT(tension[0], WithinRel(30, 1e-15));
    CHECK_THAT(strain[0], WithinRel(1.5, 1e-15));
}

TEST_CASE("a spring of length 0 pulls with no force, one of rest length 0 with k x", "[springs]") {
    const Springs springs(3, {{0, 1, 1, 10, 2}, {1, 2, 0, 10, 2}});
    Points<2> x = Points<2>::Zero(2, 3), v = x, f = x;
    v(0, 1) = 1;
    add_spring_forces<2>(springs, x, f);
    add_damping_forces<2>(springs, SpringDamping::projected, x, v, f);
    CHECK(f.isZero(0));

    x.col(2) << 3, -4;
    add_spring_forces<2>(springs, x, f);
    CHECK(f.col(2).isApprox(Vec<2>(-30, 40), 1e-15));

    VecX strain(2);
    spring_strain<2>(springs, x, strain);
    CHECK(strain == VecX(Vec<2>(-1, 0)));

    SpringMatrix<2> matrix(springs);
    matrix.add_stiffness(springs, x, SpringCurvature::exact);
    matrix.add_damping(springs, SpringDamping::projected, x, 1);
    CHECK(MatX(matrix.matrix()).allFinite());
    CHECK_THAT(matrix.matrix().coeff(4, 4), WithinRel(10 + 2 * 0.36, 1e-14));
}

TEST_CASE("forces are the energy's negative gradient and -K their derivative, in 2D and 3D", "[springs]") {
    check_gradient_and_jacobian<2>();
    check_gradient_and_jacobian<3>();
}

TEST_CASE("the Jacobian of stretched, compressed and crossed springs and of rest length 0 is exact", "[springs]") {
    // Three springs after another: odd counts have one that is left over.
    const Springs springs(4, {{0, 1, 0.5, 30}, {1, 2, 0, 20}, {2, 3, 3, 40}});
    Points<2> x(2, 4);
    x << 0, 1, 1.5, 2, 0, 0.2, -0.3, 0.1;
    SpringMatrix<2> matrix(springs);
    matrix.add_stiffness(springs, x, SpringCurvature::exact);
    const MatX K(matrix.matrix());
    const auto force = [&](const Points<2>& at) {
        Points<2> f = Points<2>::Zero(2, 4);
        add_spring_forces<2>(springs, at, f);
        return f;
    };
    const Real h = 1e-6;
    for (Index d = 0; d < x.size(); ++d) {
        Points<2> ahead = x, behind = x;
        ahead.data()[d] += h, behind.data()[d] -= h;
        CHECK((flat((force(behind) - force(ahead)).eval()) / (2 * h) - K.col(d)).norm() < 1e-8 * K.norm());
    }
    // Of a spring of length 0 only the one of rest length 0 has a stiffness, k I.
    x.col(2) = x.col(1), x.col(3) = x.col(2), x.col(0) = x.col(1);
    CHECK(force(x).isZero(0));
    matrix.set_zero();
    matrix.add_stiffness(springs, x, SpringCurvature::exact);
    CHECK(MatX(matrix.matrix()).block(2, 2, 2, 2).isApprox(20 * Mat<2>::Identity(), 0));
    CHECK(MatX(matrix.matrix()).block(0, 0, 2, 2).isZero(0));
}

TEST_CASE("the positive curvature is positive semidefinite where the exact one is not", "[springs]") {
    ShakenBlock<3> block;
    const Springs springs(block.x.cols(), block.list);
    const auto lowest = [&](SpringCurvature curvature, const Points<3>& x) {
        SpringMatrix<3> matrix(springs);
        matrix.add_stiffness(springs, x, curvature);
        const VecX values = dense_eigen(MatX(matrix.matrix())).values;
        return values.minCoeff() / values.maxCoeff();
    };
    const Points<3> crushed = 0.6 * block.x, stretched = 3 * block.x;
    CHECK(lowest(SpringCurvature::exact, crushed) < -0.01);
    CHECK(lowest(SpringCurvature::positive, crushed) > -1e-12);

    // Springs that are all in tension have no negative curvature to remove.
    SpringMatrix<3> exact(springs), positive(springs);
    exact.add_stiffness(springs, stretched, SpringCurvature::exact);
    positive.add_stiffness(springs, stretched, SpringCurvature::positive);
    CHECK(MatX(exact.matrix()).isApprox(MatX(positive.matrix()), 0));
}

TEST_CASE("the damping matrix gives the damping forces and their power", "[springs]") {
    const SpringDamping mode = GENERATE(SpringDamping::none, SpringDamping::naive, SpringDamping::projected);
    ShakenBlock<3> block;
    const Springs springs(block.x.cols(), block.list);
    SpringMatrix<3> matrix(springs);
    matrix.add_damping(springs, mode, block.x, 1);
    Points<3> f = Points<3>::Zero(3, block.x.cols());
    add_damping_forces<3>(springs, mode, block.x, block.v, f);
    const VecX expected = matrix.matrix() * flat(block.v);
    CHECK((expected + flat(f)).norm() <= 1e-13 * expected.norm());
    CHECK_THAT(damping_power<3>(springs, mode, block.x, block.v), WithinRel(flat(block.v).dot(expected), 1e-12));
    CHECK((mode == SpringDamping::none) == (expected.norm() == 0));
}

TEST_CASE("filling the matrix again gives the same values in the same places", "[springs]") {
    ShakenBlock<2> block;
    const Springs springs(block.x.cols(), block.list);
    SpringMatrix<2> matrix(springs);
    matrix.add_stiffness(springs, block.x, SpringCurvature::exact);
    const SparseMatrix first = matrix.matrix();
    const Real* values = matrix.matrix().valuePtr();
    matrix.set_zero();
    matrix.add_stiffness(springs, block.x, SpringCurvature::exact);
    CHECK(matrix.matrix().valuePtr() == values);
    CHECK(matrix.matrix().coeffs().matrix() == first.coeffs().matrix());
}

TEST_CASE("internal forces change neither momentum nor, unless damped naively, angular momentum", "[springs]") {
    ShakenBlock<3> block;
    const SpringDamping mode = GENERATE(SpringDamping::none, SpringDamping::naive, SpringDamping::projected);
    VecX masses = VecX::LinSpaced(block.x.cols(), 0.1, 2);
    SpringBody<3> body(block.x, block.list, masses);
    body.v = block.v;
    body.system.damping = mode;
    const Vec<3> p = momentum<3>(body.mass, body.v), l = angular_momentum<3>(body.mass, body.x, body.v);
    body.run(Scheme::semi_implicit_euler, 1e-3, 1000);
    const Real speed = kinetic_energy<3>(body.mass, body.v);
    CHECK((momentum<3>(body.mass, body.v) - p).norm() < 1e-11);
    const Real change = (angular_momentum<3>(body.mass, body.x, body.v) - l).norm() / l.norm();
    if (mode == SpringDamping::naive)
        CHECK(change > 0.1);
    else
        CHECK(change < 1e-11);
    CHECK(speed > 0);
}

TEST_CASE("projected damping leaves a rigidly rotating pair its energy, naive damping drains it", "[springs]") {
    const Real omega = 3, damping = 0.2;
    Points<2> x(2, 2), v(2, 2);
    x << -0.5, 0.5, 0, 0;
    v << 0, 0, -0.5 * omega, 0.5 * omega;
    const Springs springs(2, {{0, 1, 1, 100, damping}});
    CHECK(damping_power<2>(springs, SpringDamping::projected, x, v) == 0);
    CHECK_THAT(damping_power<2>(springs, SpringDamping::naive, x, v), WithinRel(damping * omega * omega, 1e-14));

    // Over time: a pair spun at a length at which its tension holds it, so that it turns without oscillating.
    const auto kept = [&](SpringDamping mode) {
        const Real k = 1e4, length = 1 / (1 - omega * omega / (2 * k));  // k (L - 1) = m omega^2 L/2
        SpringBody<2> body(length * x, {{0, 1, 1, k, damping}}, VecX::Ones(2));
        body.v = length * v;
        body.system.damping = mode;
        const Real start = kinetic_energy<2>(body.mass, body.v);
        body.run(Scheme::semi_implicit_euler, 1e-4, 20000);
        return kinetic_energy<2>(body.mass, body.v) / start;
    };
    CHECK_THAT(kept(SpringDamping::none), WithinAbs(1, 1e-4));
    CHECK_THAT(kept(SpringDamping::projected), WithinAbs(1, 1e-4));
    // Naive damping slows the pair down as exp(-2 k_d t/m) in speed, so exp(-4 k_d t/m) in energy.
    CHECK_THAT(kept(SpringDamping::naive), WithinAbs(std::exp(-4 * damping * 2), 1e-3));
}

TEST_CASE("a rigid rotation of the rest shape loads no spring", "[springs]") {
    const NodeLattice<3> lattice({2, 2, 2}, Vec<3>::Constant(0.3));
    std::vector<Spring> list;
    append_springs<3>(lattice.points(), lattice.structural(), 1e5, 0, list);
    append_springs<3>(lattice.points(), lattice.face_diagonals(), 1e5, 0, list);
    const Springs springs(lattice.node_count(), list);
    const Points<3> turned = Eigen::AngleAxisd(2.5, Vec<3>(1, 2, -1).normalized()).toRotationMatrix() * lattice.points();
    CHECK(spring_energy<3>(springs, turned) < 1e-24);
}

TEST_CASE("another unit of length gives the same motion", "[springs]") {
    const Scheme scheme = GENERATE(Scheme::semi_implicit_euler, Scheme::implicit_euler);
    const Real unit = GENERATE(1e-6, 1e6);
    const auto run = [&](Real length_unit) {
        ShakenBlock<3> block(length_unit);
        SpringBody<3> body(block.x, block.list, VecX::Constant(block.x.cols(), 0.5));
        body.v = block.v;
        body.system.damping = SpringDamping::projected;
        body.system.load.gravity = {0, -9.81 * length_unit, 0};
        body.system.load.pull = {3, Vec<3>::Constant(length_unit), 20};
        body.run(scheme, 0.01, 50);
        return (body.x / length_unit).eval();
    };
    const Points<3> reference = run(1), other = run(unit);
    CHECK((other - reference).norm() < 1e-6 * reference.norm());
}

TEST_CASE("springs that make no sense are refused by name", "[springs]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinite = std::numeric_limits<Real>::infinity();
    const auto with = [](Spring spring) { return [spring] { Springs(4, {{0, 1, 1, 1}, spring}); }; };
    CHECK_THROWS_WITH(with({2, 2, 1, 1})(), ContainsSubstring("spring 1") && ContainsSubstring("itself"));
    CHECK_THROWS_WITH(with({2, 4, 1, 1})(), ContainsSubstring("spring 1") && ContainsSubstring("node 4"));
    CHECK_THROWS_WITH(with({-1, 2, 1, 1})(), ContainsSubstring("node -1"));
    CHECK_THROWS_WITH(with({1, 0, 1, 1})(), ContainsSubstring("spring 1") && ContainsSubstring("spring 0"));
    for (const Real bad : {-1.0, nan, infinite}) {
        CHECK_THROWS_WITH(with({2, 3, bad, 1})(), ContainsSubstring("rest_length"));
        CHECK_THROWS_WITH(with({2, 3, 1, bad})(), ContainsSubstring("stiffness"));
        CHECK_THROWS_WITH(with({2, 3, 1, 1, bad})(), ContainsSubstring("damping"));
        CHECK_THROWS_AS(with({2, 3, bad, 1})(), Refused);
    }
    Springs springs(2, {{0, 1, 1, 1}});
    CHECK_THROWS_AS(springs.set_stiffness(0, 2, 1), Refused);
    CHECK_THROWS_AS(springs.set_stiffness(0, 1, -1), Refused);
    CHECK_THROWS_AS(springs.set_damping(0, 1, nan), Refused);
    CHECK_THROWS_WITH(require_finite("position", "m", Points<2>::Constant(2, 1, nan)), ContainsSubstring("position[0]"));
}
