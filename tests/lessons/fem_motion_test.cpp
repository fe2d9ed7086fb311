// Finite elements in motion: what comes to rest where the equilibrium is, what spins, what falls, how fast a body can vibrate.
#include "readings.h"

#include <pliant/run/runner.h>
#include <pliant/run/until.h>

#include "why_checks.h"

#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Runner::Assignments with(Runner::Assignments more) {
    more.insert(more.end(), {{"cells_x", "4"}, {"cells_y", "1"}, {"cells_z", "1"}});
    return more;
}

Runner run_for(Runner::Assignments scene, int steps) {
    Runner runner(find_lesson("mesh/fem"), with(std::move(scene)));
    for (int k = 0; k < steps; ++k) runner.step();
    REQUIRE_FALSE(runner.failure());
    return runner;
}

}  // namespace

TEST_CASE("fem: a body in motion comes to rest in its equilibrium", "[fem]") {
    Runner still(find_lesson("mesh/fem"), with({}));
    still.step();
    const Runner moved = run_for({{"motion", "dynamic"}, {"gravity", "0"}, {"mass_damping", "5"}, {"time_step", "0.05"}}, 200);
    CHECK_THAT(value(moved, "tip_y"), WithinRel(value(still, "tip_y"), 1e-3));
    CHECK(moved.lesson().at_rest());
}

TEST_CASE("fem: a body that spins keeps its momentum in every model, and its volume in all but the linear one", "[fem]") {
    for (const char* model : {"linear", "corotational", "stvk", "neo_hookean"}) {
        INFO(model);
        const Runner runner =
            run_for({{"scene", "spin"}, {"model", model}, {"youngs_modulus", "1e5"}, {"time_step", "0.02"}}, 30);
        CHECK(value(runner, "momentum") < 1e-9);
        CHECK((value(runner, "volume_ratio") > 1.1) == (std::string(model) == "linear"));
        check_laws(runner);
    }
}

TEST_CASE("fem: what falls obeys gravity until it meets the ground, and does not sink into it", "[fem]") {
    Runner runner(find_lesson("mesh/fem"), with({{"scene", "drop"}, {"youngs_modulus", "1e5"}, {"mass_damping", "0"}}));
    const Real start = value(runner, "height");
    for (int k = 0; k < 10; ++k) runner.step();
    // Implicit Euler falls by g Δt² n (n + 1)/2.
    CHECK_THAT(start - value(runner, "height"), WithinRel(9.81 * 1e-4 * 55, 1e-6));
    for (int k = 0; k < 90; ++k) runner.step();
    REQUIRE_FALSE(runner.failure());
    const auto x = field(runner, "position");
    for (std::size_t k = 1; k < x.size(); k += 3) CHECK(x[k] >= -1e-12);
    CHECK(value(runner, "height") < start);
}

TEST_CASE("fem: explicit steps hold below the limit that the fastest vibration sets, and not above", "[fem]") {
    const Runner rest = run_for({{"motion", "dynamic"}, {"model", "linear"}}, 1);
    const Real limit = value(rest, "stable_time_step");
    CHECK_THAT(limit, WithinRel(2 / value(rest, "highest_frequency"), 1e-12));
    const auto energy_after = [&](Real share) {
        Runner runner(find_lesson("mesh/fem"), with({{"motion", "dynamic"},
                                                     {"model", "linear"},
                                                     {"mass_damping", "0"},
                                                     {"integrator", "semi_implicit_euler"},
                                                     {"time_step", std::to_string(share * limit)}}));
        try {
            for (int k = 0; k < 400; ++k) runner.step();
        } catch (const Diverged&) {
            return HUGE_VAL;
        }
        return value(runner, "kinetic_energy");
    };
    CHECK(energy_after(0.95) < 100);
    CHECK(energy_after(1.1) > 1e6);
}

TEST_CASE("fem: with lumped masses the fastest vibration is slower, by less than that of one tetrahedron", "[fem]") {
    const Runner lumped = run_for({{"mass", "lumped"}}, 1), consistent = run_for({{"mass", "consistent"}}, 1);
    const Real ratio = value(consistent, "highest_frequency") / value(lumped, "highest_frequency");
    CHECK(ratio > 1.5);
    CHECK(ratio <= std::sqrt(5.0) + 1e-9);
    // Four times the density, half as fast.
    const Runner heavy = run_for({{"density", "4000"}}, 1);
    CHECK_THAT(value(heavy, "highest_frequency"), WithinRel(value(lumped, "highest_frequency") / 2, 1e-7));
}

TEST_CASE("fem: a hand pulls a body in motion towards it", "[fem]") {
    Runner runner(find_lesson("mesh/fem"), with({{"motion", "dynamic"}, {"gravity", "0"}, {"load_y", "0"}}));
    runner.pull(Pull{.index = 4, .from = Vec<3>(1, 0, 0), .to = Vec<3>(1, 0.5, 0)});
    for (int k = 0; k < 20; ++k) runner.step();
    CHECK(value(runner, "tip_y") > 1e-3);
    runner.pull(std::nullopt);
    for (int k = 0; k < 5; ++k) runner.step();
    REQUIRE_FALSE(runner.failure());
}

TEST_CASE("fem: every number of a body in motion is explained, with each integrator and mass", "[fem]") {
    const Runner::Assignments moving{
        {"motion", "dynamic"}, {"time_step", "1e-4"}, {"mass_damping", "0.5"}, {"stiffness_damping", "1e-4"}};
    for (const char* integrator : {"explicit_euler", "semi_implicit_euler", "implicit_euler"})
        for (const char* mass : {"lumped", "consistent"})
            for (const char* element : {"linear", "quadratic"}) {
                Runner::Assignments scene = moving;
                scene.insert(scene.end(), {{"integrator", integrator}, {"mass", mass}, {"element", element}});
                Runner runner(find_lesson("mesh/fem"), with(std::move(scene)));
                check_every_stage(runner, std::string(integrator) + " " + mass + " " + element, 2);
            }
    // On the ground as well.
    Runner fallen(find_lesson("mesh/fem"),
                  with({{"scene", "drop"}, {"drop_height", "0.01"}, {"tilt", "0"}, {"youngs_modulus", "1e5"}}));
    for (int k = 0; k < 8; ++k) fallen.step();
    check_every_stage(fallen, "on the ground", 2);
}
