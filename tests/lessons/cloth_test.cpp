// The cloth lesson: what its scenes must show.
#include <pliant/document/scene_file.h>
#include <pliant/run/runner.h>
#include <pliant/text/texts.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

struct Run : Runner {
    explicit Run(Assignments settings = {}) : Runner(find_lesson("mesh/cloth"), settings) {}
    Real probe(std::string_view name) const { return value(lesson().probe(name)).value(); }
    Eigen::Map<const Points<3>> vectors(std::string_view field) const {
        const auto all = lesson().field(field).view();
        return {all.data(), 3, static_cast<Index>(all.size() / 3)};
    }
    void steps(int count) {
        for (int k = 0; k < count; ++k) step();
    }
};

}  // namespace

TEST_CASE("cloth: at rest without weight every bit stays as it is") {
    Run run({{"gravity", "0"}, {"scene", "pedestal"}, {"nodes", "9"}});
    const auto before = state_hash(run.lesson());
    const Points<3> x = run.vectors("position");
    run.steps(5);
    CHECK(run.vectors("position") == x);
    CHECK(run.vectors("velocity").isZero(0));
    CHECK(before != 0);
}

TEST_CASE("cloth: inner forces sum to nothing, and the held edge bears the weight") {
    Run run({{"scene", "hanging_edge"}, {"nodes", "9"}, {"damping", "0.05"}, {"newton_cap", "10"}, {"linear_iterations", "200"}});
    run.steps(400);
    const Points<3> f = run.vectors("spring_force");
    CHECK(f.rowwise().sum().norm() < 1e-11);
    Real held = 0;
    for (Index i = 0; i < 9; ++i) held += f(1, 72 + i);
    CHECK_THAT(held, WithinRel(-0.2 * 9.81 * 8 / 9, 2e-3));
    // By statics, the springs of a column under the held edge: with shear springs slack in the middle, an eighth of it each.
    CHECK_THAT(run.probe("lowest"), WithinAbs(-1, 0.01));
}

TEST_CASE("cloth: the energy never grows without wind, in every scene and down to rest") {
    for (const char* scene : {"hanging_corners", "hanging_edge", "drape", "flag", "pedestal"}) {
        Run run({{"scene", scene}, {"nodes", "13"}});
        INFO(scene);
        Real highest = run.probe("energy");
        for (int k = 0; k < 90; ++k) {
            run.step();
            REQUIRE(run.holds(0) == Holds::yes);
        }
        CHECK(run.probe("energy") < highest - 0.02);
    }
}

TEST_CASE("cloth: a draped sheet lies on the sphere, none of it inside, and comes to rest") {
    Run run({{"scene", "drape"}, {"nodes", "17"}, {"friction", "0.6"}});
    const Vec<3> centre(0, -0.27, 0);
    for (int k = 0; k < 300; ++k) {
        run.step();
        REQUIRE((run.vectors("position").colwise() - centre).colwise().norm().minCoeff() > 0.25 * (1 - 1e-12));
    }
    CHECK(run.probe("kinetic_energy") < 1e-5);
    CHECK(run.probe("touching_nodes") > 20);
    CHECK(run.probe("largest_strain") < 0.03);
    // The scene is symmetric under reflection, and so is the drape, as far as the steps are solved.
    const auto x = run.vectors("position");
    Real skew = 0;
    for (Index j = 0; j < 17; ++j)
        for (Index i = 0; i < 17; ++i) skew = std::max(skew, std::abs(x(1, i + 17 * j) - x(1, 16 - i + 17 * j)));
    CHECK(skew < 1e-3);
}

TEST_CASE("cloth: strain limiting holds stretch to its limit, at a cost in passes that it tells") {
    const Runner::Assignments soft{{"nodes", "13"}, {"k_structural", "20"}, {"k_shear", "5"}, {"k_bending", "0.1"}};
    Run free(soft), limited(soft);
    limited.assign({{"strain_limiting", "on"}, {"strain_limit", "0.05"}, {"limit_passes", "200"}});
    free.steps(60), limited.steps(60);
    CHECK(free.probe("largest_strain") > 0.15);
    CHECK(limited.probe("largest_strain") < 0.06);
    CHECK(limited.probe("strain_before_limiting") > limited.probe("largest_strain"));
    CHECK(limited.probe("limiting_passes") > 1);
    CHECK(limited.vectors("position").col(12 * 13) == free.vectors("position").col(12 * 13));
}

TEST_CASE("cloth: stronger bending springs hold the sheet out further in the drape test") {
    Real last = 0;
    for (const char* k_bending : {"0.1", "10", "1000"}) {
        Run run({{"scene", "pedestal"}, {"nodes", "11"}, {"damping", "0.03"}, {"k_bending", k_bending}});
        run.steps(120);
        INFO(k_bending);
        CHECK(run.probe("drape_coefficient") > last);
        last = run.probe("drape_coefficient");
    }
    CHECK(last > 0.7);
}

TEST_CASE("cloth: a full Newton solve leaves nothing unbalanced, with either linear solver") {
    Run solved({{"nodes", "9"}, {"newton", "full"}, {"newton_tolerance", "1e-7"}});
    solved.steps(10);
    CHECK(solved.probe("imbalance") < 1e-5);
    Run direct({{"nodes", "9"}, {"newton", "full"}, {"newton_tolerance", "1e-7"}, {"linear_solver", "direct"}});
    direct.steps(10);
    CHECK((solved.vectors("position") - direct.vectors("position")).cwiseAbs().maxCoeff() < 1e-5);
    CHECK_THROWS_AS(Run({{"nodes", "64"}, {"linear_solver", "direct"}}), Refused);
}

TEST_CASE("cloth: explicit schemes meet their limit, and the assumption tells the way out") {
    Run run({{"nodes", "9"}, {"scheme", "semi_implicit_euler"}});
    const Assumption& stability = run.lesson().assumptions.front();
    REQUIRE(stability.name == "stability");
    CHECK(stability.value() > stability.limit());
    CHECK_THROWS_AS(run.steps(300), Diverged);
    CHECK_THAT(run.lesson().blow_up_hint(), ContainsSubstring("implicit Euler"));
    Run small({{"nodes", "9"}, {"scheme", "semi_implicit_euler"}, {"time_step", "5e-4"}});
    small.steps(300);
    CHECK(small.probe("largest_strain") < 0.2);
}

TEST_CASE("cloth: a hand draws a node to itself, and wind lifts a flag") {
    Run run({{"nodes", "9"}, {"pull_stiffness", "100"}});
    run.pull(Pull{.index = 4, .from = Vec<3>::Zero(), .to = Vec<3>(0, 0.3, 0)});
    run.steps(60);
    CHECK((run.vectors("position").col(4) - Vec<3>(0, 0.3, 0)).norm() < 0.1);
    Run still({{"scene", "flag"}, {"nodes", "9"}}), windy({{"scene", "flag"}, {"nodes", "9"}, {"wind", "12"}});
    still.steps(120), windy.steps(120);
    CHECK(windy.probe("gravitational_energy") > still.probe("gravitational_energy") + 0.05);
}
