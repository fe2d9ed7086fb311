// A spring body that lands and rests on the ground; the bounded quadratic model behind its implicit steps.
#include "spring_body.h"

#include <pliant/mesh/lattice.h>
#include <pliant/solids/contact.h>
#include <pliant/time/bounded_quadratic.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <random>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

std::vector<Spring> jelly_springs(const NodeLattice<3>& lattice, Real k) {
    std::vector<Spring> list;
    append_springs<3>(lattice.points(), lattice.structural(), k, 0, list);
    append_springs<3>(lattice.points(), lattice.face_diagonals(), k / 2, 0, list);
    return list;
}

// A block of 3 x 3 x 3 nodes and 1 kg that starts with its base at `height`.
struct Jelly {
    Jelly(Real k, Real height)
        : lattice({2, 2, 2}, Vec<3>::Constant(0.1), {0, height, 0}),
          body(lattice.points(), jelly_springs(lattice, k), VecX::Constant(27, 1.0 / 27)) {
        body.system.load.gravity = {0, -9.81, 0};
    }
    void implicit_step(Real dt) {
        contact.begin(dt, body.x, body.v);
        set_ground_bounds<3>(ground, body.x, body.integrator.lower_bound());
        body.step(Scheme::implicit_euler, dt);
        contact.arrest(body.integrator, body.inertia);
        touching = contact.resolve(ground, body.inertia, Scheme::implicit_euler, body.force(), body.x, body.v);
    }
    void explicit_step(Real dt) {
        contact.begin(dt, body.x, body.v);
        body.step(Scheme::semi_implicit_euler, dt);
        touching = contact.resolve(ground, body.inertia, Scheme::semi_implicit_euler, body.force(), body.x, body.v);
    }
    Ground ground;
    NodeLattice<3> lattice;
    SpringBody<3> body;
    GroundContact<3> contact;
    Index touching = 0;
};

}  // namespace

TEST_CASE("an implicit step rests in the static balance, whatever the time step", "[springs][contact]") {
    const Real k = GENERATE(300.0, 1e6);
    const auto settled = [&](Real dt, int steps) {
        Jelly jelly(k, 0);
        for (int n = 0; n < steps; ++n) jelly.implicit_step(dt);
        CHECK(kinetic_energy<3>(jelly.body.mass, jelly.body.v) < 1e-10);
        // The ground carries the weight: the speeds that it takes are dt g sum(m) / m.
        Real impulse = 0;
        for (const Real speed : jelly.contact.arrested()) impulse += speed / 27;
        CHECK_THAT(impulse / dt, WithinRel(9.81, 1e-6));
        return spring_energy<3>(jelly.body.springs, jelly.body.x);
    };
    const Real fine = settled(0.01, 1000), coarse = settled(0.1, 400);
    CHECK(fine > 0);
    CHECK_THAT(coarse, WithinRel(fine, 1e-3));
}

TEST_CASE("a body falls onto the ground, does not pass it, and gains no energy there", "[springs][contact]") {
    const bool implicit = GENERATE(true, false);
    Jelly jelly(300, 0.1);
    jelly.ground.restitution = implicit ? 0 : 0.5;
    Real energy = jelly.body.energy();
    bool touched = false;
    for (int n = 0; n < 1000; ++n) {
        implicit ? jelly.implicit_step(2e-3) : jelly.explicit_step(2e-4);
        CHECK(jelly.body.x.row(1).minCoeff() >= 0);
        touched = touched || jelly.touching > 0;
    }
    CHECK(touched);
    CHECK(jelly.body.energy() < energy);
}

TEST_CASE("a body of very stiff springs lands on a corner in few iterations", "[springs][contact]") {
    Jelly jelly(1e12, 0.05);
    jelly.body.v.col(0) << 1, 2, 3;
    for (int n = 0; n < 100; ++n) {
        jelly.implicit_step(0.01);
        CHECK(jelly.body.solver().iterations() <= 20);
        CHECK(jelly.body.x.row(1).minCoeff() >= 0);
    }
    VecX strain(jelly.body.springs.size());
    spring_strain<3>(jelly.body.springs, jelly.body.x, strain);
    CHECK(strain.cwiseAbs().maxCoeff() < 1e-6);
    CHECK(kinetic_energy<3>(jelly.body.mass, jelly.body.v) < 1e-3);
}

TEST_CASE("an implicit step rebounds with the restitution of the speed that it met the ground with", "[springs][contact]") {
    SpringBody<2> body(Points<2>(Vec<2>(0, 0.001)), {}, VecX::Ones(1));
    const Ground ground{0, 0.6, 0.5};
    body.v.col(0) << 3, -2;
    GroundContact<2> contact;
    contact.begin(0.01, body.x, body.v);
    set_ground_bounds<2>(ground, body.x, body.integrator.lower_bound());
    body.step(Scheme::implicit_euler, 0.01);
    CHECK(body.x(1, 0) == 0);
    CHECK_THAT(body.v(1, 0), WithinRel(-0.1, 1e-12));  // what takes it to the ground
    contact.arrest(body.integrator, body.inertia);
    CHECK_THAT(contact.arrested()[0], WithinRel(1.9, 1e-12));
    contact.resolve(ground, body.inertia, Scheme::implicit_euler, body.force(), body.x, body.v);
    CHECK_THAT(body.v(1, 0), WithinRel(0.6 * 2.0, 1e-12));
    CHECK_THAT(body.v(0, 0), WithinRel(3 - 0.5 * 1.6 * 2.0, 1e-12));
}

TEST_CASE("the minimum of a bounded quadratic satisfies the optimality conditions", "[integrators]") {
    std::mt19937 random(GENERATE(1u, 2u, 3u, 4u));
    const auto number = [&] { return Real(random()) / Real(random.max()) - 0.5; };
    const Index n = 40;
    // A chain of stiff springs with springs of their own to the ground, pushed at random.
    MatX H = MatX::Zero(n, n);
    for (Index i = 0; i < n; ++i) H(i, i) += 0.1;
    for (Index i = 0; i + 1 < n; ++i) H(i, i) += 50, H(i + 1, i + 1) += 50, H(i, i + 1) -= 50, H(i + 1, i) -= 50;
    const VecX g = VecX::NullaryExpr(n, [&] { return 0.3 + number(); }),
               lower = VecX::NullaryExpr(n, [&] { return -0.2 * (number() + 0.5); });
    std::vector<char> fixed(n, 0);
    fixed[7] = 1;

    BoundedQuadratic model(fixed);
    model.set_matrix(H.sparseView());
    VecX d(n);
    REQUIRE(model.minimise(g, lower, d));
    const VecX slope = g + H * d;
    Index active = 0;
    for (Index i = 0; i < n; ++i) {
        if (i == 7) {
            CHECK(d[i] == 0);
            continue;
        }
        CHECK(d[i] >= lower[i]);
        CHECK(slope[i] > -1e-10);
        CHECK_THAT(slope[i] * (d[i] - lower[i]), WithinAbs(0, 1e-10));
        CHECK_THAT(model.multiplier()[i], WithinAbs(slope[i], 1e-10));
        active += d[i] == lower[i];
    }
    CHECK(active > 0);
    CHECK(active < n - 1);

    H(3, 3) = -1000;
    model.set_matrix(H.sparseView());
    CHECK_FALSE(model.minimise(g, lower, d));
}
