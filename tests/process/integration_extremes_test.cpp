// The extremes of time integration on the command line: at both sides of every limit, steps that are much too long, drag that is
// much too strong, a solver that may not finish.
#include "pliant.h"

#include <cmath>

using namespace pliant::test;

namespace {

Arguments integrate(const std::string& steps, const std::vector<std::string>& settings) {
    return with({"run", "time/integration", "--steps", steps}, settings);
}

Json probes_after(const std::string& steps, const std::vector<std::string>& settings) {
    return json_of(integrate(steps, settings));
}
// The limit that the run's failure names.
std::string stopped(const std::string& steps, const std::vector<std::string>& settings) {
    Arguments asked = integrate(steps, settings);
    asked.push_back("--json");
    const Outcome outcome = call(asked);
    INFO(sentence(asked) << "\n" << outcome.err);
    REQUIRE(outcome.exit_code == diverged);
    const Json failure = Json::parse(outcome.out)["failure"];
    CHECK(contains(outcome.err, failure["limit"].get<std::string>()));
    return failure["limit"];
}

}  // namespace

TEST_CASE("explicit Euler without damping is stopped, with the growth by name", "[process]") {
    for (const char* dt : {"time_step=0.05", "time_step=0.5", "time_step=1000"}) {
        const std::string limit = stopped("2000", {"scheme=explicit_euler", dt});
        CHECK(contains(limit, "√(1 + ω²Δt²)"));
        CHECK(contains(limit, "damping ratio"));
    }
    // Before it has grown that far the report says so.
    const std::string report = output_of(integrate("100", {"scheme=explicit_euler"}));
    CHECK(contains(report, "BROKEN"));
}

TEST_CASE("damped explicit Euler is bounded below 2ζ/ω and stopped above", "[process]") {
    const std::vector<std::string> scene{"scheme=explicit_euler", "omega=10", "damping_ratio=0.3"};
    const auto at = [&](const char* dt) {
        std::vector<std::string> settings = scene;
        settings.push_back(dt);
        return settings;
    };
    const Json below = probes_after("3000", at("time_step=0.0594"));
    CHECK(value(below, "growth_theory") < 1);
    CHECK(value(below, "amplitude") < 0.01);
    const std::string limit = stopped("20000", at("time_step=0.0606"));
    CHECK(contains(limit, "60 ms"));
}

TEST_CASE("semi-implicit Euler at ωΔt = 1.99 is bounded, at 2.01 stopped", "[process]") {
    const Json below = probes_after("10000", {"time_step=0.995"});
    CHECK(std::abs(value(below, "growth_measured") - 1) < 1e-9);
    CHECK(value(below, "energy") < 1000);
    CHECK(contains(stopped("10000", {"time_step=1.005"}), "1 s"));
}

TEST_CASE("semi-implicit Euler with drag: its limit is lower, from both sides", "[process]") {
    // (2/ω)(√(1 + ζ²) − ζ) = 0.123607 s.
    const Json below = probes_after("3000", {"omega=10", "damping_ratio=0.5", "time_step=0.12237"});
    CHECK(value(below, "growth_theory") < 1);
    CHECK(value(below, "amplitude") < 1e-3);
    CHECK(contains(stopped("20000", {"omega=10", "damping_ratio=0.5", "time_step=0.124843"}), "123.6 ms"));
}

TEST_CASE("implicit Euler is finite at every step, and loses what theory says", "[process]") {
    for (const double w : {1e-3, 1., 1e3, 1e6}) {
        const Json probes = probes_after("2", {"scheme=implicit_euler", "omega=2", "time_step=" + exactly(w / 2)});
        const double factor = 1 / std::hypot(1, w);
        INFO(w);
        CHECK(std::abs(value(probes, "amplitude") / (factor * factor) - 1) < 1e-6);
        CHECK(std::abs(value(probes, "growth_theory") / factor - 1) < 1e-9);
    }
}

TEST_CASE("a pendulum whose Newton iterations do not suffice is not accepted", "[process]") {
    const Outcome outcome =
        call(integrate("3", {"system=pendulum", "x0=6", "scheme=implicit_euler", "time_step=0.5", "newton_iterations=2"}));
    INFO(outcome.err);
    CHECK(outcome.exit_code == diverged);
    CHECK(contains(outcome.err, "after 2 iterations"));
    CHECK(contains(outcome.err, "residual"));
    const Json enough = probes_after("3", {"system=pendulum", "x0=6", "scheme=implicit_euler", "time_step=0.5"});
    CHECK(value(enough, "newton_iterations_used") > 2);
}

TEST_CASE("drag a million times too strong: explicit is stopped, implicit comes to rest and never turns round", "[process]") {
    // 2ζωΔt = 1e6.
    const std::vector<std::string> scene{"omega=2", "damping_ratio=5e6", "time_step=0.05", "x0=0", "v0=1"};
    const auto by = [&](const char* scheme) {
        std::vector<std::string> settings = scene;
        settings.push_back(scheme);
        return settings;
    };
    for (const char* scheme : {"scheme=explicit_euler", "scheme=semi_implicit_euler", "scheme=runge_kutta_4"})
        CHECK(contains(stopped("100", by(scheme)), "implicit"));
    double before = 1;
    for (const char* steps : {"1", "2", "5"}) {
        const double v = value(probes_after(steps, by("scheme=implicit_euler")), "v");
        CHECK(std::abs(v) < before);
        CHECK(v > -1e-12);
        before = std::abs(v);
    }
    CHECK(before < 1e-6);
}

TEST_CASE("time integration: no steps, tiny steps, no spring, and what is none", "[process]") {
    const Json none = probes_after("0", {"x0=0.3", "v0=-0.7"});
    CHECK(value(none, "x") == 0.3);
    CHECK(value(none, "v") == -0.7);
    const Json tiny = json_of(integrate("100000", {"time_step=1e-6"}));
    CHECK(std::abs(tiny["time"].get<double>() - 0.1) < 1e-9);
    for (const char* scheme : {"scheme=explicit_euler", "scheme=bdf2", "scheme=newmark"}) {
        const Json free = probes_after("10", {"omega=0", "v0=2", scheme});
        CHECK(std::abs(value(free, "x") - 2) < 1e-12);
    }
    for (const auto& [setting, key] : {std::pair{"time_step=0", "time_step"},
                                       {"time_step=-1", "time_step"},
                                       {"omega=-1", "omega"},
                                       {"damping_ratio=-0.1", "damping_ratio"},
                                       {"stiffness_ratio=0", "stiffness_ratio"},
                                       {"newton_iterations=0", "newton_iterations"},
                                       {"integrator=euler", "integrator"}}) {
        const Outcome outcome = call(integrate("1", {setting}));
        INFO(setting << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
        CHECK(contains(outcome.err, std::string(key) + " = "));
    }
}
