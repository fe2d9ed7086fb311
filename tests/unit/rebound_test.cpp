// A body that falls on the ground and rebounds, with every integrator: restitution does not depend on where in a step the
// ground is met, and energy does not come from nowhere.
#include "spring_body.h"

#include <pliant/mesh/lattice.h>
#include <pliant/solids/contact.h>
#include <pliant/time/stability.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <cmath>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr Real pull_of_earth = 9.81;  // m/s²

template <int Dim>
class Bouncer {
public:
    Bouncer(Points<Dim> points, const std::vector<Spring>& springs, Real node_mass, const Ground& floor)
        : body(points, springs, VecX::Constant(points.cols(), node_mass)), ground(floor) {
        body.system.load.gravity[1] = -pull_of_earth;
    }
    void step(Scheme scheme, Real dt) {
        contact.begin(dt, body.x, body.v);
        body.integrator.set_scheme(scheme);
        if (is_implicit(scheme)) set_ground_bounds<Dim>(ground, body.x, body.integrator.lower_bound());
        body.step(scheme, dt);
        if (is_implicit(scheme)) contact.arrest(body.integrator, body.inertia);
        touching = contact.resolve(ground, body.inertia, scheme, body.force(), body.x, body.v);
        if (touching > 0) body.integrator.forget();
    }
    SpringBody<Dim> body;
    Ground ground;
    GroundContact<Dim> contact;
    Index touching = 0;
};

bool first_order(Scheme scheme) { return info_of(scheme).order == 1 || scheme == Scheme::bdf2; }

std::vector<Spring> cube_springs(const NodeLattice<3>& lattice, Real k) {
    std::vector<Spring> list;
    append_springs<3>(lattice.points(), lattice.structural(), k, 0, list);
    append_springs<3>(lattice.points(), lattice.face_diagonals(), k, 0, list);
    return list;
}

}  // namespace

TEST_CASE("a node rebounds with its share of the speed of impact, wherever in a step it meets the ground", "[contact]") {
    const Scheme scheme = GENERATE(Catch::Generators::from_range(schemes())).scheme;
    const Real restitution = GENERATE(0.0, 0.3, 0.5, 1.0), dt = 1e-3;
    CAPTURE(info_of(scheme).key, restitution);
    for (int part = 0; part < 20; ++part) {
        // A step at the ground is 4.4 mm long.
        const Real height = 1 + 0.05 * part * 4.4e-3;
        Bouncer<2> ball(Points<2>(Vec<2>(0, height)), {}, 2, {.restitution = restitution, .friction = 0});
        while (ball.touching == 0) ball.step(scheme, dt);
        CHECK(ball.body.x(1, 0) == 0);
        // The first order is that of the fall: half a step of gravity.
        const Real impact = std::sqrt(2 * pull_of_earth * height);
        CHECK_THAT(ball.body.v(1, 0), WithinAbs(restitution * impact, first_order(scheme) ? pull_of_earth * dt : 1e-9));
    }
}

TEST_CASE("a body of springs without damping gains no energy as it bounces", "[springs][contact]") {
    const Scheme scheme = GENERATE(Catch::Generators::from_range(schemes())).scheme;
    if (scheme == Scheme::explicit_euler) return;  // is stable at no step without damping
    const Real restitution = GENERATE(0.3, 1.0), k = GENERATE(1.0, 1000.0);
    CAPTURE(info_of(scheme).key, restitution, k);
    const NodeLattice<3> lattice({1, 1, 1}, Vec<3>::Constant(0.1), {0, 0.5, 0});
    Bouncer<3> cube(lattice.points(), cube_springs(lattice, k), 0.125, {.restitution = restitution, .friction = 0});
    // A little askew, so that every node meets the ground at a time of its own.
    cube.body.x.row(1) += 0.02 * cube.body.x.row(0) + 0.03 * cube.body.x.row(2);
    const Real start = cube.body.energy(), dt = 1e-3;
    Real most = start;
    Index impacts = 0;
    for (int n = 0; n < 3000; ++n) {
        cube.step(scheme, dt);
        most = std::max(most, cube.body.energy());
        impacts += cube.touching;
        REQUIRE(cube.body.x.row(1).minCoeff() >= 0);
    }
    CHECK(impacts > 10);
    // Semi-implicit Euler lets the energy of the fastest mode swing; what it has at the places of the steps does not drift.
    const SpringRates rates =
        spring_rate_estimates<3>(cube.body.springs, cube.body.inertia, SpringDamping::none, lattice.points());
    const bool swings = scheme == Scheme::semi_implicit_euler;
    CHECK(most <= (1.02 + (swings ? energy_excess(scheme, rates.omega * dt, false, false) : 0)) * start);
    if (restitution < 1) CHECK(cube.body.energy() < 0.9 * start);
}
