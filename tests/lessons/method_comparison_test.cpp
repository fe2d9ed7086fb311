// All methods of a lesson in one scene.
#include <pliant/study/method_comparison.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Outcome = MethodRun::Outcome;

namespace {

const MethodRun& run_of(const MethodComparison& c, std::string_view option) {
    const auto found = std::ranges::find(c.runs, option, &MethodRun::option);
    REQUIRE(found != c.runs.end());
    return *found;
}

}  // namespace

TEST_CASE("methods: eight schemes on the oscillator grow, hold and lose as theory says", "[methods]") {
    const SceneFile scene{.lesson = "time/integration", .parameters = {{"time_step", "0.05"}, {"omega", "2"}}};
    const MethodComparison c = compare_methods(scene, "", Until::after_time(31.4));
    CHECK(c.parameter == "integrator");
    CHECK(c.reference == "the exact solution");
    CHECK(c.runs.size() == 8);
    CHECK(run_of(c, "explicit_euler").outcome == Outcome::grows);
    CHECK(run_of(c, "implicit_euler").outcome == Outcome::loses);
    CHECK(run_of(c, "semi_implicit_euler").outcome == Outcome::steady);
    REQUIRE(run_of(c, "runge_kutta_4").error);
    CHECK(*run_of(c, "runge_kutta_4").error < 1e-3);
    CHECK(*run_of(c, "explicit_euler").error > 0.1);
    for (const MethodRun& r : c.runs) {
        CHECK(r.steps == c.steps);
        CHECK(r.passes >= r.steps);
        CHECK(r.curve.size() > 10);
    }
}

TEST_CASE("methods: one that breaks down says when and where; the others run to the end", "[methods]") {
    const SceneFile scene{.lesson = "mesh/mass_spring",
                          .parameters = {{"scene", "spin"}, {"damping_mode", "none"}, {"time_step", "5e-3"}}};
    const MethodComparison c = compare_methods(scene, "", Until::after_time(0.5));
    const MethodRun& broken = run_of(c, "explicit_euler");
    CHECK(broken.outcome == Outcome::stopped);
    CHECK_THAT(broken.words, ContainsSubstring("stops at") && ContainsSubstring("in the stage"));
    CHECK_FALSE(broken.error);
    CHECK(broken.steps < c.steps);
    CHECK(run_of(c, "implicit_euler").outcome == Outcome::loses);
    CHECK_THAT(comparison_text(c), ContainsSubstring("stopped") && ContainsSubstring("implicit Euler"));
}

TEST_CASE("methods: the same scene gives the same table, but for the time that it took", "[methods]") {
    const SceneFile scene{.lesson = "fluids/diffusion", .parameters = {}};
    const MethodComparison a = compare_methods(scene, "", Until::after_steps(20)),
                           b = compare_methods(scene, "", Until::after_steps(20));
    REQUIRE(a.runs.size() == b.runs.size());
    for (std::size_t k = 0; k < a.runs.size(); ++k) {
        CHECK(a.runs[k].value == b.runs[k].value);
        CHECK(a.runs[k].error == b.runs[k].error);
        CHECK(a.runs[k].passes == b.runs[k].passes);
    }
}

TEST_CASE("methods: where the exact course ends before the run, a finer run is measured against", "[methods]") {
    const SceneFile scene{.lesson = "mesh/mass_spring", .parameters = {}};
    // Free fall to the ground, and on.
    const MethodComparison fall = compare_methods(scene, "", Until::after_time(0.02)),
                           bounce = compare_methods(scene, "", Until::after_time(0.8));
    CHECK(fall.reference == "the exact solution");
    CHECK(bounce.probe == "height");
    CHECK_THAT(bounce.reference, ContainsSubstring("finer"));
    CHECK(bounce.no_error.empty());
    CHECK(run_of(bounce, "implicit_euler").error);
}

TEST_CASE("methods: of the solvers of a projection the divergence that they leave is compared", "[methods]") {
    const MethodComparison c = compare_methods({.lesson = "fluids/projection", .parameters = {}}, "solver", Until::at_rest());
    CHECK(c.probe == "max_divergence");
    CHECK_THAT(c.no_error, ContainsSubstring("neither"));
    REQUIRE(c.runs.front().value);
    CHECK(std::ranges::any_of(c.runs, [&](const MethodRun& r) { return r.value != c.runs.front().value; }));
}

TEST_CASE("methods: any choice can be compared, and what is none is refused with those that there are", "[methods]") {
    const SceneFile scene{.lesson = "fluids/projection", .parameters = {}};
    const MethodComparison c = compare_methods(scene, "solver", Until::at_rest());
    CHECK(run_of(c, "multigrid").passes < run_of(c, "cg").passes);
    CHECK_THROWS_WITH(compare_methods(scene, "resolution", Until::at_rest()),
                      ContainsSubstring("no choice") && ContainsSubstring("solver"));
}
