// The lab under the mouse.
#include "desk.h"

#include <cmath>

using namespace pliant::test;

namespace {
// Turns the wheel over the list of lessons until a name is in sight.
void scroll_to(Desk& desk, const std::string& name) {
    for (int notch = 0; notch < 40; ++notch) {
        const Json controls = desk.state()["controls"];
        const Json &list = controls["lessons"], &entry = controls[name];
        const double top = list[1], bottom = top + list[3].get<double>(), y = entry[1], end = y + entry[3].get<double>();
        if (y >= top && end <= bottom) return;
        desk.move(desk.on("lessons"));
        desk.wheel(end > bottom);
    }
}
}  // namespace

TEST_CASE("a click on its name opens a lesson", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    for (const std::string lesson : {"fluids/navier_stokes", "elasticity/moduli", "mesh/mass_spring"}) {
        scroll_to(desk, "lesson " + lesson);
        desk.click("lesson " + lesson);
        CHECK(desk.becomes("lesson", lesson));
    }
}

TEST_CASE("a slider is dragged, set back, typed into and undone", "[window]") {
    need_screen_and_mouse();
    // A small body, so that every change is quick.
    const Scratch scratch;
    Desk desk({"--scene",
               scratch.file("small.json", R"({"pliant": 1, "lesson": "elasticity/moduli", "parameters": {"resolution": 1}})")});
    pause(desk);
    const std::string key = "poisson_ratio";
    const double initial = desk.parameter(key);
    CHECK(initial == 0.3);
    const auto shows = [&](double value) {
        return desk.becomes([&](const Json& s) { return std::stod(s["parameters"][key].get<std::string>()) == value; });
    };

    // Linear from -0.5 to 0.49.
    desk.drag(desk.on(key), desk.on(key, 0.25));
    const double dragged = desk.parameter(key);
    CHECK(std::abs(dragged - (-0.5 + 0.25 * 0.99)) < 0.05);
    CHECK(desk.stays("parameters", desk.state()["parameters"]));

    // The whole drag is one step of undo.
    desk.key("ctrl+z");
    CHECK(shows(initial));
    desk.drag(desk.on(key), desk.on(key, 0.25));

    desk.double_click(desk.on(key, 0.75));
    CHECK(desk.becomes([&](const Json& s) { return s["parameters"][key] == "0.3"; }));
    CHECK(desk.stays("parameters", desk.state()["parameters"]));

    const auto type = [&](const std::string& number) {
        desk.hold("ctrl");
        desk.click(key);
        desk.let_go("ctrl");
        desk.key("ctrl+a");
        desk.type(number);
        desk.key("Return");
    };
    type("0.125");
    CHECK(shows(0.125));
    // Outside what the solver accepts: refused in words, and nothing changes.
    type("7");
    CHECK(desk.becomes([](const Json& state) {
        return state["message"].is_string() &&
               state["message"].get<std::string>().find("Poisson's ratio = 7") != std::string::npos;
    }));
    CHECK(desk.parameter(key) == 0.125);
    // Outside the useful range, which ends at 0.49, and with a decimal comma.
    type("0,495");
    CHECK(shows(0.495));

    desk.key("ctrl+z");
    CHECK(shows(0.125));
    desk.key("ctrl+z");
    CHECK(shows(initial));
}

TEST_CASE("a choice is made from its list", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "elasticity/moduli"});
    pause(desk);
    CHECK(desk.state()["parameters"]["test"] == "tension");
    const Spot box = desk.on("test");
    const double height = desk.state()["controls"]["test"][3];
    desk.click(box);
    desk.click(Spot{box.x, box.y + static_cast<int>(2.0 * height)});
    CHECK(desk.becomes([](const Json& s) { return s["parameters"]["test"] != "tension"; }));
    CHECK(desk.state()["lesson"] == "elasticity/moduli");
}

TEST_CASE("the buttons of time do what they say", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    desk.click("play");
    CHECK(desk.stays("playing", false));
    const long step = desk.state()["step"];
    desk.click("step");
    CHECK(desk.stays("step", step + 1));
    desk.click("back");
    CHECK(desk.stays("step", step));
    desk.click("stage");
    CHECK(desk.becomes([](const Json& s) { return s["passes"] > 0; }));
    desk.click("reset");
    CHECK(desk.stays("step", 0));
    // A key does one thing, whatever was clicked before.
    desk.key("space");
    CHECK(desk.stays("playing", true));
}

TEST_CASE("the body is pulled with the mouse", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    pause(desk);
    const Spot grip = grip_of(desk);
    const Json before = desk.state();
    desk.move({grip.x + 60, grip.y - 120});
    CHECK(desk.state()["pulling"] == before["pulling"]);
    CHECK(desk.state()["probes"] == before["probes"]);  // paused: nothing moves yet
    for (int i = 0; i < 5; ++i) desk.key("period");
    const Json pulled = desk.state();
    CHECK(pulled["step"] == before["step"].get<long>() + 5);
    CHECK(pulled["probes"] != before["probes"]);
    desk.release();
    CHECK(desk.becomes("pulling", -1));

    // Without the hand the same five steps end elsewhere.
    for (int i = 0; i < 5; ++i) desk.key("less");
    REQUIRE(desk.becomes("step", before["step"]));
    for (int i = 0; i < 5; ++i) desk.key("period");
    REQUIRE(desk.becomes("step", pulled["step"]));
    CHECK(desk.state()["probes"] != pulled["probes"]);
    CHECK(desk.complaints().empty());
}
