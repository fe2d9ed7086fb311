// The rod's extremes on the command line.
#include "pliant.h"

#include <cmath>

using namespace pliant::test;

namespace {

const Arguments rod_run{"run", "mesh/rod", "--steps", "20"};

}  // namespace

TEST_CASE("rod: numbers that make no rod are refused by name", "[process]") {
    for (const char* setting : {"segments=1e9", "segments=0", "segments=-1", "segments=2.5", "mass=0", "mass=-1",
                                "axial_stiffness=0", "axial_stiffness=-1", "axial_stiffness=nan", "gravity=-1", "gravity=1e7",
                                "time_step=0", "time_step=-1", "picked_stiffness=0", "length=0", "spring_rule=none"}) {
        const Outcome outcome = call(with(rod_run, {setting}));
        INFO(setting << "\n" << outcome.err);
        CHECK(outcome.exit_code == refused);
        CHECK(contains(outcome.err, std::string(setting).substr(0, std::string(setting).find('='))));
    }
}

TEST_CASE("rod: a rod that hangs is right at every extreme", "[process]") {
    const auto tip = [](double mass, double g, double stiffness, int n) { return mass * g * (n + 1) / (2 * stiffness * n); };
    const double first = value(json_of(with(rod_run, {})), "tip_displacement");
    CHECK(std::abs(first / tip(1, 9.81, 20, 10) - 1) < 1e-12);
    const double one = value(json_of(with(rod_run, {"segments=1"})), "tip_displacement");
    CHECK(std::abs(one / tip(1, 9.81, 20, 1) - 1) < 1e-12);
    const double weightless = value(json_of(with(rod_run, {"gravity=0"})), "tip_displacement");
    CHECK(std::abs(weightless) < 1e-15);
    const double heavy = value(json_of(with(rod_run, {"gravity=1e6"})), "tip_displacement");
    CHECK(std::abs(heavy / tip(1, 1e6, 20, 10) - 1) < 1e-10);
    // 5 pm: what positions of 1 m can still tell.
    const double stiff = value(json_of(with(rod_run, {"axial_stiffness=1e12"})), "tip_displacement");
    CHECK(std::abs(stiff - tip(1, 9.81, 1e12, 10)) < 1e-15);
    const double many = value(json_of(with(rod_run, {"segments=200", "spring_rule=constant"})), "tip_displacement");
    CHECK(std::abs(many / (9.81 * 201 / (2 * 200.0)) - 1) < 1e-10);
}

TEST_CASE("rod: above its limit of stability a run is stopped with the limit by name, and implicit schemes are not",
          "[process]") {
    for (const char* scene : {"scene=wave", "scene=free_end", "scene=fixed_end", "scene=released"}) {
        Arguments asked = with({"run", "mesh/rod", "--steps", "3000"}, {scene, "time_step=0.025"});
        asked.push_back("--json");
        const Outcome outcome = call(asked);
        INFO(sentence(asked) << "\n" << outcome.err);
        REQUIRE(outcome.exit_code == diverged);
        CHECK(contains(Json::parse(outcome.out)["failure"]["limit"], "stability limit of 22.6"));
        for (const char* scheme : {"scheme=implicit_euler", "scheme=implicit_midpoint", "scheme=newmark", "scheme=bdf2"}) {
            const Json result = json_of(with(rod_run, {scene, scheme, "time_step=10"}));
            CHECK(std::isfinite(value(result, "tip_displacement")));
            CHECK(std::abs(value(result, "tip_displacement")) < 2);
        }
    }
    // One mass between two supports, and one at a single spring.
    for (const char* scene : {"scene=wave", "scene=released", "scene=free_end", "scene=fixed_end"})
        CHECK(std::isfinite(value(json_of(with(rod_run, {scene, "segments=1"})), "energy")));
    CHECK(std::isfinite(value(json_of(with(rod_run, {"scene=released", "gravity=1e6"})), "energy")));
    CHECK(call(with(rod_run, {"scene=wave", "axial_stiffness=1e12"})).exit_code == diverged);
    // Waves that pass the rod 10¹⁴⁰ times in a step.
    for (const char* scene : {"scene=wave", "scene=free_end"})
        CHECK(call(with(rod_run, {scene, "mass=1e-280", "scheme=implicit_euler"})).exit_code != refused);
}
