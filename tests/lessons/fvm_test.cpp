// Finite volumes: face forces against finite elements in every scene, and what moves by them.
#include "readings.h"

#include <pliant/run/runner.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const char* const all_laws[] = {"linear", "corotational", "stvk", "neo_hookean"};

Runner volumes_after(Index steps, const Runner::Assignments& parameters) {
    Runner runner(find_lesson("mesh/fvm"), parameters);
    for (Index k = 0; k < steps; ++k) runner.step();
    return runner;
}

}  // namespace

TEST_CASE("fvm: the stages stand in the lecture's order, and only those that the scene needs") {
    CHECK(stage_names(volumes_after(0, {})) == Names{"areas", "deformation", "rotation", "strain", "stress", "true_stress",
                                                     "face_forces", "share", "finite_element_force", "external_forces",
                                                     "integrate"});
    CHECK(stage_names(volumes_after(0, {{"scene", "free"}, {"model", "stvk"}})) ==
          Names{"areas", "deformation", "strain", "stress", "true_stress", "face_forces", "share", "finite_element_force",
                "integrate"});
}

TEST_CASE("fvm: shared face forces are those of finite elements, in every scene and law") {
    for (const char* scene : {"panel", "beam", "free"})
        for (const char* law : all_laws) {
            INFO(scene << " " << law);
            const Runner runner =
                volumes_after(60, {{"scene", scene}, {"model", law}, {"plane", "strain"}, {"load_y", "-2000"}, {"spin", "8"}});
            const auto by_faces = field(runner, "force"), by_energy = field(runner, "finite_element_force");
            Real apart = 0, largest = 0;
            for (std::size_t k = 0; k < by_faces.size(); ++k) {
                apart = std::max(apart, std::abs(by_faces[k] - by_energy[k]));
                largest = std::max(largest, std::abs(by_energy[k]));
            }
            // A linear body that spins flies apart without forces.
            if (std::string(scene) != "free" || std::string(law) != "linear") CHECK(largest > 1);
            CHECK(apart <= 1e-12 * largest);
            CHECK(value(runner, "difference_from_fem") <= 1e-12);
            CHECK(value(runner, "difference_of_forms") <= 1e-12);
            CHECK(value(runner, "sum_of_faces") <= 1e-12 * std::max<Real>(1e-3, value(runner, "largest_face_force")));
            check_laws(runner);
        }
}

TEST_CASE("fvm: nothing outside, no momentum gained; and a law without couples keeps the angular one") {
    for (const char* law : {"corotational", "stvk", "neo_hookean"}) {
        INFO(law);
        const Runner runner = volumes_after(300, {{"scene", "free"}, {"model", law}, {"plane", "strain"}});
        CHECK(value(runner, "momentum") < 1e-9);
        CHECK_THAT(value(runner, "angular_momentum"), WithinRel(exact(runner, "angular_momentum"), 1e-10));
        CHECK(std::abs(value(runner, "smallest_volume") - 1) < 0.02);
        check_laws(runner);
    }
    // Every node flies straight on: det F = 1 + (Ω t)².
    const Runner linear = volumes_after(200, {{"scene", "free"}, {"model", "linear"}});
    CHECK_THAT(value(linear, "smallest_volume"), WithinRel(1 + 1.2 * 1.2, 1e-9));
    CHECK_FALSE(holds(linear, "small_rotations"));
}

TEST_CASE("fvm: the limit of stability is where it is said to be") {
    const Real limit = value(volumes_after(0, {}), "stable_time_step");
    CHECK_THAT(limit, WithinRel(8.697e-3, 1e-3));
    const auto energy_at = [&](Real part) {
        return value(volumes_after(400, {{"time_step", std::to_string(part * limit)}}), "kinetic_energy");
    };
    CHECK(energy_at(0.97) < 100);
    CHECK_THROWS_AS(energy_at(1.1), Diverged);
    CHECK(std::isfinite(value(volumes_after(5, {{"integrator", "implicit_euler"}, {"time_step", "10"}}), "tip_y")));
}

TEST_CASE("fvm: it comes to rest where a slender beam would, the nearer the finer it is cut") {
    const Real slender = 2 / (3 * 2e5 * 0.001 / 12);
    const auto short_of_it = [&](const char* along, const char* up) {
        const Runner runner = volumes_after(60, {{"height", "0.1"},
                                                 {"cells_x", along},
                                                 {"cells_y", up},
                                                 {"load_y", "-2"},
                                                 {"damping", "3"},
                                                 {"poisson_ratio", "0"},
                                                 {"time_step", "0.5"},
                                                 {"integrator", "implicit_euler"}});
        CHECK(runner.lesson().at_rest());
        check_laws(runner);
        return 1 + value(runner, "tip_y") / slender;
    };
    const Real coarse = short_of_it("32", "4"), fine = short_of_it("64", "8");
    CHECK(coarse > 0.1);
    CHECK(coarse < 0.25);
    CHECK(fine > 0);
    CHECK(fine < 0.4 * coarse);  // second order: a quarter
}

TEST_CASE("fvm: in other units of length it is the same") {
    const Runner small = volumes_after(50, {});
    const Runner large = volumes_after(50, {{"length", "1e6"}, {"height", "4e5"}, {"density", "1e-9"}, {"load_y", "-3e8"}});
    CHECK_THAT(value(large, "tip_y") / 1e6, WithinRel(value(small, "tip_y"), 1e-6));
    CHECK_THAT(value(large, "stable_time_step"), WithinRel(value(small, "stable_time_step"), 1e-6));
}

TEST_CASE("fvm: the loop goes element by element, larger bodies some at a time") {
    const auto rounds = [](const Runner& runner) {
        return std::ranges::count_if(runner.executed_before(), [](const Execution& e) { return e.stage->name == "share"; });
    };
    CHECK(rounds(volumes_after(1, {})) == 24);
    CHECK(rounds(volumes_after(1, {{"scene", "beam"}})) == 29);  // 144 tetrahedra, five at a time
    // In the middle of the loop some faces have their forces, others not.
    Runner runner = volumes_after(100, {});
    runner.run_to_stage("face_forces");
    const auto forces = field(runner, "face_force");
    CHECK(std::ranges::count_if(forces, [](Real f) { return f != 0; }) <= 6);
    CHECK(std::ranges::count_if(forces, [](Real f) { return f != 0; }) > 0);
}

TEST_CASE("fvm: a hand pulls at a node") {
    Runner runner(find_lesson("mesh/fvm"), {{"load_y", "0"}});
    runner.step();
    CHECK(value(runner, "tip_y") == 0);
    runner.pull(Pull{6, Vec<3>(1, 0, 0), Vec<3>(1, 0.3, 0)});
    for (int k = 0; k < 50; ++k) runner.step();
    CHECK(value(runner, "tip_y") > 1e-3);
    CHECK(value(runner, "difference_from_fem") <= 1e-12);
}
