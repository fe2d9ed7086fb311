// A fluid on a grid at the ends of what may be asked for: forces, viscosities, long steps, few iterations, other units.
#include "pliant.h"

#include <cmath>

using namespace pliant::test;

namespace {

Arguments flow(const std::vector<std::string>& settings, const char* steps = "10") {
    return with({"run", "fluids/navier_stokes", "--steps", steps, "--json"}, settings);
}

Json finite_run(const std::vector<std::string>& settings, const char* steps = "10") {
    const Outcome outcome = call(flow(settings, steps));
    INFO(sentence(flow(settings, steps)) << "\n" << outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const Json run = Json::parse(outcome.out);
    check_finite(run);
    return run;
}

}  // namespace

TEST_CASE("a fluid without force stays at rest, and one under a vast force is finite or tells its limit", "[process]") {
    const std::vector<std::vector<std::string>> still{
        {"stirring=0"}, {"scene=poiseuille", "body_force=0"}, {"scene=smoke", "buoyancy=0"}};
    for (std::vector<std::string> settings : still) {
        settings.push_back("resolution=16");
        const Json run = finite_run(settings);
        CHECK(value(run, "kinetic_energy") == 0);
        CHECK(value(run, "max_divergence") == 0);
    }
    for (const char* force : {"stirring=1e6", "stirring=-1e6", "scene=poiseuille body_force=1e6", "scene=smoke buoyancy=1e6"}) {
        std::vector<std::string> settings{"resolution=16"};
        const std::string words = force;
        const auto gap = words.find(' ');
        settings.push_back(words.substr(0, gap));
        if (gap != std::string::npos) settings.push_back(words.substr(gap + 1));
        const Outcome outcome = call(flow(settings));
        INFO(force << "\n" << outcome.err);
        if (outcome.exit_code == 0) {
            const Json run = Json::parse(outcome.out);
            check_finite(run);
            CHECK_FALSE(run["assumptions"]["courant number"]["holds"].get<bool>());
        } else {
            REQUIRE(outcome.exit_code == diverged);
            CHECK(contains(Json::parse(outcome.out)["failure"]["limit"], "time_step"));
        }
    }
}

TEST_CASE("a pressure solver that may make one pass only says what it has left", "[process]") {
    const Outcome outcome = call(flow({"resolution=32", "max_iterations=1", "tolerance=1e-10"}));
    REQUIRE(outcome.exit_code == diverged);
    const Json failure = Json::parse(outcome.out)["failure"];
    CHECK(failure["stage"] == "projection");
    for (const char* words : {"after 1 iterations", "the residual is", "the largest divergence left is"})
        CHECK(contains(failure["what"], words));
    CHECK(contains(failure["limit"], "1/s was asked for, within 1 iterations"));
    // One is enough where that much is not asked for.
    CHECK(value(finite_run({"resolution=32", "max_iterations=1", "tolerance=0.9"}), "solver_iterations") <= 1);
}

TEST_CASE("a fluid may have no viscosity or a vast one, but not less than none", "[process]") {
    const Json none = finite_run({"viscosity=0", "resolution=16"});
    CHECK_FALSE(none["cost"].contains("viscosity"));
    // So thick a fluid is at rest but for what the last step pushed.
    CHECK(value(finite_run({"viscosity=1e6", "resolution=16", "scene=poiseuille", "body_force=1"}), "max_speed") < 1e-5);
    const Json dragged = finite_run({"viscosity=1e6", "resolution=16", "scene=couette"});
    CHECK(value(dragged, "profile_difference") < 1e-5);
    const Outcome negative = call(flow({"viscosity=-1e-9"}));
    CHECK(negative.exit_code == refused);
    CHECK(contains(negative.err, "viscosity = "));
    const Outcome thick = call(flow({"viscosity=1e6", "viscosity_scheme=explicit"}));
    CHECK(thick.exit_code == refused);
    CHECK(contains(thick.err, "Δx²/(4ν)"));
}

TEST_CASE("advection from a tenth of a cell per step to a hundred makes no speed larger", "[process]") {
    for (const double cells : {0.1, 1.0, 5.0, 20.0, 100.0}) {
        const std::string step = "time_step=" + exactly(cells / 32);
        const Json run =
            finite_run({"scene=taylor_green", "resolution=32", "with_projection=false", "with_viscosity=false", step}, "20");
        INFO(cells);
        CHECK(value(run, "max_speed") <= 1);
        const Json whole = finite_run({"scene=taylor_green", "resolution=32", step}, "20");
        CHECK(whole["conserved"]["max_divergence"]["status"] == "holds");
        CHECK(value(whole, "kinetic_energy") <= 0.25);
    }
}

TEST_CASE("one cell, or one row of cells, is enough for every scene of a fluid", "[process]") {
    const Json parameters = parameters_of("fluids/navier_stokes");
    const Json& scenes = parameters[0]["options"];
    REQUIRE(scenes.size() >= 7);
    for (const Json& scene : scenes)
        for (const char* cells : {"1", "2", "7"})
            finite_run({"scene=" + (scene.is_string() ? scene : scene["key"]).get<std::string>(),
                        std::string("resolution=") + cells, "time_step=0.01"},
                       "3");
}

TEST_CASE("a cavity told in micrometres is the same cavity", "[process]") {
    const Json here = finite_run({"scene=cavity", "resolution=24"}, "8");
    for (const double scale : {1e6, 1e-6}) {
        const Json there =
            finite_run({"scene=cavity", "resolution=24", "size=" + exactly(scale), "lid_speed=" + exactly(scale)}, "8");
        const auto same = [&](const char* probe, double unit) {
            INFO(probe << " × " << scale);
            CHECK(std::abs(value(there, probe) / unit - value(here, probe)) <= 1e-6 * value(here, probe));
        };
        same("kinetic_energy", scale * scale);
        same("max_speed", scale);
        same("cfl", 1);
        same("table_difference", scale);
    }
}

TEST_CASE("the profiles of a run come with their places", "[process]") {
    const Json lines = finite_run({"scene=cavity", "resolution=16", "aspect=2"}, "5")["lines"];
    for (const char* name : {"u_center", "v_center"}) {
        const Json& line = lines[name];
        REQUIRE(line["position"].size() == line["value"].size());
        CHECK(line["position"].size() == (name[0] == 'u' ? 34 : 18));
        CHECK(line["position_unit"] == "m");
    }
    CHECK(lines["u_center"]["position"].back() == 2);
    CHECK(finite_run({"scene=couette", "resolution=16"}, "5")["lines"]["profile"]["reference"]["value"].size() == 18);
}
