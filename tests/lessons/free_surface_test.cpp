// The free surface: rest, waves, falling columns, what the conditions at the surface make of them, and the explanations of all of
// it.
#include "readings.h"

#include <pliant/text/format.h>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "why_checks.h"

#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
using std::numbers::pi;

namespace {

Runner lesson(const Runner::Assignments& assignments) { return Runner(find_lesson("fluids/free_surface"), assignments); }

Runner run(const Runner::Assignments& assignments, Index steps) {
    Runner runner = lesson(assignments);
    for (Index k = 0; k < steps; ++k) runner.step();
    return runner;
}

}  // namespace

TEST_CASE("free surface: still water has the pressure of its depth, and stays still", "[free_surface]") {
    const Runner right = run({{"column_width", "1"}, {"column_height", "0.37"}, {"resolution", "24"}, {"tolerance", "1e-9"}}, 5);
    CHECK(std::abs(value(right, "pressure_offset")) < 1e-7);
    CHECK(value(right, "kinetic_energy") < 1e-18);
    // On a face of the cells p = 0 in the cell of air is half a cell off.
    for (const char* n : {"20", "40"}) {
        const Runner off = run({{"column_width", "1"},
                                {"column_height", "0.3"},
                                {"resolution", n},
                                {"surface_condition", "at_cell_centre"},
                                {"tolerance", "1e-9"}},
                               2);
        CHECK(value(off, "pressure_offset") == Approx(9.81 / std::stod(n) / 2).epsilon(1e-6));
    }
}

TEST_CASE("free surface: a pressure that no surface sets has no offset, and a wave that dries the floor no theory",
          "[free_surface]") {
    const auto probe = [](const Runner::Assignments& settings, std::string_view name) {
        const Runner runner = run(settings, 2);
        Scene scene;
        runner.lesson().draw(scene);
        for (const Line& line : runner.lesson().lines) {
            Curve curve;
            line.reference(curve);
        }
        return runner.value(runner.lesson().probe(name));
    };
    CHECK_FALSE(probe({{"column_width", "1"}, {"column_height", "0.6"}}, "pressure_offset"));
    CHECK_FALSE(probe({{"scene", "wave"}, {"depth", "0.6"}, {"wave_height", "0"}}, "pressure_offset"));
    CHECK_FALSE(probe({{"column_width", "0"}}, "pressure_offset"));
    CHECK_FALSE(probe({{"surface_condition", "closed"}}, "pressure_offset"));
    CHECK(probe({{"column_width", "1"}, {"column_height", "0.59"}}, "pressure_offset"));
    const auto theory = [](const char* height) {
        const Runner wave = run({{"scene", "wave"}, {"depth", "0.1"}, {"wave_height", height}}, 1);
        return wave.exact(wave.lesson().probe("column_height_at_wall"));
    };
    CHECK(theory("0.1"));
    CHECK_FALSE(theory("0.11"));
    CHECK_FALSE(theory("-0.11"));
    CHECK_FALSE(probe({{"scene", "drop"}, {"depth", "0"}, {"drop_radius", "0"}}, "pressure_offset"));
    CHECK(probe({{"scene", "wave"}, {"depth", "0.1"}, {"wave_height", "-0.11"}}, "column_height_at_wall"));
}

TEST_CASE("free surface: the mould holds, and the light tells", "[free_surface]") {
    const Runner mould = run({{"surface_condition", "closed"}, {"resolution", "40"}}, 20);
    CHECK(value(mould, "front_position") == Approx(0.25).margin(2e-3));
    const auto& assumptions = mould.lesson().assumptions;
    const auto light = std::ranges::find(assumptions, "p = 0 at the surface", &Assumption::name);
    REQUIRE(light != assumptions.end());
    CHECK(light->value() > light->limit());
    REQUIRE(light->fix());
    CHECK(light->fix()->assign.front().second == "at_surface");
}

TEST_CASE("free surface: a wave goes down and up as linear theory says", "[free_surface]") {
    Runner runner =
        lesson({{"scene", "wave"}, {"depth", "0.5"}, {"wave_height", "0.02"}, {"resolution", "40"}, {"time_step", "0.006"}});
    const Probe& height = runner.lesson().probe("column_height_at_wall");
    Real worst = 0;
    while (runner.time() < 1.1) {
        runner.step();
        worst = std::max(worst, std::abs(*height.value() - *height.exact(runner.time())));
    }
    CHECK(worst < 0.004);
    CHECK(value(runner, "volume") == Approx(0.5).epsilon(1e-3));
}

TEST_CASE("free surface: a front of any size in its own units", "[free_surface]") {
    // The same column in metres and in millimetres of another gravity: the same ratio at the same number of steps.
    const auto front = [](Real unit) {
        const auto text = [](Real x) { return format_exact(x); };
        const Runner runner = run({{"tank_width", text(0.34 * unit)},
                                   {"tank_height", text(0.17 * unit)},
                                   {"column_width", text(0.05715 * unit)},
                                   {"column_height", text(0.1143 * unit)},
                                   {"gravity", text(9.81 * unit)},
                                   {"time_step", "0.002"},
                                   {"resolution", "64"}},
                                  54);
        return value(runner, "front_position") / (0.05715 * unit);
    };
    const Real metres = front(1);
    CHECK(metres > 2.292);  // filmed behind a gate that takes time to open
    CHECK(metres < 2.662);  // volume-of-fluid; coarse cells are late
    CHECK(front(1000) == Approx(metres).epsilon(1e-6));
}

TEST_CASE("free surface: without a keeper the gauge tells what is lost", "[free_surface]") {
    const Runner leaks = run({{"keep_volume", "false"}, {"resolution", "40"}, {"time_step", "0.008"}}, 60);
    const Runner keeps = run({{"keep_volume", "true"}, {"resolution", "40"}, {"time_step", "0.008"}}, 60);
    CHECK(value(keeps, "volume") == Approx(*keeps.lesson().probe("volume").exact(0)).epsilon(1e-6));
    CHECK(std::abs(value(leaks, "volume") / value(keeps, "volume") - 1) > 1e-3);
    CHECK(keeps.holds(0) == Holds::yes);
}

TEST_CASE("free surface: what does not fit is refused, with what would", "[free_surface]") {
    CHECK_THROWS_WITH(lesson({{"column_width", "1.5"}}),
                      ContainsSubstring("column_width") && ContainsSubstring("at most the width"));
    CHECK_THROWS_WITH(lesson({{"column_height", "0.7"}}), ContainsSubstring("at most the height of the tank"));
    CHECK_THROWS_WITH(lesson({{"scene", "wave"}, {"wave_height", "0.4"}}), ContainsSubstring("does not touch the lid"));
    CHECK_THROWS_WITH(lesson({{"scene", "paddle"}, {"paddle_stroke", "0.5"}}), ContainsSubstring("left half"));
    CHECK_THROWS_WITH(lesson({{"scene", "paddle"}, {"surface_condition", "closed"}}), ContainsSubstring("give way"));
    CHECK_THROWS_WITH(lesson({{"tank_height", "5000"}}), ContainsSubstring("cells"));
}

TEST_CASE("free surface: the corner of the column and the crest are handles", "[free_surface]") {
    const Runner column = lesson({});
    const auto set = column.lesson().dragged({.index = 0, .from = {0.25, 0.5, 0}, .to = {0.4, 2, 0}});
    REQUIRE(set.size() == 2);
    CHECK(set[0] == std::pair<std::string, Real>("column_width", 0.4));
    CHECK(set[1] == std::pair<std::string, Real>("column_height", 0.6));
    const Runner wave = lesson({{"scene", "wave"}});
    CHECK(wave.lesson().dragged({.index = 0, .from = {0, 0.33, 0}, .to = {0, 0.35, 0}})[0].second == Approx(0.05));
}

TEST_CASE("free surface: empty, full and tiny tanks run", "[free_surface]") {
    for (const Runner::Assignments& a : {Runner::Assignments{{"column_width", "0"}},
                                         {{"column_width", "1"}, {"column_height", "0.6"}},
                                         {{"resolution", "1"}},
                                         {{"resolution", "2"}},
                                         {{"gravity", "0"}},
                                         {{"gravity", "1e6"}},
                                         {{"time_step", "10"}}}) {
        const Runner runner = run(a, 4);
        INFO(a[0].first << " = " << a[0].second);
        CHECK(std::isfinite(value(runner, "kinetic_energy")));
        CHECK(std::isfinite(value(runner, "volume")));
    }
}

TEST_CASE("free surface: every number is explained in every scene", "[free_surface]") {
    for (const char* scene : {"column", "wave", "drop", "paddle"})
        for (const char* condition : {"at_surface", "at_cell_centre", "closed"}) {
            if (std::string_view(scene) == "paddle" && std::string_view(condition) == "closed") continue;
            Runner runner =
                lesson({{"scene", scene}, {"surface_condition", condition}, {"resolution", "24"}, {"time_step", "0.02"}});
            for (int k = 0; k < 6; ++k) runner.step();
            check_every_stage(runner, std::string(scene) + " " + condition, 2);
        }
}
