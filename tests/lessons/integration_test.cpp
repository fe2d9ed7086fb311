// The lesson of the eight integrators: growth, frequency, limits, orders and energies against theory, and every exact solution
// against its equation.
#include "readings.h"

#include <pliant/text/format.h>
#include <pliant/time/scheme.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "why_checks.h"

#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

using Settings = Runner::Assignments;

Runner start_integration(const Settings& parameters) { return Runner(find_lesson("time/integration"), parameters); }

Runner after(Index steps, const Settings& parameters) {
    Runner runner = start_integration(parameters);
    for (Index k = 0; k < steps; ++k) runner.step();
    return runner;
}

std::optional<Real> probe(const Runner& runner, std::string_view name) { return runner.value(runner.lesson().probe(name)); }

const Assumption& stability(const Runner& runner) {
    return *std::ranges::find(runner.lesson().assumptions, "stability", &Assumption::name);
}

std::string key(Scheme scheme) { return std::string(info_of(scheme).key); }
std::string text(Real x) { return format_exact(x); }

Settings oscillator(const std::string& scheme, Real omega, Real zeta, Real dt) {
    return {{"scheme", scheme}, {"omega", text(omega)}, {"damping_ratio", text(zeta)}, {"time_step", text(dt)}};
}

bool law_holds(const Runner& runner, std::string_view name) {
    for (std::size_t i = 0; i < runner.lesson().conserved.size(); ++i)
        if (runner.lesson().conserved[i].probe == name && runner.holds(i) == Holds::no) return false;
    return true;
}

}  // namespace

TEST_CASE("integration: a step grows by the radius of its matrix", "[integration]") {
    const struct {
        const char* scheme;
        Real at_01, at_021;
    } radii[] = {
        {"explicit_euler", 1.414214, 2.32594}, {"semi_implicit_euler", 1, 1.87733}, {"implicit_euler", 0.707107, 0.42993}};
    for (const auto& [scheme, at_01, at_021] : radii)
        for (const auto& [dt, radius] : {std::pair{0.1, at_01}, {0.21, at_021}}) {
            Runner runner = after(5, oscillator(scheme, 10, 0, dt));
            INFO(scheme << " " << dt);
            CHECK_THAT(value(runner, "growth_theory"), WithinAbs(radius, 1e-5));
            CHECK_THAT(value(runner, "growth_measured"), WithinRel(value(runner, "growth_theory"), 1e-7));
        }
}

TEST_CASE("integration: what a thousand steps leave of an amplitude", "[integration]") {
    CHECK_THAT(value(after(1000, oscillator("explicit_euler", 2, 0, 0.05)), "amplitude"), WithinAbs(144.7728, 1e-4));
    CHECK_THAT(value(after(1000, oscillator("implicit_euler", 2, 0, 0.05)), "amplitude"), WithinAbs(0.00690737, 1e-8));
}

TEST_CASE("integration: semi-implicit Euler swings too fast by the known factor", "[integration]") {
    const Runner runner = after(7, oscillator("semi_implicit_euler", 10, 0, 0.05));
    CHECK_THAT(value(runner, "frequency_measured") / 10, WithinAbs(1.0107210, 1e-7));
    CHECK_THAT(value(runner, "frequency_theory") / 10, WithinAbs(1.0107210, 1e-7));
    CHECK_THAT(std::sin(value(runner, "frequency_measured") * 0.05 / 2), WithinAbs(0.25, 1e-12));
}

TEST_CASE("integration: damping lowers the limit of semi-implicit Euler", "[integration]") {
    for (const auto& [zeta, limit] : {std::pair{0.1, 0.1809975}, {0.5, 0.1236068}, {1., 0.0828427}}) {
        Runner runner = start_integration(oscillator("semi_implicit_euler", 10, zeta, 0.01));
        INFO(zeta);
        CHECK_THAT(stability(runner).limit(), WithinAbs(limit, 1e-7));
        CHECK(value(after(3, oscillator("semi_implicit_euler", 10, zeta, 0.999 * limit)), "growth_measured") < 1);
        CHECK(value(after(3, oscillator("semi_implicit_euler", 10, zeta, 1.001 * limit)), "growth_measured") > 1);
    }
}

TEST_CASE("integration: growth and frequency of every scheme are those of theory", "[integration]") {
    const Real zeta = GENERATE(0., 0.2, 0.9, 1.7);
    const Real w = GENERATE(0.01, 0.4, 1.3);
    for (const SchemeInfo& info : schemes()) {
        // BDF2 has two more roots; after some steps the motion has forgotten them.
        const Index steps = info.scheme == Scheme::bdf2 ? 30 : 4;
        Runner runner = start_integration(oscillator(std::string(info.key), 3, zeta, w / 3));
        for (Index k = 0; k < steps; ++k) runner.step();
        INFO(info.key << " zeta " << zeta << " w " << w);
        const auto growth = probe(runner, "growth_measured"), frequency = probe(runner, "frequency_measured");
        if (growth) CHECK_THAT(*growth, WithinRel(value(runner, "growth_theory"), 1e-5));
        if (zeta < 1 && info.scheme != Scheme::bdf2) REQUIRE(growth);
        if (frequency && probe(runner, "frequency_theory"))
            CHECK_THAT(*frequency, WithinRel(value(runner, "frequency_theory"), 1e-4));
    }
}

TEST_CASE("integration: every scheme has its order, on every motion that is known", "[integration]") {
    const Settings motion = GENERATE(Settings{{"x0", "1"}, {"v0", "0.3"}}, Settings{{"damping_ratio", "0.3"}},
                                     Settings{{"system", "pendulum"}, {"x0", "3"}},
                                     Settings{{"system", "stiff_pair"}, {"stiffness_ratio", "4"}, {"damping_ratio", "0.1"}});
    for (const SchemeInfo& info : schemes()) {
        Settings settings = motion;
        settings.emplace_back("scheme", info.key);
        INFO(info.key << " " << motion.front().second);
        CHECK_THAT(value(start_integration(settings), "order"), WithinAbs(info.order, 0.15));
    }
}

TEST_CASE("integration: symplectic schemes keep the energy bounded, implicit Euler loses it, explicit Euler gains it",
          "[integration]") {
    for (const SchemeInfo& info : schemes()) {
        Runner runner = start_integration(oscillator(std::string(info.key), 2, 0, 0.1));
        const Real before = value(runner, "energy");
        Real most = before, least = before;
        for (int k = 0; k < 1000 && most < 100 * before; ++k) {
            runner.step();
            most = std::max(most, value(runner, "energy")), least = std::min(least, value(runner, "energy"));
        }
        INFO(info.key);
        CHECK(law_holds(runner, "energy") == (info.scheme != Scheme::explicit_euler));
        CHECK(law_holds(runner, "shadow_energy"));
        switch (info.scheme) {
            case Scheme::explicit_euler:
                CHECK(most > 10 * before);
                break;
            case Scheme::semi_implicit_euler:
                CHECK_THAT(most / least, WithinAbs(1.1 / 0.9, 5e-3));
                break;
            case Scheme::velocity_verlet:
                CHECK_THAT(least / most, WithinAbs(1 - 0.01, 2e-4));
                break;
            case Scheme::implicit_midpoint:
            case Scheme::newmark:
                CHECK_THAT(least, WithinRel(most, 1e-9));
                break;
            default:
                CHECK(least < (1 - 1e-4) * before);
                CHECK(most <= before * (1 + 1e-9));
        }
    }
}

TEST_CASE("integration: the exact motions fulfil their equations", "[integration]") {
    const std::string system = GENERATE("oscillator", "pendulum", "stiff_pair");
    const Real zeta = GENERATE(0., 0.4, 1 - 1e-9, 1., 1 + 1e-9, 4., 1e6);
    if (system == "pendulum" && zeta > 0) {
        CHECK_FALSE(probe(start_integration({{"system", system}, {"damping_ratio", "0.4"}}), "exact_x"));
        return;
    }
    const Real v0 = GENERATE(0., 3., -11.);
    const Runner runner = start_integration(
        {{"system", system}, {"damping_ratio", text(zeta)}, {"v0", text(v0)}, {"stiffness_ratio", "3"}, {"omega", "2"}});
    const Probe &x = runner.lesson().probe("x"), &v = runner.lesson().probe("v");
    CHECK_THAT(*x.exact(0), WithinAbs(1, 1e-14));
    CHECK_THAT(*v.exact(0), WithinAbs(v0, 1e-9 * (1 + zeta)));
    for (const Real t : {0.3, 1.1, 7.9}) {
        const Real h = 1e-4, now = *x.exact(t);
        const Real slope = (*x.exact(t + h) - *x.exact(t - h)) / (2 * h);
        INFO(system << " zeta " << zeta << " v0 " << v0 << " t " << t);
        CHECK_THAT(slope, WithinAbs(*v.exact(t), 1e-6));
        if (system == "stiff_pair") continue;
        const Real acceleration = (*v.exact(t + h) - *v.exact(t - h)) / (2 * h);
        const Real length = 9.81 / 4;
        const Real pull = system == "pendulum" ? 9.81 * std::sin(now / length) : 4 * now;
        CHECK_THAT(acceleration, WithinAbs(-pull - 4 * zeta * *v.exact(t), 1e-6 * (1 + zeta)));
    }
}

TEST_CASE("integration: the pair moves as its finer run does", "[integration]") {
    Runner coarse = start_integration(
        {{"system", "stiff_pair"}, {"damping_ratio", "0.05"}, {"scheme", "runge_kutta_4"}, {"time_step", "0.001"}});
    for (int k = 0; k < 2000; ++k) coarse.step();
    CHECK_THAT(value(coarse, "x"), WithinAbs(exact(coarse, "x"), 1e-6));
    CHECK_THAT(value(coarse, "energy"), WithinRel(exact(coarse, "energy"), 1e-5));
}

TEST_CASE("integration: explicit Euler without damping is stable nowhere, and says so", "[integration]") {
    Runner runner = start_integration(oscillator("explicit_euler", 2, 0, 0.5));
    CHECK(stability(runner).limit() == 0);
    CHECK(stability(runner).value() > stability(runner).limit());
    std::string told;
    try {
        for (int k = 0; k < 100; ++k) runner.step();
    } catch (const Diverged& d) {
        told = d.failure.limit;
    }
    CHECK_THAT(told, ContainsSubstring("√(1 + ω²Δt²)") && ContainsSubstring("1.4142"));
    REQUIRE(runner.failure());
    const auto mended = runner.lesson().fix(*runner.failure());
    REQUIRE(mended);
    runner.assign(mended->assign);
    for (int k = 0; k < 200; ++k) runner.step();
    CHECK(law_holds(runner, "energy"));
}

TEST_CASE("integration: every number is explained, for every scheme and motion", "[integration]") {
    for (const SchemeInfo& info : schemes())
        for (const Settings& motion : {Settings{{"damping_ratio", "0.1"}}, Settings{{"system", "pendulum"}, {"x0", "6"}},
                                       Settings{{"system", "stiff_pair"}, {"damping_ratio", "0.02"}, {"time_step", "0.02"}},
                                       Settings{{"omega", "0"}, {"v0", "1"}}, Settings{{"x0", "0"}}}) {
            Settings settings = motion;
            settings.emplace_back("scheme", info.key);
            Runner runner = start_integration(settings);
            check_every_stage(runner, std::string(info.key) + " " + motion.front().first, 3, 1);
        }
}

TEST_CASE("integration: a pendulum swings with the period of its amplitude", "[integration]") {
    const char* scheme = GENERATE("runge_kutta_4", "velocity_verlet", "implicit_midpoint");
    // From 90°: K(sin 45°)/(π/2) = 1.18034 times the period of small swings.
    const Real length = 9.81 / 4;
    Runner runner =
        start_integration({{"system", "pendulum"}, {"x0", text(length * pi / 2)}, {"scheme", scheme}, {"time_step", "0.01"}});
    while (runner.time() < 12) runner.step();
    CHECK_THAT(exact(runner, "period"), WithinRel(1.1803405990 * pi, 1e-9));
    CHECK_THAT(value(runner, "period"), WithinRel(1.1803405990 * pi, 1e-4));
}

// A computation with sixty digits from the same doubles. ω = √9.81 rad/s: the pendulum is 1 m long and x is its angle.
TEST_CASE("integration: the exact pendulum holds up to a start next to the top", "[integration]") {
    const struct {
        Real x0, v0, t, x, v;
    } known[] = {{3.1415926, 0, 8, -3.1337571786092654, -0.02454136535165552},
                 {3.14159265358, 0, 10, -3.0599964877226236, -0.25549580262100827},
                 {-3.14159265, 0, 9.3, 3.1395985247846356, 0.0062457937483543419},
                 {9.42477796, 0, 6, 9.3689844388049732, -0.17472777605315532},
                 {0, 6.2641839, 12, -3.1406330917894508, 0.0029942716678913299},
                 {0, 6.26418391, 7, 4.3394154145894042, 3.5313939859490284},
                 {1e-9, 0, 1.3, -5.9773226402080457e-10, 2.5109849340012788e-9},
                 {3.1, -0.3, 5, -9.1167620873948198, -0.99820253403505294}};
    for (const auto& [x0, v0, t, x, v] : known) {
        INFO("x0 = " << x0 << ", v0 = " << v0);
        const Runner runner = start_integration(
            {{"system", "pendulum"}, {"omega", "3.132091952673165"}, {"x0", text(x0)}, {"v0", text(v0)}, {"compare", "none"}});
        const auto& lesson = runner.lesson();
        CHECK_THAT(*lesson.probe("x").exact(0), WithinAbs(x0, 1e-15 * (1 + std::abs(x0))));
        CHECK_THAT(*lesson.probe("x").exact(t), WithinAbs(x, 1e-15 + 2e-7 * std::abs(x)));
        CHECK_THAT(*lesson.probe("v").exact(t), WithinAbs(v, 1e-15 + 2e-6 * std::abs(v)));
    }
    CHECK_THAT(*start_integration({{"system", "pendulum"}, {"omega", "3.132091952673165"}, {"x0", "3.1415926"}})
                    .lesson()
                    .probe("x")
                    .exact(8),
               WithinAbs(-3.1337571788, 1e-9));
    // Once it has swung to and fro, which takes 24 s instead of 2. (A scheme that loses 10⁻¹² of the energy swings faster.)
    Runner runner = start_integration({{"system", "pendulum"},
                                       {"omega", "3.132091952673165"},
                                       {"x0", "3.1415926"},
                                       {"scheme", "runge_kutta_4"},
                                       {"time_step", "0.01"},
                                       {"compare", "none"}});
    while (runner.time() < 45) runner.step();
    CHECK_THAT(exact(runner, "period"), WithinRel(24.036776750629956, 1e-9));
}

TEST_CASE("integration: the amplitude of a pendulum is told for the smallest swings and for those that nearly turn over",
          "[integration]") {
    for (const Real x0 : {1e-12, 1e-9, 1e-3, 2., 3.1415})
        CHECK_THAT(
            value(start_integration({{"system", "pendulum"}, {"omega", "3.132091952673165"}, {"x0", text(x0)}}), "amplitude"),
            WithinRel(x0, 1e-9));
}

TEST_CASE("integration: the pair has its closed form at every ratio of its springs", "[integration]") {
    for (const Real ratio : {1e-8, 1e-3, 1., 1e8}) {
        INFO(ratio);
        const Runner runner = start_integration({{"system", "stiff_pair"}, {"stiffness_ratio", text(ratio)}, {"x0", "1"}});
        CHECK_THAT(*runner.lesson().probe("x").exact(0), WithinAbs(1, 1e-14));
        CHECK_THAT(*runner.lesson().probe("energy").exact(3), WithinRel(2., 1e-12));
    }
}

TEST_CASE("integration: what is measured stays as it is inside a step, and its passes are drawn", "[integration]") {
    Runner runner = after(4, oscillator("runge_kutta_4", 2, 0.1, 0.3));
    const Real growth = value(runner, "growth_measured");
    const auto labels = [&] {
        Scene scene;
        runner.lesson().draw(scene);
        return std::ranges::count(scene.labels, "X, V", &LabelMark::text);
    };
    CHECK(labels() == 0);
    runner.run_to_stage("predict");
    for (int pass = 0; pass < 4; ++pass) {
        runner.step_pass();
        CHECK(value(runner, "growth_measured") == growth);
        CHECK(labels() == 1);
    }
    runner.step();
    CHECK(labels() == 0);
    runner.run_to_stage("passes");
    REQUIRE(runner.go_to({5, 0}));
    CHECK(labels() == 0);
}

TEST_CASE("integration: the work is counted", "[integration]") {
    const auto work = [](Scheme scheme, Real zeta) {
        return value(after(10, oscillator(key(scheme), 2, zeta, 0.1)), "force_evaluations");
    };
    CHECK(work(Scheme::explicit_euler, 0) == 1);
    CHECK(work(Scheme::semi_implicit_euler, 0) == 1);
    CHECK(work(Scheme::velocity_verlet, 0) == 1);
    CHECK(work(Scheme::velocity_verlet, 0.1) == 2);
    CHECK(work(Scheme::runge_kutta_4, 0) == 4);
    CHECK(work(Scheme::implicit_euler, 0) == 2);
    const Runner turns = after(3, {{"system", "pendulum"}, {"x0", "7"}, {"scheme", "implicit_euler"}, {"time_step", "0.5"}});
    CHECK(value(turns, "newton_iterations_used") > 2);
}

TEST_CASE("integration: steps of a microsecond add up", "[integration]") {
    Runner runner = start_integration(oscillator("semi_implicit_euler", 2, 0, 1e-6));
    for (int k = 0; k < 100000; ++k) runner.step();
    CHECK_THAT(runner.time(), WithinAbs(0.1, 1e-12));
    CHECK_THAT(value(runner, "x"), WithinAbs(std::cos(0.2), 1e-6));
    CHECK_THAT(value(runner, "growth_measured"), WithinAbs(1, 1e-9));
}

TEST_CASE("integration: what is dragged becomes parameters", "[integration]") {
    Runner runner = start_integration({});
    const auto& lesson = runner.lesson();
    const auto values = lesson.dragged({1, Vec<3>::Zero(), Vec<3>(2.35 + 0.4 - 1. / 3, 1. / 3, 0)});
    REQUIRE(values.size() == 2);
    CHECK(values[0].first == "time_step");
    CHECK_THAT(values[0].second, WithinAbs(std::sqrt(2.) / 2, 1e-9));
    CHECK_THAT(values[1].second, WithinAbs(std::sqrt(0.5), 1e-9));
}
