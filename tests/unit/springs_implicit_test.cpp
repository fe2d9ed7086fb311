// The implicit solver on spring nets: extremes, reports, stepping by iteration, equal bits.
#include "spring_body.h"

#include <pliant/math/error.h>
#include <pliant/mesh/lattice.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

std::vector<Spring> block_springs(const NodeLattice<3>& lattice, Real stiffness, Real damping) {
    std::vector<Spring> list;
    append_springs<3>(lattice.points(), lattice.structural(), stiffness, damping, list);
    append_springs<3>(lattice.points(), lattice.face_diagonals(), stiffness, damping, list);
    append_springs<3>(lattice.points(), lattice.bending(), stiffness, damping, list);
    return list;
}

struct Block {
    explicit Block(Real stiffness, Real node_mass, Real damping = 0, const std::vector<Index>& fixed = {})
        : lattice({2, 2, 2}, Vec<3>::Constant(0.1)),
          body(lattice.points(), block_springs(lattice, stiffness, damping), VecX::Constant(lattice.node_count(), node_mass),
               fixed) {
        body.system.damping = damping > 0 ? SpringDamping::projected : SpringDamping::none;
    }
    NodeLattice<3> lattice;
    SpringBody<3> body;
};

}  // namespace

TEST_CASE("implicit Euler stays finite where springs are 1e15 times too stiff for an explicit step", "[springs][implicit]") {
    const Real dt = 1e-2;
    Block block(1e12, 1e-3);
    SpringBody<3>& body = block.body;
    body.system.load.gravity = {0, -9.81, 0};
    body.v.col(0) << 1, 0.5, -0.3;
    const Vec<3> p = momentum<3>(body.mass, body.v);
    body.run(Scheme::implicit_euler, dt, 100);
    CHECK(body.x.allFinite());
    CHECK(body.v.allFinite());
    // It falls and drifts as a whole, and keeps its shape.
    const Vec<3> expected = p + 100 * dt * body.mass.sum() * Vec<3>(0, -9.81, 0);
    CHECK((momentum<3>(body.mass, body.v) - expected).norm() < 1e-6 * expected.norm());
    VecX strain(body.springs.size());
    spring_strain<3>(body.springs, body.x, strain);
    CHECK(strain.cwiseAbs().maxCoeff() < 1e-6);

    // The limit that an explicit scheme would be told.
    const SpringRates rates = spring_rate_estimates<3>(body.springs, body.inertia, SpringDamping::none, body.x);
    CHECK(stability_limit(Scheme::semi_implicit_euler, rates) < 1e-7);
}

TEST_CASE("one stiff spring from rest and from a wild start", "[springs][implicit]") {
    SpringBody<2> body(Points<2>::Identity(2, 2), {{0, 1, 0.5, 1e12}}, VecX::Constant(2, 1e-3), {0});
    body.v.col(1) << 300, -200;
    body.run(Scheme::implicit_euler, 1e-2, 20);
    CHECK(body.x.allFinite());
    CHECK_THAT((body.x.col(1) - body.x.col(0)).norm(), WithinRel(0.5, 1e-6));
}

TEST_CASE("implicit Euler conserves the momentum of a free body and only loses energy", "[springs][implicit]") {
    Block block(2e3, 0.01, GENERATE(0.0, 0.5));
    SpringBody<3>& body = block.body;
    body.x.col(13) += Vec<3>(0.03, -0.04, 0.02);
    body.v.row(0).setConstant(0.3);
    const Vec<3> p = momentum<3>(body.mass, body.v);
    Real energy = body.energy();
    for (int n = 0; n < 100; ++n) {
        body.step(Scheme::implicit_euler, 0.01);
        CHECK(body.energy() <= energy * (1 + 1e-9));
        energy = body.energy();
    }
    CHECK((momentum<3>(body.mass, body.v) - p).norm() < 1e-10 * p.norm());
}

TEST_CASE("a crushed block comes back at a large step, at quadratic cost near the end", "[springs][implicit]") {
    Block block(1e4, 0.01, 0.1);
    SpringBody<3>& body = block.body;
    body.x *= 0.3;
    for (int n = 0; n < 50; ++n) {
        body.step(Scheme::implicit_euler, 0.05);
        CHECK(body.solver().iterations() <= 40);
    }
    CHECK(body.solver().iterations() <= 3);
    VecX strain(body.springs.size());
    spring_strain<3>(body.springs, body.x, strain);
    CHECK(strain.cwiseAbs().maxCoeff() < 1e-3);
}

TEST_CASE("a net collapsed to a point does not break the solver", "[springs][implicit]") {
    Block block(1e3, 0.01);
    block.body.x.setConstant(0.05);
    block.body.run(Scheme::implicit_euler, 0.01, 3);
    CHECK(block.body.x.allFinite());
}

TEST_CASE("a step can be made iteration by iteration, with the same result", "[springs][implicit]") {
    const auto prepare = [](SpringBody<3>& body) {
        body.x.col(5) += Vec<3>(0.02, 0.03, 0);
        body.system.load.gravity = {0, -9.81, 0};
    };
    Block whole(1e4, 0.01, 1), parts(1e4, 0.01, 1);
    prepare(whole.body), prepare(parts.body);
    whole.body.step(Scheme::implicit_euler, 0.01);

    SpringBody<3>& body = parts.body;
    implicit_euler(0.01, flat(body.x), flat(body.v), body.solver().form());
    body.solver().begin(flat(body.x));
    Real first = 0;
    int passes = 0;
    for (; body.solver().again(); ++passes) {
        body.solver().iterate();
        if (passes == 0) first = body.solver().residual();
    }
    CHECK(body.solver().residual() < 1e-6 * first);
    CHECK(passes == body.solver().iterations());
    CHECK(passes >= 2);
    CHECK(body.solver().converged());
    body.solver().finish(flat(body.x), flat(body.v));
    CHECK(body.x == whole.body.x);
    CHECK(body.v == whole.body.v);

    // The solution satisfies M (v' - v) = dt f(x', v'), damping along the directions of the start.
    Points<3> f(3, body.x.cols());
    body.system.force(flat(body.x), flat(body.v), flat(f));
    const Points<3> balance = 0.01 * body.v - 0.01 * f;
    CHECK(balance.norm() < 1e-9 * (0.01 * f).norm());
}

TEST_CASE("a solver that hits its cap says so and leaves the state alone", "[springs][implicit]") {
    Block block(1e4, 0.01);
    SpringBody<3>& body = block.body;
    body.x *= 0.5;
    const Points<3> start = body.x;
    ImplicitSolver capped(body.system, body.inertia, {1e-9, 1});
    implicit_euler(0.05, flat(body.x), flat(body.v), capped.form());
    capped.begin(flat(body.x));
    while (capped.again()) capped.iterate();
    CHECK_FALSE(capped.converged());
    CHECK_THROWS_AS(capped.finish(flat(body.x), flat(body.v)), Diverged);
    CHECK_THROWS_WITH(capped.finish(flat(body.x), flat(body.v)),
                      ContainsSubstring("1 iterations") && ContainsSubstring("residual"));
    CHECK(body.x == start);

    body.v(0, 0) = std::numeric_limits<Real>::quiet_NaN();
    CHECK_THROWS_AS(body.step(Scheme::implicit_euler, 0.01), Diverged);
}

TEST_CASE("a mass ratio of a million between neighbours", "[springs][implicit]") {
    SpringBody<2> body(Points<2>::Identity(2, 2), {{0, 1, 1, 1e3}}, Vec<2>(1e-3, 1e3));
    body.v.col(0) << 1, 0;
    const Vec<2> p = momentum<2>(body.mass, body.v);
    body.run(Scheme::implicit_euler, 0.01, 200);
    CHECK(body.x.allFinite());
    // Velocities are differences of positions near 1 m, whose rounding the heavy mass turns into 2e-11 kg m/s per step.
    CHECK((momentum<2>(body.mass, body.v) - p).norm() < 200 * 2.3e-11);
    CHECK(body.solver().residual() < 1e-6);
}

TEST_CASE("a pull reaches its static balance in the implicit solve", "[springs][implicit]") {
    SpringBody<2> body(Points<2>::Zero(2, 2), {{0, 1, 0, 30}}, VecX::Ones(2), {0});
    body.system.load.pull = {1, {2, -1}, 10};
    body.step(Scheme::implicit_euler, 1e6);
    CHECK(body.x.col(1).isApprox(Vec<2>(0.5, -0.25), 1e-9));
}

TEST_CASE("the same start gives the same bits", "[springs][implicit]") {
    const Scheme scheme = GENERATE(Scheme::explicit_euler, Scheme::semi_implicit_euler, Scheme::implicit_euler);
    const auto run = [&] {
        Block block(500, 0.05, 0.2, {0, 2});
        block.body.system.load.gravity = {0, -9.81, 0};
        block.body.run(scheme, 1e-3, 100);
        return std::pair(block.body.x, block.body.v);
    };
    CHECK(run() == run());
}
