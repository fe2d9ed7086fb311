// Keys, actions and expectations as they are said.
#include <pliant/document/walkthrough.h>
#include <pliant/document/walkthrough_sentences.h>
#include <pliant/lesson/registry.h>
#include <pliant/lesson/setting_words.h>
#include <pliant/run/awaited.h>
#include <pliant/run/runner.h>
#include <pliant/text/format.h>
#include <pliant/text/quantity_text.h>
#include <pliant/text/spoken.h>

#include <catch2/catch_test_macros.hpp>

#include <limits>
#include <random>
#include <string>

using namespace pliant;

TEST_CASE("keys are said as names, counts in their number", "[sentences]") {
    CHECK(spoken("youngs_modulus") == "Young's modulus");
    CHECK(spoken("poisson_ratio") == "Poisson's ratio");
    CHECK(spoken("hookes_law") == "Hooke's law");
    CHECK(spoken("cfl") == "Courant number");
    CHECK(spoken("time_step") == "time step");
    CHECK(spoken("cell reynolds number") == "cell Reynolds number");
    CHECK(counted(1, "pass") == "1 pass");
    CHECK(counted(2, "pass") == "2 passes");
    CHECK(counted(0, "step") == "0 steps");
    for (const char* many : {"touching_nodes", "newton_iterations_used", "operations_green", "cells_x", "turns"}) {
        INFO(many);
        CHECK(is_or_are(spoken(many)) == "are");
    }
    for (const char* one :
         {"loss_per_turn", "mean_stress", "radius", "youngs_modulus", "energy", "u_on_faces", "hookes_law", "axis"}) {
        INFO(one);
        CHECK(is_or_are(spoken(one)) == "is");
    }
}

TEST_CASE("what a walkthrough does is a sentence without names for programs", "[sentences]") {
    const auto lesson = find_lesson("mesh/mass_spring").make();
    const auto said = [&](const char* line) { return action_sentence(*lesson, line); };
    CHECK(said("set scene=spin damping_mode=naive") ==
          "set scene to “spinning freely, no gravity” and damping mode to “naive: kᵈ (vⱼ − vᵢ)”");
    CHECK(said("set time_step=0.02 ground=false") == "set time step to 20 ms and ground to off");
    CHECK(said("run 1 steps") == "run 1 step");
    CHECK(said("run 50 steps") == "run 50 steps");
    CHECK(said("run 0.5 s") == "run 0.5 s of simulated time");
    CHECK(said("run rest") == "run until nothing changes any more");
    CHECK(said("run to spring_forces") == "run to the end of the stage “spring forces”");
    CHECK(said("show spring_force") == "colour by spring force");
    CHECK(said("pull 12 to 0 1 0") == "pull node 12 to (0, 1, 0) m");
    CHECK(said("reset") == "start again");
    // What cannot be read stays as it is.
    CHECK(said("set no_such=3") == "set no_such=3");
}

TEST_CASE("what Next does is told by its kind beside a question, and in full without one", "[sentences]") {
    const auto lesson = find_lesson("elasticity/poisson").make();
    const auto next = [&](const std::string& blocks) {
        return next_sentence(*lesson, parse_walkthrough("# W\n## One\n" + blocks, "w.md").slides[0]);
    };
    const std::string ask = "```ask\nWhere?\n```\n";
    CHECK(next(ask + "```do\nset axial_strain=0.3\nsolve\nset axial_strain=0.0154\nrun rest\n```\n") == "Next: sets it and runs");
    CHECK(next(ask + "```do\nreset\nrun 1 steps\nshow displacement\n```\n") == "Next: runs it");
    CHECK(next(ask + "```do\nrun 1 steps\nset axial_strain=0.2\n```\n") == "Next: runs it and sets it");
    CHECK(next(ask + "```do\nset axial_strain=0.2\n```\n```expect\nnarrowing > 0\n```\n").empty());
    CHECK(next("```do\nsolve\nset axial_strain=0.2\nrun rest\n```\n") ==
          "Next: set axial strain to 0.2; run until nothing changes any more");
}

TEST_CASE("settings and ranges are said with name, value and unit", "[sentences]") {
    const auto lesson = find_lesson("mesh/mass_spring").make();
    CHECK(settings_words(*lesson, {{"time_step", "0.02"}, {"cells_x", "4"}, {"ground", "false"}}, "to") ==
          "time step to 20 ms, cells along x to 4 and ground to off");
    CHECK(settings_words(*lesson, {{"integrator", "implicit_euler"}}) == "integrator “implicit Euler”");
    CHECK_THROWS_AS(settings_words(*lesson, {{"no_such", "1"}}), Refused);
    CHECK(range_words({0, 1e15}, "N/m") == "0 to 1000 TN/m");
    CHECK(range_words({1e-3, 10}, "s") == "1 ms to 10 s");
    CHECK(range_words({2, 10}, "s") == "2 to 10 s");
    CHECK(range_words({0, 1, true, false}, "") == "above 0 to 1");
    CHECK(range_words({-1, 0.5, true, true}, "") == "above -1 to below 0.5");
    const Parameter& dt = lesson->parameter("time_step");
    try {
        dt.parse("3 kg");
        FAIL("a time in kg");
    } catch (const Refused& e) {
        CHECK(refusal_words(dt, e.what()).starts_with("time step = '3 kg'"));
    }
}

TEST_CASE("what a walkthrough expects has units, and as many digits as tell the numbers apart", "[sentences]") {
    const auto lesson = find_lesson("mesh/mass_spring").make();
    CHECK(
        expectation_sentence(*lesson, {.name = "largest_strain", .comparison = ">", .left = 0.38068373752656204, .right = 0.1}) ==
        "the largest strain is 0.381, expected above 0.1");
    CHECK(expectation_sentence(*lesson,
                               {.name = "energy", .comparison = "<=", .left = 8.2, .right = 4.1, .what = "what it was before"}) ==
          "the energy is 8.2 J, expected at most 4.1 J, what it was before");
    CHECK(expectation_sentence(*lesson, {.name = "touching_nodes", .comparison = ">=", .left = 15, .right = 1}) ==
          "the touching nodes are 15, expected at least 1");
    CHECK(
        expectation_sentence(
            *lesson, {.name = "height", .comparison = "=", .left = 0.50001, .right = 0.5, .tolerance = 1e-3, .relative = true}) ==
        "the height is 500.01 mm, expected 500 mm, within 0.1 %");
}

TEST_CASE("a number in the unit that is shown reads back to the bit", "[sentences]") {
    std::mt19937 random(7);
    std::uniform_real_distribution<Real> mantissa(1, 10), exponent(-12, 12);
    for (const char* unit : {"s", "m", "Pa", "N/m", "N s/m", "kg", "m²/s", ""})
        for (int k = 0; k < 200; ++k) {
            const Real value = (k % 2 ? -1 : 1) * mantissa(random) * std::pow(10.0, exponent(random));
            const std::string shown = unit_shown(value, unit, 5), text = quantity_in(value, unit, shown);
            CAPTURE(unit, value, text);
            const QuantityText read = read_quantity(text, unit);
            CHECK(read.problem == QuantityText::Problem::none);
            CHECK(read.value == value);
            // The number alone, which a person may change digit by digit, is in the same unit.
            const QuantityText bare = read_quantity(text.substr(0, text.find(' ')), unit, shown);
            CHECK(bare.value == value);
        }
    CHECK(quantity_in(0.012345678901, "s", "ms") == "12.345678901 ms");
    CHECK(quantity_in(0, "s", "s") == "0 s");
    CHECK(read_quantity("20", "s", "ms").value == 0.02);
    CHECK(read_quantity("20 s", "s", "ms").value == 20);
    CHECK(read_quantity("1", "m²", "mm²").value == 1e-6);
    // What can be read in two ways is not guessed at, whatever the unit.
    CHECK(read_quantity("1,250", "s", "ms").problem == QuantityText::Problem::ambiguous);
    CHECK(read_quantity("1,250 ms", "s").problem == QuantityText::Problem::ambiguous);
}

TEST_CASE("what no stage has computed yet is awaited, what the start has is not", "[sentences]") {
    Runner runner(find_lesson("fluids/projection"));
    const auto& after = runner.lesson().field("divergence_after");
    REQUIRE(awaited_stage(runner, after) != nullptr);
    CHECK(awaited_stage(runner, runner.lesson().probe("max_divergence")) != nullptr);
    runner.step();
    CHECK(awaited_stage(runner, after) == nullptr);
    CHECK(awaited_stage(runner, runner.lesson().probe("max_divergence")) == nullptr);
    runner.reset();
    CHECK(awaited_stage(runner, after) != nullptr);

    Runner springs(find_lesson("mesh/mass_spring"));
    CHECK(awaited_stage(springs, springs.lesson().field("position")) == nullptr);
    CHECK(awaited_stage(springs, springs.lesson().field("velocity")) == nullptr);  // it is at rest: that is known
    const Stage* forces = awaited_stage(springs, springs.lesson().field("spring_force"));
    REQUIRE(forces != nullptr);
    CHECK(forces->name == "spring_forces");
    springs.step_stage();
    CHECK(awaited_stage(springs, springs.lesson().field("spring_force")) == nullptr);
    CHECK(awaited_stage(springs, springs.lesson().probe("energy")) == nullptr);
}
