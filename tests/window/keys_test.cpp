// The lab under the keys of its help.
#include "desk.h"

#include <cmath>

using namespace pliant::test;

namespace {

long step_of(const Json& state) { return state["step"]; }

}  // namespace

TEST_CASE("the lab opens on a lesson that moves, and Space pauses it", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    CHECK(desk.state()["lesson"] == "mesh/mass_spring");
    CHECK(desk.state()["playing"] == true);
    const long first = step_of(desk.state());
    CHECK(desk.becomes([&](const Json& s) { return step_of(s) > first + 5; }));
    pause(desk);
    CHECK(desk.stays("step", desk.state()["step"]));
    const long there = step_of(desk.state());
    desk.key("space");
    CHECK(desk.becomes([&](const Json& s) { return step_of(s) > there && s["playing"] == true; }));
    CHECK(desk.complaints().empty());
}

TEST_CASE("keys go one step, one step back, one stage and back to the start", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    desk.becomes([](const Json& s) { return step_of(s) > 3; });
    pause(desk);
    const Json here = desk.state();
    const long step = step_of(here);

    desk.key("period");
    CHECK(desk.stays("step", step + 1));
    const Json next = desk.state();
    CHECK(next["time"] > here["time"]);
    CHECK(next["probes"] != here["probes"]);
    desk.key("less");
    CHECK(desk.stays("step", step));
    CHECK(desk.state()["probes"] == here["probes"]);
    desk.key("less");
    CHECK(desk.stays("step", step - 1));
    desk.key("period");
    desk.key("period");
    CHECK(desk.stays("step", step + 1));
    CHECK(desk.state()["probes"] == next["probes"]);

    CHECK(desk.state()["passes"] == 0);
    desk.key("slash");
    CHECK(desk.becomes([](const Json& s) { return s["passes"] > 0; }));
    const std::string first_stage = desk.state()["stage"];
    CHECK(desk.state()["step"] == step + 1);
    desk.key("slash");
    CHECK(desk.becomes([&](const Json& s) { return s["stage"] != first_stage; }));
    desk.key("m");
    CHECK(desk.stays("stage", first_stage));
    desk.key("period");
    CHECK(desk.becomes([&](const Json& s) { return s["step"] == step + 2 && s["passes"] == 0; }));

    desk.key("r");
    CHECK(desk.stays("step", 0));
    CHECK(desk.state()["time"] == 0.0);
}

TEST_CASE("brackets go through the lessons, round and round", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    const std::string first = desk.state()["lesson"];
    std::vector<std::string> seen{first};
    desk.key("bracketright");
    for (int i = 0; i < 30 && desk.state()["lesson"] != first; ++i) {
        seen.push_back(desk.state()["lesson"]);
        desk.key("bracketright");
    }
    CHECK(desk.state()["lesson"] == first);
    CHECK(seen.size() >= 3);
    desk.key("bracketleft");
    CHECK(desk.becomes("lesson", seen.back()));
    CHECK(desk.state()["step"] == 0);
}

TEST_CASE("F1 shows the keys, Tab hides the panels, T changes the theme", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    pause(desk);
    desk.key("F1");
    CHECK(desk.becomes("help", true));
    desk.key("F1");
    CHECK(desk.becomes("help", false));
    CHECK(desk.state()["layout"] == "lab");
    desk.key("Tab");
    CHECK(desk.stays("layout", "slide"));
    desk.key("Tab");
    CHECK(desk.stays("layout", "lab"));
    // Having passed over the controls, Space still does one thing only.
    desk.key("space");
    CHECK(desk.stays("playing", true));
    pause(desk);
    desk.key("ctrl+equal");
    CHECK(desk.becomes("scale", 1.25));
    desk.key("ctrl+minus");
    CHECK(desk.becomes("scale", 1.0));
}

TEST_CASE("F finds a lesson by a word of its name", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    desk.key("f");
    desk.type("moduli");
    CHECK(desk.state()["lesson"] == "mesh/mass_spring");
    desk.key("Return");
    CHECK(desk.becomes("lesson", "elasticity/moduli"));
    // The letters were typed, not taken for keys of the lab.
    CHECK(desk.state()["help"] == false);
    CHECK(desk.state()["layout"] == "lab");
}

TEST_CASE("Ctrl Q quits as closing the window does: what was set is there at the next start", "[window]") {
    need_screen_and_mouse();
    const Scratch scratch;
    const std::string config = scratch.path("config");
    {
        Desk desk({"--lesson", "elasticity/moduli"}, config);
        desk.key("ctrl+equal");
        REQUIRE(desk.becomes("scale", 1.25));
        CHECK(desk.end_by("ctrl+q") == 0);
        CHECK(desk.complaints().empty());
    }
    Desk desk({"--lesson", "elasticity/moduli"}, config);
    CHECK(desk.becomes("scale", 1.25));
}

TEST_CASE("a scene saved by Ctrl S is the same run on the command line", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "elasticity/moduli"});
    pause(desk);
    desk.drag(desk.on("poisson_ratio"), desk.on("poisson_ratio", 0.3));
    desk.key("ctrl+s");
    const auto saved = [&] {
        const auto names = desk.scratch().names();
        const auto found = std::ranges::find_if(names, [](const std::string& n) { return n.ends_with(".scene.json"); });
        return found == names.end() ? "" : desk.scratch().path(*found);
    };
    REQUIRE(desk.becomes([&](const Json&) { return !saved().empty(); }));
    const std::string scene = saved();
    const Outcome outcome = run_process(PLIANT_PROGRAM, {"run", "--scene", scene, "--steps", "0", "--json"});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const double value = Json::parse(outcome.out)["parameters"]["poisson_ratio"];
    CHECK(value == desk.parameter("poisson_ratio"));
    CHECK(value < 0.25);
}

TEST_CASE("closing the window ends the program well", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    CHECK(desk.close_window() == 0);
    CHECK(desk.complaints().empty());
}

TEST_CASE("a scene or a state file that cannot be used is refused", "[window]") {
    need_screen_and_mouse();
    const Scratch scratch;
    const Screen screen(scratch);
    const Environment here{
        {"DISPLAY", screen.display()}, {"WAYLAND_DISPLAY", std::nullopt}, {"XDG_CONFIG_HOME", scratch.path("config")}};
    const std::string scene = scratch.file("scene.json", R"({"pliant": 1, "lesson": "elasticity/moduli", "lense": 1})");
    for (const Arguments& arguments :
         {Arguments{"--scene", scene}, Arguments{"--frames", "3", "--state", scratch.path("missing/state.json")}}) {
        const Outcome outcome = run_process(PLIANT_PROGRAM, arguments, here);
        INFO(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.err.find(arguments.back()) != std::string::npos);
    }
    CHECK(run_process(PLIANT_PROGRAM, {"--frames", "3"}, here).exit_code == 0);
}
