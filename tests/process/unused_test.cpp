// A parameter that is set and not used by the scene is said: on standard error, once a key and with what it needs; in the JSON;
// and --strict refuses it.
#include "pliant.h"

using namespace pliant::test;

namespace {

struct Idle {
    Arguments scene;  // lesson and settings
    std::string key, needs;
};
std::vector<Idle> idle_settings() {
    return {{{"fluids/diffusion", "--set", "dimension=2", "--set", "boundary=fixed", "--set", "wall_low=-3"},
             "wall_low",
             "dimension=1"},
            {{"elasticity/energy_density", "--set", "F11=1.2"}, "F11", "path=free"},
            {{"fluids/navier_stokes", "--set", "scene=cavity", "--set", "resolution=16", "--set", "viscosity=0.5"},
             "viscosity",
             "scene="}};
}

Arguments whole_command(const Arguments& first, const Arguments& scene, const Arguments& more = {}) {
    Arguments all = first;
    all.insert(all.end(), scene.begin(), scene.end());
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
    return n;
}

// Said once, and nothing else; with --strict refused, naming the same.
void check_said(const Arguments& arguments, const std::string& key, const std::string& needs) {
    const std::string said = key + " is used with " + needs;
    const Outcome outcome = call(arguments);
    INFO(sentence(arguments) << "\n" << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(count_of(outcome.err, said) == 1);
    CHECK(count_of(outcome.err, key + " is used") == 1);
    refusal(whole_command(arguments, {"--strict"}), {said, "--strict"});
}

}  // namespace

TEST_CASE("a parameter that the scene does not use is said in every command that takes parameters", "[process]") {
    const Scratch scratch;
    for (const Idle& idle : idle_settings()) {
        check_said(whole_command({"run"}, idle.scene, {"--steps", "1"}), idle.key, idle.needs);
        check_said(whole_command({"share"}, idle.scene), idle.key, idle.needs);
        check_said(whole_command({"shot"}, idle.scene, {"--steps", "0", "--size", "320x200", "--out", scratch.path("x.png")}),
                   idle.key, idle.needs);
    }
    const Arguments diffusion = idle_settings()[0].scene;
    check_said(whole_command({"why"}, diffusion, {"--steps", "1", "--field", "u"}), "wall_low", "dimension=1");
    check_said({"study", "time/integration", "--set", "stiffness_ratio=5", "--map", "time_step=0.1,0.2", "omega=1,2", "--steps",
                "20", "--out", scratch.path("maps")},
               "stiffness_ratio", "system=stiff_pair");
    // A knob that no cell uses.
    check_said({"study", "time/integration", "--map", "time_step=0.1,0.2", "stiffness_ratio=5,6", "--steps", "20", "--out",
                scratch.path("knobs")},
               "stiffness_ratio", "system=stiff_pair");
    CHECK(Json::parse(contents_of(scratch.path("knobs/map.json")))["unused"] == Json{{"stiffness_ratio", "system=stiff_pair"}});
    // The second run of a picture.
    check_said({"shot", "elasticity/energy_density", "--steps", "0", "--size", "640x360", "--beside", "F11=1.1", "--out",
                scratch.path("x.png")},
               "F11", "path=free");
}

TEST_CASE("a refusal by --strict comes before anything is written", "[process]") {
    const Scratch scratch;
    refusal({"run", "energy_density", "--set", "F11=1.1", "--strict", "--csv", scratch.path("x.csv")});
    refusal({"shot", "energy_density", "--set", "F11=1.1", "--strict", "--out", scratch.path("x.png")});
    refusal({"study", "integration", "--set", "stiffness_ratio=5", "--map", "time_step=0.1,0.2", "omega=1,2", "--strict", "--out",
             scratch.path("maps")});
    CHECK(scratch.names().empty());
}

TEST_CASE("the JSON of a run names what is not used and what it needs", "[process]") {
    CHECK(json_of({"run", "energy_density", "--steps", "0", "--set", "F11=1.1", "--set", "F22=1", "--set",
                   "F11=1.3"})["unused"] == Json{{"F11", "path=free"}, {"F22", "path=free"}});
    CHECK(json_of({"run", "energy_density", "--steps", "0", "--set", "F11=1.1", "--set", "path=free"})["unused"] ==
          Json::object());
    for (const std::string& lesson : lesson_names()) {
        const Json run = json_of({"run", lesson, "--steps", "0", "--strict"});
        CHECK(run["unused"] == Json::object());
    }
}

TEST_CASE("scene files, their events, presets and share strings are looked through", "[process]") {
    const Scratch scratch;
    const auto scene = [&](const std::string& rest) {
        return scratch.file("scene.json", R"({"pliant": 1, "lesson": "time/integration", )" + rest + "}");
    };
    const std::string idle = R"("parameters": {"stiffness_ratio": 5, "omega": 1})";
    check_said({"run", "--scene", scene(idle), "--steps", "1"}, "stiffness_ratio", "system=stiff_pair");
    const std::string shared = call({"share", "--scene", scene(idle)}).out;
    check_said({"run", "--scene", shared.substr(0, shared.size() - 1), "--steps", "1"}, "stiffness_ratio", "system=stiff_pair");
    // An option on the command line makes it used, or no longer so.
    CHECK(call({"run", "--scene", scene(idle), "--steps", "1", "--set", "system=stiff_pair", "--strict"}).exit_code == 0);
    check_said({"run", "mesh/mass_spring", "--preset", "chain_third_mode_verlet", "--steps", "1", "--set", "scene=drop"}, "mode",
               "scene=swing");
    // What an event sets later counts from then on.
    const auto falling = [&](const std::string& events) {
        return scratch.file("falling.json",
                            R"({"pliant": 1, "lesson": "mesh/cloth", "parameters": {"nodes": 5}, "events": [)" + events + "]}");
    };
    check_said({"run", "--scene", falling(R"({"step": 2, "set": {"strain_limit": 0.1}})"), "--steps", "3"}, "strain_limit",
               "strain_limiting=true");
    CHECK(call({"run", "--scene",
                falling(R"({"step": 1, "set": {"strain_limit": 0.1}}, {"step": 2, "set": {"strain_limiting": true}})"), "--steps",
                "3", "--strict"})
              .exit_code == 0);
}

TEST_CASE("walkthroughs and tours set nothing that is not used", "[process][slow]") {
    for (const std::string& lesson : lesson_names()) {
        const Outcome outcome = call({"walkthrough", lesson, "--strict"});
        INFO(lesson << "\n" << outcome.err);
        CHECK(outcome.exit_code == 0);
        CHECK(outcome.err.empty());
    }
    for (const Json& entry : json_of({"list"}))
        for (const std::string preset : entry["presets"])
            CHECK(call({"run", entry["lesson"], "--preset", preset, "--steps", "0", "--strict"}).exit_code == 0);
}
