#include <pliant/math/error.h>
#include <pliant/solids/contact.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <limits>

using namespace pliant;
using Catch::Matchers::WithinRel;

namespace {

struct Node {
    Vec<3> x, v;
    DiagonalMass mass{VecX::Ones(1), 3};
    // After a step of 1 s that nothing accelerated.
    Index touch(const Ground& ground) {
        GroundContact<3> contact;
        contact.begin(1, Points<3>(x - v), Points<3>(v));
        return end(contact, ground, Scheme::velocity_verlet, Vec<3>::Zero());
    }
    // A step of semi-implicit Euler.
    Index step(const Ground& ground, Real dt, const Vec<3>& acceleration) {
        GroundContact<3> contact;
        contact.begin(dt, Points<3>(x), Points<3>(v));
        v += dt * acceleration;
        x += dt * v;
        return end(contact, ground, Scheme::semi_implicit_euler, acceleration);
    }
    Index end(GroundContact<3>& contact, const Ground& ground, Scheme scheme, const Vec<3>& acceleration) {
        Points<3> xs = x, vs = v;
        const auto force = [&](ConstDofs, ConstDofs, Dofs f) { f = acceleration; };
        const Index touching = contact.resolve(ground, mass, scheme, force, xs, vs);
        x = xs, v = vs;
        return touching;
    }
};

}  // namespace

TEST_CASE("a node above the ground is left alone, one below comes back onto it", "[contact]") {
    Node above{{1, 1e-9, 2}, {0, -3, 0}};
    CHECK(above.touch({}) == 0);
    CHECK(above.v == Vec<3>(0, -3, 0));

    Node below{{1, 0.2, 2}, {0, -3, 0}};
    CHECK(below.touch({.height = 0.5}) == 1);
    CHECK(below.x == Vec<3>(1, 0.5, 2));
    CHECK(below.v == Vec<3>(0, 0, 0));
}

TEST_CASE("restitution returns its share of the impact speed", "[contact]") {
    const Real restitution = GENERATE(0.0, 0.4, 1.0);
    Node node{{0, -0.01, 0}, {0, -2, 0}};
    node.touch({.restitution = restitution, .friction = 0});
    CHECK_THAT(node.v[1], WithinRel(2 * restitution, 1e-15));
}

TEST_CASE("the speed of impact is that of the place of the ground, from the work done on the way", "[contact]") {
    // 2 m/s at 5 cm above the ground, 10 m/s^2 downwards: v^2 = u^2 + 2 g h.
    const Approach falls{.height = 0.05, .speed = 2, .free_speed = 2.5, .dt = 0.05};
    CHECK_THAT(falls.acceleration(), WithinRel(10.0, 1e-12));
    CHECK_THAT(falls.impact(), WithinRel(std::sqrt(5.0), 1e-12));
    // Thrown up, it comes back with what it went up with, and with that of its height.
    const Approach thrown{.height = 0, .speed = -0.1, .free_speed = 0.9, .dt = 0.1};
    CHECK_THAT(thrown.impact(), WithinRel(0.1, 1e-12));
    // Lying there, pressed down or not, it has none; nor where a force stops it above.
    CHECK(Approach{.height = 0, .speed = 0, .free_speed = 3, .dt = 0.1}.impact() == 0);
    CHECK(Approach{.height = 1, .speed = 1, .free_speed = -3, .dt = 0.1}.impact() == 0);
    // A velocity that is late by half a step of 0.1 s under 10 m/s^2.
    const Approach late{.height = 0, .speed = 1.5, .free_speed = 2.5, .dt = 0.1, .late = true, .acceleration_there = 10};
    CHECK_THAT(late.impact(), WithinRel(2.0, 1e-12));
    CHECK_THAT(late.rebound(1), WithinRel(2.5, 1e-12));
    CHECK(late.rebound(0.4) == 0);
}

TEST_CASE("a body that lies on the ground stays there, however elastic", "[contact]") {
    const Real dt = 0.01, g = 10;
    Node node{{0, 0, 0}, {0, 0, 0}};
    for (int n = 0; n < 10; ++n) {
        CHECK(node.step({.restitution = 1}, dt, {0, -g, 0}) == 1);
        CHECK(node.x[1] == 0);
        CHECK(node.v[1] == 0);
    }
}

TEST_CASE("Coulomb friction takes mu times the normal change, and never reverses", "[contact]") {
    Node slides{{0, -0.01, 0}, {3, -1, 4}};
    slides.touch({.restitution = 0.5, .friction = 0.4});
    CHECK(slides.v.isApprox(Vec<3>(3 * (1 - 0.6 / 5), 0.5, 4 * (1 - 0.6 / 5)), 1e-15));

    Node sticks{{0, -0.01, 0}, {0.3, -1, 0.4}};
    sticks.touch({.friction = 0.6});
    CHECK(sticks.v.isZero(0));

    Node smooth{{0, -0.01, 0}, {3, -1, 4}};
    smooth.touch({.friction = 0});
    CHECK(smooth.v == Vec<3>(3, 0, 4));
}

TEST_CASE("a node on a slope in its load creeps neither while it sticks nor slides freely", "[contact]") {
    // A load a_t along the ground and g into it: sticks below friction g, else accelerates with a_t - friction g.
    const Real load = GENERATE(2.0, 8.0), g = 10, friction = 0.5, dt = 0.01;
    Node node{{0, 0, 0}, {0, 0, 0}};
    for (int n = 0; n < 100; ++n) {
        node.step({.friction = friction}, dt, {load, -g, 0});
    }
    const Real acceleration = load > friction * g ? load - friction * g : 0;
    CHECK_THAT(node.v[0], Catch::Matchers::WithinAbs(acceleration, 1e-12));
    CHECK_THAT(node.x[0], Catch::Matchers::WithinAbs(0.5 * acceleration * 1.01, 1e-12));
}

TEST_CASE("fixed nodes are not moved by the ground", "[contact]") {
    Node node{{0, -1, 0}, {0, 0, 0}, DiagonalMass(VecX::Ones(1), 3, {0})};
    CHECK(node.touch({}) == 0);
    CHECK(node.x[1] == -1);
}

TEST_CASE("a ground that makes no sense is refused by name", "[contact]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    CHECK_THROWS_AS(require_valid(Ground{nan, 0, 0}), Refused);
    CHECK_THROWS_AS(require_valid(Ground{0, 1.1, 0}), Refused);
    CHECK_THROWS_AS(require_valid(Ground{0, -0.1, 0}), Refused);
    CHECK_THROWS_AS(require_valid(Ground{0, 0, -1}), Refused);
    CHECK_NOTHROW(require_valid(Ground{}));
}
