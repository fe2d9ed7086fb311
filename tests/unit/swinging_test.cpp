// What the schemes integrate: its force, energy and matrices agree with each other, and its closed forms solve its equation.
#include <pliant/time/scheme_runs.h>
#include <pliant/time/stability_region.h>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

using namespace pliant;
using Catch::Approx;

namespace {

constexpr std::array swinging_kinds{SwingingKind::oscillator, SwingingKind::pendulum, SwingingKind::stiff_pair};

SwingingOptions swinging(SwingingKind kind, Real zeta) {
    return {.system = kind, .omega = 2.5, .zeta = zeta, .stiffness_ratio = 40, .start = {0.7, -1.1}};
}

VecX force_at(const Swinging& s, const VecX& x, const VecX& v) {
    VecX f(s.size());
    s.force(x, v, f);
    return f;
}

}  // namespace

TEST_CASE("swinging: the force is the slope of energy and dissipation, and the matrix that of the force", "[swinging]") {
    for (const SwingingKind kind : swinging_kinds) {
        Swinging s(swinging(kind, 0.3));
        const VecX x = VecX::LinSpaced(s.size(), 0.4, -0.9), v = VecX::LinSpaced(s.size(), 1.2, 0.5);
        const VecX still = VecX::Zero(s.size());
        const MatX K = s.stiffness(x, 0, Swinging::Curvature::exact),
                   with_damping = s.stiffness(x, 2, Swinging::Curvature::exact);
        for (Index k = 0; k < s.size(); ++k) {
            constexpr Real h = 1e-5;
            const VecX dx = h * VecX::Unit(s.size(), k);
            CHECK(force_at(s, x, still)[k] == Approx(-(s.potential(x + dx) - s.potential(x - dx)) / (2 * h)).epsilon(1e-7));
            const VecX damping = force_at(s, x, v) - force_at(s, x, still);
            CHECK(damping[k] == Approx(-(s.dissipation(v + dx) - s.dissipation(v - dx)) / (2 * h)).epsilon(1e-7));
            const VecX slope = (force_at(s, x + dx, v) - force_at(s, x - dx, v)) / (2 * h);
            CHECK((slope + K.col(k)).norm() < 1e-7 * K.norm());
            const VecX by_speed = (force_at(s, x, v + dx) - force_at(s, x, v - dx)) / (2 * h);
            CHECK((2 * by_speed + (with_damping - K).col(k)).norm() < 1e-7 * with_damping.norm());
        }
    }
}

TEST_CASE("swinging: a pair has the rates of its matrix, and dampers that brake both modes alike", "[swinging]") {
    const Swinging s(swinging(SwingingKind::stiff_pair, 0.3));
    const Vec<2> squares = Eigen::SelfAdjointEigenSolver<Mat<2>>(s.stiffness_matrix()).eigenvalues();
    CHECK(s.slow_rate() == Approx(std::sqrt(squares[0])));
    CHECK(s.fast_rate() == Approx(std::sqrt(squares[1])));
    // C = 2 ζ √K
    CHECK((s.damping_matrix() * s.damping_matrix() - 4 * 0.09 * s.stiffness_matrix()).norm() <
          1e-12 * s.stiffness_matrix().norm());
}

TEST_CASE("swinging: closed forms begin at the start and solve x″ = f(x, x′)", "[swinging]") {
    for (const SwingingKind kind : swinging_kinds)
        for (const Real zeta : {0.0, 0.2}) {
            const Swinging s(swinging(kind, zeta));
            if (kind == SwingingKind::pendulum && zeta > 0) {
                CHECK_FALSE(s.exact(0, 1));
                continue;
            }
            const auto state = [&](Real t) {
                VecX x(s.size()), v(s.size());
                for (Index k = 0; k < s.size(); ++k) x[k] = s.exact(k, t)->x, v[k] = s.exact(k, t)->v;
                return std::pair(x, v);
            };
            CHECK((state(0).first - s.start_position()).norm() < 1e-12);
            CHECK((state(0).second - s.start_velocity()).norm() < 1e-12);
            for (const Real t : {0.31, 1.7}) {
                constexpr Real h = 1e-5;
                const auto [x, v] = state(t);
                CHECK(((state(t + h).first - state(t - h).first) / (2 * h) - v).norm() < 1e-7 * s.top_speed());
                const VecX f = force_at(s, x, v), a = (state(t + h).second - state(t - h).second) / (2 * h);
                CHECK((a - f).norm() < 1e-6 * s.fast_rate() * s.top_speed());
                CHECK(*s.exact_energy(t) == Approx(s.energy(x, v)));
                if (zeta == 0) CHECK(s.energy(x, v) == Approx(s.energy(s.start_position(), s.start_velocity())).epsilon(1e-9));
                if (zeta > 0) CHECK(s.energy(x, v) < s.energy(s.start_position(), s.start_velocity()));
            }
        }
}

TEST_CASE("swinging: a pendulum swings slower the farther it swings", "[swinging]") {
    const Real omega = 3, length = Swinging::gravity / 9, small = 2 * std::numbers::pi / omega;
    const auto period = [&](Real angle) {
        return Swinging({.system = SwingingKind::pendulum, .omega = omega, .start = {angle * length, 0}}).pendulum_period();
    };
    CHECK(*period(1e-3) == Approx(small).epsilon(1e-6));
    CHECK(*period(0.4) / small == Approx(1 + 0.16 / 16 + 11 * 0.0256 / 3072).epsilon(1e-4));
    CHECK(*period(std::numbers::pi / 2) / small == Approx(1.1803405990).epsilon(1e-9));  // 2 K(sin 45°)/π
    const Swinging over({.system = SwingingKind::pendulum, .omega = omega, .start = {0, 2.1 * omega * length}});
    CHECK(over.can_leave());
    CHECK_FALSE(over.pendulum_period());
}

TEST_CASE("runs of schemes: each has the order that it is said to have", "[swinging]") {
    for (const SwingingKind kind : swinging_kinds)
        for (const SchemeInfo& info : schemes()) {
            SwingingOptions options = swinging(kind, 0);
            options.stiffness_ratio = 4;
            const ErrorCurve curve = error_curve(options, {info.scheme, {1e-12, 50}}, 9);
            INFO(info.name);
            const auto order = measured_order(curve);
            REQUIRE(order);
            CHECK(*order == Approx(info.order).margin(0.15));
            for (std::size_t k = 1; k < curve.cost.size(); ++k) CHECK(curve.cost[k] > curve.cost[k - 1]);
        }
}

TEST_CASE("runs of schemes: a step costs its evaluations of the force, and a motion that grows ends", "[swinging]") {
    for (const SchemeInfo& info : schemes()) {
        SchemeRun run(swinging(SwingingKind::pendulum, 0), {info.scheme, {}});
        for (int n = 0; n < 4; ++n) REQUIRE(run.step(0.01));
        // Velocity Verlet keeps the force at the end of a step for the next one.
        const bool keeps = info.scheme == Scheme::velocity_verlet;
        if (!info.implicit) CHECK(run.cost() == (keeps ? 1 + 4 : 4 * info.force_evaluations));
        if (info.implicit) CHECK(run.cost() >= 4);
    }
    SchemeRun grows(swinging(SwingingKind::oscillator, 0), {Scheme::explicit_euler, {}});
    int steps = 0;
    while (steps < 100 && grows.step(1)) ++steps;
    // Each step multiplies the amplitude by √(1 + ω² Δt²).
    const Real per_step = std::sqrt(1 + 2.5 * 2.5);
    CHECK(steps == Approx(std::log(SchemeRun::blown_up) / std::log(per_step)).margin(2));
}

TEST_CASE("runs of schemes: a path goes on where it was, and is that of a run of its own", "[swinging]") {
    const SwingingOptions options = swinging(SwingingKind::stiff_pair, 0.1);
    SchemePaths paths;
    paths.follow(options, {}, 0.01, 1);
    const Motion early = paths.of(Scheme::runge_kutta_4, 5).motion.back();
    const SchemePath& path = paths.of(Scheme::runge_kutta_4, 12);
    REQUIRE(path.motion.size() == 13);
    CHECK(path.motion[5].x == early.x);
    SchemeRun run(options, {Scheme::runge_kutta_4, {}});
    for (int n = 0; n < 12; ++n) REQUIRE(run.step(0.01));
    CHECK(path.motion.back().x == run.position()[1]);
    CHECK(path.energy.back() == run.system().energy(run.position(), run.velocity()));
    paths.follow(options, {}, 0.02, 1);
    CHECK(paths.of(Scheme::runge_kutta_4, 1).motion.size() == 2);
}

TEST_CASE("regions of stability: growth is that of the scheme's function of z", "[swinging]") {
    for (const std::complex<Real> z : {std::complex<Real>(-0.7, 0.4), {0.3, 1.1}, {-1.9, 0.1}, {-0.2, 2.3}}) {
        CHECK(growth_at(Scheme::explicit_euler, z) == Approx(std::abs(Real{1} + z)));
        CHECK(growth_at(Scheme::implicit_euler, z) == Approx(1 / std::abs(Real{1} - z)));
        CHECK(growth_at(Scheme::implicit_midpoint, z) == Approx(std::abs((Real{2} + z) / (Real{2} - z))));
        CHECK(growth_at(Scheme::runge_kutta_4, z) ==
              Approx(std::abs(Real{1} + z + z * z / Real{2} + z * z * z / Real{6} + z * z * z * z / Real{24})));
    }
}

TEST_CASE("regions of stability: the area of explicit Euler's is that of the unit circle, and borders are neutral",
          "[swinging]") {
    const auto area = [](Scheme scheme) {
        Real sum = 0;
        for (const auto& piece : stability_region(scheme).pieces)
            for (std::size_t k = 0; k < 4; ++k) {
                const auto &a = piece[k], &b = piece[(k + 1) % 4];
                sum += 0.5 * (a[0] * b[1] - a[1] * b[0]) * (piece[0][1] + piece[2][1] < 0 ? -1 : 1);
            }
        return sum;
    };
    CHECK(area(Scheme::explicit_euler) == Approx(std::numbers::pi).epsilon(0.01));
    // The left half of what is looked at.
    CHECK(area(Scheme::implicit_midpoint) == Approx(-region_left * 2 * region_high).epsilon(0.02));
    for (const Scheme scheme : {Scheme::explicit_euler, Scheme::runge_kutta_4, Scheme::implicit_euler})
        for (const auto& line : stability_region(scheme).border)
            for (const auto& point : line) CHECK(growth_at(scheme, {point[0], point[1]}) == Approx(1).margin(0.02));
}
