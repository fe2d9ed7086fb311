// Runs to rest: every scene that has a steady state reaches it, every other is refused before it begins, in words.
#include <pliant/document/scene_file.h>
#include <pliant/run/runner.h>
#include <pliant/run/until.h>
#include <pliant/text/texts.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using Assignments = Runner::Assignments;

namespace {

void check_never_rests(std::string_view lesson, const Assignments& scene, const std::string& word) {
    Runner runner(find_lesson(lesson), scene);
    CAPTURE(lesson, word);
    CHECK_THROWS_AS(advance(runner, Until::at_rest()), Refused);
    CHECK_THROWS_WITH(advance(runner, Until::at_rest()), ContainsSubstring("never comes to rest") && ContainsSubstring(word) &&
                                                             ContainsSubstring("--steps or --time"));
    CHECK(runner.place() == Place{});
}

Runner rested(std::string_view lesson, const Assignments& scene) {
    Runner runner(find_lesson(lesson), scene);
    INFO(lesson);
    CHECK(runner.lesson().unrest() == "");
    advance(runner, Until::at_rest());
    CHECK(runner.lesson().at_rest());
    return runner;
}

Real reading(const Runner& runner, std::string_view probe) { return runner.value(runner.lesson().probe(probe)).value(); }

}  // namespace

TEST_CASE("rest: scenes without a steady state are refused before the first step") {
    check_never_rests("fluids/navier_stokes", {{"scene", "box"}}, "stirring");
    check_never_rests("fluids/navier_stokes", {{"scene", "smoke"}}, "smoke");
    check_never_rests("fluids/navier_stokes", {{"scene", "karman"}}, "vortices");
    check_never_rests("fluids/navier_stokes", {{"scene", "poiseuille"}, {"viscosity", "0"}}, "viscosity");
    check_never_rests("fluids/advection", {}, "flow carries");
    check_never_rests("fluids/free_surface", {}, "viscosity");
    check_never_rests("fluids/free_surface", {{"scene", "paddle"}}, "paddle");
    check_never_rests("time/integration", {}, "damping_ratio");
    check_never_rests("time/integration", {{"scheme", "explicit_euler"}}, "larger in every step");
    check_never_rests("time/integration", {{"omega", "0"}, {"v0", "1"}}, "omega");
    check_never_rests("time/integration", {{"damping_ratio", "1e-9"}, {"scheme", "velocity_verlet"}}, "steps");
    check_never_rests("mesh/rod", {{"scene", "wave"}}, "damping");
    check_never_rests("mesh/mass_spring", {{"scene", "spin"}, {"damping_mode", "projected"}}, "rotation");
    check_never_rests("mesh/mass_spring", {{"scene", "hang"}, {"damping_mode", "none"}}, "damping");
    check_never_rests("mesh/mass_spring", {{"ground", "off"}}, "ground");
    check_never_rests("mesh/cloth", {{"scene", "flag"}, {"wind", "5"}}, "wind");
    check_never_rests("mesh/cloth", {{"scene", "drape"}, {"sphere_radius", "0"}}, "sphere");
    check_never_rests("time/bead_chain", {}, "nothing is known");
}

TEST_CASE("rest: flows become steady") {
    const Runner channel = rested("fluids/navier_stokes", {{"scene", "poiseuille"}, {"resolution", "16"}, {"viscosity", "0.2"}});
    CHECK(reading(channel, "profile_difference") < 1e-2 * reading(channel, "max_speed"));
    rested("fluids/navier_stokes", {{"scene", "couette"}, {"resolution", "16"}});
    const Runner vortices =
        rested("fluids/navier_stokes", {{"scene", "taylor_green"}, {"resolution", "16"}, {"viscosity", "0.02"}});
    CHECK(reading(vortices, "max_speed") < 1e-3);
    const Runner still = rested("fluids/navier_stokes", {{"scene", "box"}, {"stirring", "0"}, {"resolution", "8"}});
    CHECK(reading(still, "max_speed") == 0);
    rested("fluids/diffusion", {});
    rested("fluids/free_surface", {{"column_width", "1"}, {"column_height", "0.3"}, {"resolution", "16"}});
}

TEST_CASE("rest: another unit of length makes the same flow steady in as many steps") {
    const auto steps = [](const char* size, const char* lid, const char* dt) {
        return rested("fluids/navier_stokes",
                      {{"scene", "cavity"}, {"resolution", "12"}, {"size", size}, {"lid_speed", lid}, {"time_step", dt}})
            .place()
            .step;
    };
    const Index metres = steps("1", "1", "0.05");
    CHECK(steps("1e-3", "1", "5e-5") == metres);
    CHECK(steps("1", "1e-2", "5") == metres);
}

TEST_CASE("rest: what swings is brought to rest by its damping") {
    const Runner spring = rested("time/integration", {{"damping_ratio", "0.1"}});
    CHECK_THAT(reading(spring, "x"), WithinAbs(0, 1e-4));
    rested("time/integration", {{"scheme", "implicit_euler"}, {"time_step", "0.1"}});
    rested("time/integration", {{"x0", "0"}, {"v0", "0"}});
    const Runner rod = rested("mesh/rod", {{"scene", "released"}, {"damping", "0.05"}});
    CHECK_THAT(reading(rod, "tip_displacement"), WithinRel(reading(rod, "tip_of_chain"), 1e-3));
    rested("mesh/rod", {{"scene", "wave"}, {"amplitude", "0"}});
}

TEST_CASE("rest: nets of springs and sheets come to lie still, in weight or without") {
    const Assignments small{{"cells_x", "2"}, {"cells_y", "2"}, {"cells_z", "2"}, {"damping", "0.2"}};
    const auto with = [&](Assignments more) {
        more.insert(more.begin(), small.begin(), small.end());
        return more;
    };
    rested("mesh/mass_spring", with({}));
    rested("mesh/mass_spring", with({{"scene", "hang"}}));
    rested("mesh/mass_spring", with({{"scene", "spin"}, {"damping_mode", "naive"}}));
    rested("mesh/mass_spring", with({{"gravity", "0"}}));
    rested("mesh/mass_spring", with({{"gravity", "0"}, {"rest_length_scale", "0.9"}}));
    rested("mesh/mass_spring", with({{"integrator", "implicit_euler"}, {"damping_mode", "none"}, {"time_step", "0.01"}}));
    rested("mesh/mass_spring",
           with({{"k_structural", "0"}, {"k_shear", "0"}, {"k_bending", "0"}, {"restitution", "0.5"}, {"drop_height", "0.2"}}));
    for (const char* scene : {"hanging_corners", "hanging_edge", "drape", "pedestal"})
        rested("mesh/cloth", {{"scene", scene}, {"nodes", "9"}});
    rested("mesh/cloth", {{"nodes", "5"}, {"gravity", "0"}});
}

TEST_CASE("rest: every preset and every scene says whether it comes to rest") {
    for (const LessonEntry& entry : lessons()) {
        std::vector<Assignments> scenes{{}};
        for (const std::string& name : preset_names(entry.info.id)) scenes.push_back(preset(entry, name).parameters);
        for (const Assignments& scene : scenes) {
            Runner runner(entry, scene);
            const std::string why = runner.lesson().unrest();
            INFO(entry.info.id << ": " << why);
            // A clause that follows a colon: no capital, no full stop.
            CHECK((why.empty() || (!why.ends_with('.') && why.size() > 20)));
            if (runner.is_static()) CHECK(why.empty());
        }
    }
}
