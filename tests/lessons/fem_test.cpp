// Finite elements: published and independently computed values, locking, a beam that bends far, rotation, what the hand does.
#include "readings.h"

#include <pliant/run/runner.h>
#include <pliant/text/format.h>

#include "why_checks.h"

#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Runner solved(Runner::Assignments assignments) {
    Runner runner(find_lesson("mesh/fem"), std::move(assignments));
    runner.step();
    INFO((runner.failure() ? runner.failure()->what : std::string()));
    REQUIRE_FALSE(runner.failure());
    return runner;
}

Runner panel(const char* plane, Real nu, int cells, const char* element = "linear") {
    return solved({{"scene", "cook"},
                   {"model", "linear"},
                   {"plane", plane},
                   {"element", element},
                   {"youngs_modulus", "1"},
                   {"poisson_ratio", format_exact(nu)},
                   {"load_y", "1"},
                   {"cells_x", std::to_string(cells)},
                   {"cells_y", std::to_string(cells)}});
}

// A slender beam without narrowing under F L²/(E I) = a.
Runner slender_beam(const char* model, Real a) {
    const Real inertia = std::pow(0.05, 4) / 12;
    return solved({{"model", model},
                   {"element", "quadratic"},
                   {"poisson_ratio", "0"},
                   {"youngs_modulus", "1e6"},
                   {"height", "0.05"},
                   {"width", "0.05"},
                   {"load_y", format_exact(-a * 1e6 * inertia)},
                   {"cells_x", "16"},
                   {"cells_y", "1"},
                   {"cells_z", "1"},
                   {"load_steps", "4"}});
}

}  // namespace

TEST_CASE("fem: errors of a solution that is known are those of an independent package", "[fem]") {
    struct Row {
        int n;
        Real l2, h1;
    };
    for (const auto& [n, l2, h1] : {Row{8, 3.4716e-3, 6.6812e-2}, Row{16, 9.3133e-4, 3.3588e-2}, Row{32, 2.3786e-4, 1.6804e-2}}) {
        const std::string cells = std::to_string(n);
        const Runner runner = solved(
            {{"scene", "manufactured"}, {"plane", "strain"}, {"youngs_modulus", "1e4"}, {"cells_x", cells}, {"cells_y", cells}});
        CHECK_THAT(value(runner, "l2_error"), WithinRel(l2, 1e-4));
        CHECK_THAT(value(runner, "h1_error"), WithinRel(h1, 1e-4));
    }
}

TEST_CASE("fem: Cook's membrane bends as in an independent package, and locks as there", "[fem]") {
    CHECK_THAT(value(panel("stress", 1.0 / 3, 8), "middle_y"), WithinRel(17.3312, 1e-5));
    CHECK_THAT(value(panel("stress", 1.0 / 3, 16), "middle_y"), WithinRel(21.5922, 1e-5));
    CHECK_THAT(value(panel("stress", 1.0 / 3, 16, "quadratic"), "middle_y"), WithinRel(23.96, 3e-3));
    CHECK_THAT(value(panel("strain", 0.3, 16), "middle_y"), WithinRel(19.60, 3e-4));
    CHECK_THAT(value(panel("strain", 0.49, 8), "middle_y"), WithinRel(7.395, 1e-4));
    CHECK_THAT(value(panel("strain", 0.4999, 8), "middle_y"), WithinRel(5.247, 1e-4));
    const Runner locked = panel("strain", 0.4999, 32);
    CHECK_THAT(value(locked, "middle_y"), WithinRel(5.743, 1e-4));
    CHECK_FALSE(holds(locked, "no locking"));
    // Quadratic triangles do not, with fewer unknowns.
    const Runner cured = panel("strain", 0.4999, 8, "quadratic");
    CHECK(value(cured, "middle_y") > 0.9 * 18.46);
    CHECK(value(cured, "unknowns") < 0.3 * value(locked, "unknowns"));
    CHECK(holds(cured, "no locking"));
}

TEST_CASE("fem: a panel is the same in other units", "[fem]") {
    const Real once = value(panel("stress", 0.2, 4), "middle_y");
    const Runner scaled = solved({{"scene", "cook"},
                                  {"model", "linear"},
                                  {"youngs_modulus", "1e9"},
                                  {"poisson_ratio", "0.2"},
                                  {"load_y", "1e9"},
                                  {"cells_x", "4"},
                                  {"cells_y", "4"}});
    CHECK_THAT(value(scaled, "middle_y"), WithinRel(once, 1e-9));
    // A beam a million times as long, and as loaded.
    const Runner small = solved({}),
                 large = solved({{"length", "1e6"}, {"height", "2e5"}, {"width", "2e5"}, {"load_y", "-2e14"}});
    CHECK_THAT(value(large, "tip_y") / 1e6, WithinRel(value(small, "tip_y"), 1e-6));
}

TEST_CASE("fem: a slender beam bends as the elastica does, and the linear one is drawn out", "[fem]") {
    for (const auto& [a, deflection, reach] : {std::tuple{1.0, 0.3017208, 0.9435668}, std::tuple{10.0, 0.8106090, 0.4450044}})
        for (const char* model : {"corotational", "stvk", "neo_hookean"}) {
            INFO(model << " " << a);
            const Runner runner = slender_beam(model, a);
            CHECK_THAT(-value(runner, "tip_y"), WithinRel(deflection, 0.02));
            CHECK_THAT(1 + value(runner, "tip_x"), WithinRel(reach, 0.02));
            CHECK_THAT(value(runner, "elastica_deflection"), WithinAbs(deflection, 1e-6));
            check_laws(runner);
        }
    const Runner linear = slender_beam("linear", 10);
    CHECK_THAT(-value(linear, "tip_y"), WithinRel(10.0 / 3, 0.02));
    CHECK_FALSE(holds(linear, "small rotation"));
}

TEST_CASE("fem: a rotation of the whole is nothing to every model but the linear one", "[fem]") {
    for (const char* model : {"linear", "corotational", "stvk", "neo_hookean"})
        for (const char* element : {"linear", "quadratic"}) {
            INFO(model << " " << element);
            const Runner runner = solved({{"scene", "twist"},
                                          {"turned", "support"},
                                          {"twist_angle", "60"},
                                          {"model", model},
                                          {"element", element},
                                          {"load_steps", "3"},
                                          {"cells_x", "3"},
                                          {"cells_y", "1"},
                                          {"cells_z", "1"}});
            const bool inflates = std::string(model) == "linear";
            CHECK((value(runner, "volume_ratio") > 1.5) == inflates);
            CHECK((value(runner, "strain_energy") > 1) == inflates);
            if (inflates) continue;
            CHECK_THAT(value(runner, "volume_ratio"), WithinAbs(1, 1e-6));
            CHECK(value(runner, "strain_energy") < 1e-6);
        }
}

TEST_CASE("fem: K is assembled element by element, and its diagonal ends as that of the matrix", "[fem]") {
    Runner runner(find_lesson("mesh/fem"), {{"scene", "cook"}, {"cells_x", "2"}, {"cells_y", "1"}, {"model", "linear"}});
    while (!runner.last_stage() || runner.stages()[*runner.last_stage()]->name != "assembly") runner.step_pass();
    // A pass an element: 4 triangles.
    std::vector<Real> sums;
    for (int k = 0; k < 4; ++k) {
        Real sum = 0;
        for (const Real x : field(runner, "assembled")) sum += x;
        sums.push_back(sum);
        if (k < 3) runner.step_pass();
    }
    CHECK(std::ranges::is_sorted(sums));
    CHECK(sums.front() > 0);
    CHECK(std::ranges::adjacent_find(sums) == sums.end());
    runner.step_pass();
    CHECK(runner.stages()[*runner.last_stage()]->name == "load");
}

TEST_CASE("fem: a hand that draws a node adds its force, and the rest of the solve begins anew", "[fem]") {
    Runner runner(find_lesson("mesh/fem"), {{"model", "linear"}, {"load_y", "0"}, {"pull_stiffness", "100"}});
    runner.step();
    CHECK(value(runner, "tip_y") == 0);
    CHECK(runner.lesson().at_rest());
    runner.pull(Pull{.index = 8, .from = Vec<3>::Zero(), .to = Vec<3>(0, -0.5, 0)});
    runner.step();
    CHECK(value(runner, "tip_y") < -1e-3);
    check_laws(runner);
    Real loads = 0;
    for (std::size_t k = 1; k < field(runner, "load").size(); k += 3) loads += field(runner, "load")[k];
    CHECK_THAT(loads, WithinAbs(-50, 1e-9));
    runner.pull(std::nullopt);
    runner.step();
    CHECK(value(runner, "tip_y") == 0);
}

TEST_CASE("fem: what makes no body, and what no such body can be, is refused in words", "[fem]") {
    const auto refusal = [](Runner::Assignments given) -> std::string {
        try {
            Runner runner(find_lesson("mesh/fem"), std::move(given));
        } catch (const Refused& e) {
            return e.what();
        }
        return "";
    };
    CHECK_THAT(refusal({{"cells_x", "200"}, {"cells_y", "200"}, {"cells_z", "200"}}), ContainsSubstring("elements"));
    CHECK_THAT(refusal({{"length", "1e9"}, {"height", "1e-3"}}), ContainsSubstring("length"));
    CHECK_THAT(refusal({{"scene", "cook"}, {"model", "neo_hookean"}, {"plane", "stress"}}), ContainsSubstring("plane=strain"));
    CHECK_THAT(refusal({{"poisson_ratio", "0.5"}}), ContainsSubstring("poisson_ratio"));
    CHECK_THAT(refusal({{"youngs_modulus", "0"}}), ContainsSubstring("youngs_modulus"));
}
