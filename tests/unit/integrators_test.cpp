// The time integrators on one spring. Reference figures: amplification factors and stability limits of the schemes on the
// damped oscillator, Hairer, Lubich & Wanner 2006 §I.1 and the classical root conditions.
#include "spring_body.h"

#include <pliant/math/error.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <complex>
#include <limits>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr Scheme all_schemes[] = {Scheme::explicit_euler, Scheme::semi_implicit_euler, Scheme::implicit_euler};
constexpr Scheme one_step_schemes[] = {Scheme::explicit_euler,  Scheme::semi_implicit_euler, Scheme::implicit_euler,
                                       Scheme::velocity_verlet, Scheme::runge_kutta_4,       Scheme::implicit_midpoint,
                                       Scheme::newmark};

Real radius(Scheme scheme, Real omega, Real zeta, Real dt) { return SpringOscillator(omega, zeta).spectral_radius(scheme, dt); }

// Distance of the state (x, v/omega) from the exact undamped one at t = 1 s, released at x = 1 m.
Real state_error(Scheme scheme, Real omega, int steps) {
    SpringOscillator body(omega, 0);
    body.position() = 1;
    body.run(scheme, 1.0 / steps, steps);
    return std::hypot(body.position() - std::cos(omega), body.velocity() / omega + std::sin(omega));
}

}  // namespace

TEST_CASE("amplification per step of the undamped oscillator", "[integrators]") {
    struct Row {
        Real dt, explicit_euler, semi_implicit_euler, implicit_euler;
    };
    const Row row = GENERATE(Row{0.1, 1.414214, 1.0, 0.707107}, Row{0.21, 2.32594, 1.87733, 0.42993});
    // Below 2/omega the two eigenvalues of semi-implicit Euler are conjugate on the unit circle.
    CHECK_THAT(radius(Scheme::explicit_euler, 10, 0, row.dt), WithinAbs(row.explicit_euler, 5e-6));
    CHECK_THAT(radius(Scheme::semi_implicit_euler, 10, 0, row.dt), WithinAbs(row.semi_implicit_euler, 5e-6));
    CHECK_THAT(radius(Scheme::implicit_euler, 10, 0, row.dt), WithinAbs(row.implicit_euler, 5e-6));
}

TEST_CASE("the predicted amplification is the one of the real step", "[integrators]") {
    const Scheme scheme = GENERATE(from_range(one_step_schemes));
    const Real zeta = GENERATE(0.0, 0.1, 0.7, 1.0, 3.0);
    const Real dt = GENERATE(0.003, 0.05, 0.15, 0.4);
    // A double eigenvalue answers to a change of the matrix by its square root.
    CHECK_THAT(amplification(scheme, 10, zeta, dt), WithinRel(radius(scheme, 10, zeta, dt), 2e-7));
}

TEST_CASE("BDF2 shrinks an oscillation by what its roots say", "[integrators]") {
    const Real zeta = GENERATE(0.0, 0.3);
    const Real dt = GENERATE(0.02, 0.1);
    // Two steps in a row make the state of a two-step scheme.
    SpringOscillator body(10, zeta);
    body.position() = 1;
    const int steps = 80;
    const auto size = [&] { return std::hypot(body.position(), body.velocity() / 10); };
    body.run(Scheme::bdf2, dt, steps);
    const Real early = size();
    body.run(Scheme::bdf2, dt, steps);
    CHECK_THAT(std::pow(size() / early, 1.0 / steps), WithinRel(amplification(Scheme::bdf2, 10, zeta, dt), 0.01));
}

TEST_CASE("the limit of every explicit scheme separates growth from decay", "[integrators]") {
    const Scheme scheme = GENERATE(Scheme::velocity_verlet, Scheme::runge_kutta_4);
    const Real zeta = GENERATE(0.0, 0.05, 0.5, 1.0, 4.0);
    const Real limit = stability_limit(scheme, 10, zeta);
    CHECK(radius(scheme, 10, zeta, 0.999 * limit) <= 1 + 1e-9);
    CHECK(radius(scheme, 10, zeta, 1.001 * limit) > 1 + 1e-6);
    if (zeta == 0) CHECK_THAT(limit, WithinRel(scheme == Scheme::velocity_verlet ? 0.2 : std::sqrt(8.0) / 10, 1e-14));
}

TEST_CASE("unconditionally stable schemes never grow", "[integrators]") {
    const Scheme scheme = GENERATE(Scheme::implicit_midpoint, Scheme::newmark, Scheme::bdf2, Scheme::implicit_euler);
    CHECK(stability_limit(scheme, 10, 0) == std::numeric_limits<Real>::infinity());
    for (const Real omega_dt : {1e-3, 0.3, 1.0, 30.0, 1e3, 1e6})
        for (const Real zeta : {0.0, 0.2, 1.0, 1e3}) CHECK(amplification(scheme, 1, zeta, omega_dt) <= 1 + 1e-12);
    if (scheme == Scheme::implicit_midpoint || scheme == Scheme::newmark)
        CHECK_THAT(radius(scheme, 10, 0, 3), WithinRel(1.0, 1e-12));
}

TEST_CASE("amplitude after 1000 steps at omega dt = 0.1", "[integrators]") {
    const auto amplitude = [](Scheme scheme) {
        SpringOscillator body(10, 0);
        body.position() = 1;
        body.run(scheme, 0.01, 1000);
        return std::hypot(body.position(), body.velocity() / 10);
    };
    CHECK_THAT(amplitude(Scheme::explicit_euler), WithinRel(144.7728, 1e-6));
    CHECK_THAT(amplitude(Scheme::implicit_euler), WithinRel(0.00690737, 1e-6));
    CHECK_THAT(amplitude(Scheme::semi_implicit_euler), WithinAbs(1, 0.06));
}

TEST_CASE("semi-implicit Euler oscillates at sin(w' dt/2) = w dt/2", "[integrators]") {
    const Real omega = 10, dt = 0.05;
    const std::complex<Real> factor = SpringOscillator(omega, 0).step_factors(Scheme::semi_implicit_euler, dt)[0];
    const Real measured = std::abs(std::arg(factor)) / dt;
    CHECK_THAT(measured / omega, WithinAbs(1.0107210, 5e-8));
    CHECK_THAT(std::sin(measured * dt / 2), WithinRel(omega * dt / 2, 1e-12));
}

TEST_CASE("all three schemes converge at first order in the global state", "[integrators]") {
    const Scheme scheme = GENERATE(from_range(all_schemes));
    Real previous = state_error(scheme, 2, 250);
    for (const int steps : {500, 1000, 2000}) {
        const Real error = state_error(scheme, 2, steps);
        CHECK_THAT(std::log2(previous / error), WithinAbs(1, 0.05));
        previous = error;
    }
}

TEST_CASE("every scheme has the order that it declares, damped or not", "[integrators]") {
    const SchemeInfo& info = GENERATE(from_range(schemes()));
    const Real zeta = GENERATE(0.0, 0.25);
    const Real omega = 2, decay = zeta * omega, damped = omega * std::sqrt(1 - zeta * zeta);
    const auto error = [&](int steps) {
        SpringOscillator body(omega, zeta);
        body.position() = 1;
        body.run(info.scheme, 1.0 / steps, steps);
        const Real exact = std::exp(-decay) * (std::cos(damped) + decay / damped * std::sin(damped));
        const Real rate = -std::exp(-decay) * omega * omega / damped * std::sin(damped);
        return std::hypot(body.position() - exact, (body.velocity() - rate) / omega);
    };
    const int steps = info.order == 4 ? 20 : 400;
    CHECK_THAT(std::log2(error(steps) / error(2 * steps)), WithinAbs(info.order, 0.1));
}

TEST_CASE("directions of projected damping do not cost schemes their order", "[integrators]") {
    const Scheme scheme =
        GENERATE(Scheme::velocity_verlet, Scheme::runge_kutta_4, Scheme::implicit_midpoint, Scheme::newmark, Scheme::bdf2);
    // A damped spring that swings as a pendulum does, and so turns.
    const auto end = [&](int steps) {
        Points<2> points(2, 2);
        points << 0, 1, 0, 0.2;
        SpringBody<2> body(points, {{0, 1, 0.9, 40, 2}}, VecX::Constant(2, 1), {0});
        body.system.damping = SpringDamping::projected;
        body.system.load.gravity = {0, -9.81};
        body.run(scheme, 0.5 / steps, steps);
        return Vec<2>(body.x.col(1));
    };
    const Vec<2> fine = end(800), coarse = end(200), middle = end(400);
    CHECK(std::log2((coarse - middle).norm() / (middle - fine).norm()) > info_of(scheme).order - 0.25);
}

TEST_CASE("velocity Verlet evaluates one force a step where velocities do not matter", "[integrators]") {
    SpringOscillator undamped(10, 0), damped(10, 0.1);
    undamped.position() = damped.position() = 1;
    undamped.run(Scheme::velocity_verlet, 0.01, 50);
    damped.run(Scheme::velocity_verlet, 0.01, 50);
    CHECK(undamped.integrator.force_evaluations() == 51);
    CHECK(damped.integrator.force_evaluations() == 100);
    // What was changed from outside is evaluated anew.
    undamped.position() = 2;
    undamped.integrator.forget();
    undamped.step(Scheme::velocity_verlet, 0.01);
    CHECK(undamped.integrator.force_evaluations() == 53);
}

TEST_CASE("BDF2 takes steps of any length at second order", "[integrators]") {
    const auto error = [](int pairs) {
        SpringOscillator body(2, 0);
        body.position() = 1;
        const Real dt = 1.0 / (3 * pairs);
        for (int n = 0; n < pairs; ++n) {
            body.step(Scheme::bdf2, dt);
            body.step(Scheme::bdf2, 2 * dt);
        }
        return std::hypot(body.position() - std::cos(2), body.velocity() / 2 + std::sin(2));
    };
    CHECK_THAT(std::log2(error(100) / error(200)), WithinAbs(2, 0.1));
}

TEST_CASE("the energy error of semi-implicit Euler stays bounded and of first order", "[integrators]") {
    const auto worst = [](Real dt) {
        SpringOscillator body(10, 0);
        body.position() = 1;
        const Real start = body.energy();
        Real largest = 0;
        for (int n = 0; n < 20000; ++n) {
            body.step(Scheme::semi_implicit_euler, dt);
            largest = std::max(largest, std::abs(body.energy() / start - 1));
        }
        return largest;
    };
    // x^2 + (v/w)^2 - w dt x (v/w) is conserved exactly, so the energy wanders by a factor 1/(1 - w dt/2) at most.
    CHECK(worst(0.01) < 0.05 / 0.95 + 1e-9);
    CHECK_THAT(std::log2(worst(0.01) / worst(0.005)), WithinAbs(1, 0.1));
}

TEST_CASE("stability limits of the damped schemes bracket the real ones", "[integrators]") {
    const Real zeta = GENERATE(0.1, 0.5, 1.0);
    const Real reference = zeta == 0.1 ? 0.1809975 : zeta == 0.5 ? 0.1236068 : 0.0828427;
    const Real semi_implicit = stability_limit(Scheme::semi_implicit_euler, 10, zeta);
    CHECK_THAT(semi_implicit, WithinAbs(reference, 5e-8));
    CHECK(radius(Scheme::semi_implicit_euler, 10, zeta, 0.999 * semi_implicit) < 1);
    CHECK(radius(Scheme::semi_implicit_euler, 10, zeta, 1.001 * semi_implicit) > 1);

    const Real forward = stability_limit(Scheme::explicit_euler, 10, zeta);
    CHECK_THAT(forward, WithinRel(2 * zeta / 10, 1e-14));
    CHECK(radius(Scheme::explicit_euler, 10, zeta, 0.999 * forward) < 1);
    CHECK(radius(Scheme::explicit_euler, 10, zeta, 1.001 * forward) > 1);
}

TEST_CASE("an overdamped oscillator has limits too", "[integrators]") {
    const Scheme scheme = GENERATE(Scheme::explicit_euler, Scheme::semi_implicit_euler);
    const Real zeta = GENERATE(1.5, 20.0);
    const Real limit = stability_limit(scheme, 10, zeta);
    CHECK(radius(scheme, 10, zeta, 0.999 * limit) < 1);
    CHECK(radius(scheme, 10, zeta, 1.001 * limit) > 1);
    if (scheme == Scheme::explicit_euler) CHECK_THAT(limit, WithinRel(0.2 * (zeta - std::sqrt(zeta * zeta - 1)), 1e-12));
}

TEST_CASE("with a damping ratio above 1/√3 explicit Euler takes the longer steps", "[integrators]") {
    const auto limit = [](Scheme scheme, Real zeta) { return stability_limit(scheme, 10, zeta); };
    for (const Real zeta : {0.1, 0.5, 0.57})
        CHECK(limit(Scheme::explicit_euler, zeta) < limit(Scheme::semi_implicit_euler, zeta));
    for (const Real zeta : {0.58, 0.9, 1.0, 3.0})
        CHECK(limit(Scheme::explicit_euler, zeta) > limit(Scheme::semi_implicit_euler, zeta));
    CHECK(limit_in_words(Scheme::semi_implicit_euler) == "semi-implicit Euler, (2/ω)(√(1 + ζ²) − ζ)");
    CHECK(limit_in_words(Scheme::explicit_euler) == "explicit Euler, 2ζ/ω up to ζ = 1, beyond it (2/ω)(ζ − √(ζ² − 1))");
    CHECK(limit_in_words(Scheme::velocity_verlet) == info_of(Scheme::velocity_verlet).name);
}

TEST_CASE("undamped: forward Euler grows at every time step, semi-implicit Euler from 2/omega on", "[integrators]") {
    for (const Real dt : {1e-4, 1e-2, 1.0}) CHECK(radius(Scheme::explicit_euler, 10, 0, dt) > 1);
    CHECK(stability_limit(Scheme::explicit_euler, 10, 0) == 0);

    const auto amplitude = [](Real omega_dt, int steps) {
        SpringOscillator body(10, 0);
        body.position() = 1;
        body.run(Scheme::semi_implicit_euler, omega_dt / 10, steps);
        return std::hypot(body.position(), body.velocity() / 10);
    };
    CHECK(amplitude(1.99, 10000) < 50);
    CHECK(amplitude(2.01, 400) > 1e30);
}

TEST_CASE("implicit Euler multiplies the amplitude by 1/sqrt(1 + (w dt)^2) at every time step", "[integrators]") {
    const Real omega_dt = GENERATE(1e-3, 1.0, 1e3, 1e6);
    SpringOscillator body(10, 0);
    body.position() = 1;
    body.step(Scheme::implicit_euler, omega_dt / 10);
    const Real amplitude = std::hypot(body.position(), body.velocity() / 10);
    CHECK_THAT(amplitude, WithinRel(1 / std::hypot(1, omega_dt), 1e-9));
}

TEST_CASE("implicit Euler brings a strongly dragged mass to rest without reversing it", "[integrators]") {
    // c dt / m = 2 zeta omega dt = 1e6
    SpringOscillator body(1e-3, 5e10);
    body.velocity() = 1;
    Real previous = 1;
    for (int n = 0; n < 3; ++n) {
        body.step(Scheme::implicit_euler, 0.01);
        CHECK(body.velocity() >= 0);
        CHECK(body.velocity() < 2e-6 * previous);
        previous = body.velocity();
    }
    CHECK(amplification(Scheme::explicit_euler, 1e-3, 5e10, 0.01) > 1e5);
}

TEST_CASE("free fall follows the schemes' sums", "[integrators]") {
    const Scheme scheme = GENERATE(from_range(all_schemes));
    SpringBody<3> body(Points<3>::Zero(3, 1), {}, VecX::Constant(1, 2.5));
    body.system.load.gravity = {0, -9.81, 0};
    const int steps = 100;
    const Real dt = 0.01, shift = scheme == Scheme::explicit_euler ? -1 : 1;
    body.run(scheme, dt, steps);
    // x_n = -1/2 g dt^2 n (n -+ 1)
    CHECK_THAT(body.x(1, 0), WithinRel(-0.5 * 9.81 * dt * dt * steps * (steps + shift), 1e-10));
    CHECK_THAT(body.v(1, 0), WithinRel(-9.81, 1e-10));
}

TEST_CASE("fixed nodes keep their velocity, free ones follow", "[integrators]") {
    const Scheme scheme = GENERATE(from_range(all_schemes));
    SpringOscillator body(10, 0.3);
    body.v.col(0) << 0.5, 0;
    body.position() = 0.1;
    body.run(scheme, 0.005, 1200);
    CHECK(body.v.col(0) == Vec<2>(0.5, 0));
    CHECK_THAT(body.x(0, 0), WithinRel(3.0, 1e-12));
    CHECK_THAT(body.velocity(), WithinAbs(0.5, 1e-6));
}

TEST_CASE("nothing moves when everything is fixed, and an empty system is stepped without harm", "[integrators]") {
    const Scheme scheme = GENERATE(from_range(all_schemes));
    SpringBody<2> fixed(Points<2>::Identity(2, 2), {{0, 1, 0.1, 50, 1}}, VecX::Ones(2), {0, 1});
    fixed.system.load.gravity = {0, -9.81};
    const Points<2> start = fixed.x;
    fixed.run(scheme, 0.01, 5);
    CHECK(fixed.x == start);
    CHECK(fixed.v.isZero(0));

    SpringBody<2> empty(Points<2>(2, 0), {}, VecX(0));
    empty.run(scheme, 0.01, 5);
    CHECK(empty.energy() == 0);
}

TEST_CASE("time steps and masses that make no sense are refused by name", "[integrators]") {
    const Real bad_dt = GENERATE(0.0, -0.1, std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::quiet_NaN());
    for (const Scheme scheme : all_schemes) {
        SpringOscillator body(1, 0);
        CHECK_THROWS_AS(body.step(scheme, bad_dt), Refused);
    }
    for (const Real bad_mass : {0.0, -1.0, std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::quiet_NaN()})
        CHECK_THROWS_AS(DiagonalMass(Vec<2>(1, bad_mass), 2), Refused);
    CHECK_THROWS_AS(DiagonalMass(VecX::Ones(2), 2, {2}), Refused);
}
