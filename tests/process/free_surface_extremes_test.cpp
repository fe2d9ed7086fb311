// A liquid at the ends of what may be asked for: no gravity and far too much, nothing to pour, a tank full to the lid, long
// steps, a solver that may hardly try, what contradicts itself.
#include "pliant.h"

#include <cmath>

using namespace pliant::test;

namespace {

Outcome pour(const std::vector<std::string>& settings, const char* steps = "6") {
    return call(with({"run", "fluids/free_surface", "--steps", steps, "--json", "--set", "resolution=24"}, settings));
}

Json poured(const std::vector<std::string>& settings, const char* steps = "6") {
    const Outcome outcome = pour(settings, steps);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const Json run = Json::parse(outcome.out);
    check_finite(run);
    return run;
}

}  // namespace

TEST_CASE("a liquid without gravity stays where it is, and one under a vast gravity is finite or tells its limit", "[process]") {
    for (const char* scene : {"scene=column", "scene=wave", "scene=drop"}) {
        const Json run = poured({scene, "gravity=0"});
        CHECK(value(run, "kinetic_energy") < 1e-20);
    }
    const Outcome outcome = pour({"gravity=1e6"});
    INFO(outcome.err);
    if (outcome.exit_code == 0)
        CHECK_FALSE(Json::parse(outcome.out)["assumptions"]["courant number"]["holds"].get<bool>());
    else
        REQUIRE(outcome.exit_code == diverged);
}

TEST_CASE("an empty tank, a full one and one of a single cell do nothing", "[process]") {
    const Json empty = poured({"column_width=0"});
    CHECK(value(empty, "volume") < 1e-12);
    CHECK(value(empty, "kinetic_energy") == 0);
    const Json full = poured({"column_width=1", "column_height=0.625", "tank_height=0.625"});
    CHECK(value(full, "kinetic_energy") < 1e-12);
    CHECK(std::abs(value(full, "volume") - 0.625) < 1e-9);
    const Json cell = poured({"resolution=1"});
    CHECK(value(cell, "kinetic_energy") < 1e-20);
}

TEST_CASE("a liquid takes any time step, from a tenth of a cell to a hundred", "[process]") {
    for (const char* dt : {"time_step=4e-4", "time_step=4e-3", "time_step=0.02", "time_step=0.08", "time_step=0.4"}) {
        INFO(dt);
        const Json run = poured({"scene=drop", dt}, "12");
        CHECK(std::abs(value(run, "volume") / value(poured({"scene=drop"}, "0"), "volume") - 1) < 0.35);
    }
}

TEST_CASE("a liquid's condition at the surface: every one runs, and the wrong ones are told", "[process]") {
    for (const char* condition : {"at_surface", "at_cell_centre", "closed"}) {
        const Json run = poured({std::string("surface_condition=") + condition});
        CHECK(run["assumptions"]["p = 0 at the surface"]["holds"].get<bool>() == (std::string(condition) == "at_surface"));
    }
}

TEST_CASE("a tank that contradicts itself is refused before the first step", "[process]") {
    const std::vector<std::pair<std::vector<std::string>, std::string>> bad{
        {{"column_width=2"}, "column_width"},
        {{"column_height=0.7"}, "column_height"},
        {{"scene=wave", "depth=0.9"}, "depth"},
        {{"scene=wave", "wave_height=0.5"}, "wave_height"},
        {{"scene=paddle", "paddle_stroke=0.9"}, "paddle_stroke"},
        {{"scene=paddle", "surface_condition=closed"}, "surface_condition"},
        {{"tank_height=1e6"}, "tank_height"},
        {{"gravity=-1"}, "gravity"},
        {{"gravity=nan"}, "gravity"},
        {{"drop_radius=-0.1"}, "drop_radius"}};
    for (const auto& [settings, named] : bad) {
        const Outcome outcome = pour(settings);
        INFO(settings.back() << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
        CHECK(contains(outcome.err, named));
    }
}

TEST_CASE("the same pour twice gives the same numbers to the last digit", "[process]") {
    for (const char* scene : {"scene=column", "scene=wave", "scene=drop", "scene=paddle"}) {
        Json one = poured({scene}, "15"), other = poured({scene}, "15");
        CHECK(one["probes"] == other["probes"]);
    }
}
