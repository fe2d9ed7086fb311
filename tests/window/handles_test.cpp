// What stands for a parameter in the picture is dragged with the mouse.
#include "desk.h"

#include <cmath>

using namespace pliant::test;

TEST_CASE("a material point is dragged, the lesson answers while the hand moves, and one undo takes it back", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "elasticity/deformation_gradient"});
    // A static lesson runs as it opens, and then rests.
    REQUIRE(desk.becomes("playing", false));
    REQUIRE(desk.becomes("step", 1));

    // Q is 1.
    const Spot grip = desk.on("handle 1");
    desk.move(grip);
    REQUIRE(desk.becomes("hovered", 1));
    desk.press();
    REQUIRE(desk.becomes("pulling", 1));
    const std::string key = "Q_x";
    const double before = desk.parameter(key);
    const Json probes = desk.state()["probes"];
    desk.move({grip.x + 10, grip.y + 10});
    desk.move({grip.x + 30, grip.y + 20});
    CHECK(desk.becomes([&](const Json&) { return std::abs(desk.parameter(key) - before) > 0.01; }));
    CHECK(desk.state()["step"] == 1);
    CHECK(desk.becomes([&](const Json& s) { return s["probes"] != probes; }));
    desk.release();
    CHECK(desk.becomes("pulling", -1));
    desk.key("ctrl+z");
    CHECK(desk.becomes([&](const Json&) { return desk.parameter(key) == before; }));
}

TEST_CASE("the end of a rod is dragged through its rest: force and strain change their sign", "[window]") {
    need_screen_and_mouse();
    const Scratch scratch;
    Desk desk({"--scene", scratch.file("rod.json", R"({"pliant": 1, "lesson": "elasticity/stress_strain",
                                                      "parameters": {"scene": "rod", "force": 300}})")});
    REQUIRE(desk.becomes("playing", false));
    REQUIRE(desk.becomes("step", 1));
    const Spot grip = desk.on("handle 0");
    desk.move(grip);
    REQUIRE(desk.becomes("hovered", 0));
    desk.press();
    REQUIRE(desk.becomes("pulling", 0));
    desk.move({grip.x - 30, grip.y - 8});
    desk.move({grip.x - 160, grip.y - 40});
    CHECK(desk.becomes([&](const Json&) { return desk.parameter("force") < 0; }));
    desk.release();
    CHECK(desk.becomes([&](const Json& s) { return s["probes"]["strain"] < 0; }));
    desk.key("ctrl+z");
    CHECK(desk.becomes([&](const Json&) { return desk.parameter("force") == 300; }));
}

TEST_CASE("the corner of a column of water is dragged, and the water falls from its new shape", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "fluids/free_surface"});
    const Spot grip = desk.on("handle 0");
    desk.drag(grip, {grip.x + 60, grip.y + 30});
    CHECK(desk.becomes(
        [&](const Json&) { return desk.parameter("column_width") > 0.3 && desk.parameter("column_height") < 0.48; }));
    desk.key("ctrl+z");
    CHECK(desk.becomes([&](const Json&) { return desk.parameter("column_width") == 0.25; }));
}

TEST_CASE("a click on a cell shows the path that leads there", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "fluids/advection"});
    const double before = desk.parameter("cell_x");
    // Some cells to the right of the handle, and above.
    const Spot handle = desk.on("handle 0");
    const Spot there{handle.x + 40, handle.y - 25};
    desk.click(there);
    CHECK(desk.becomes([&](const Json&) { return desk.parameter("cell_x") > before + 1; }));
    const Spot now = desk.on("handle 0");
    CHECK(std::abs(now.x - there.x) < 8);
    CHECK(std::abs(now.y - there.y) < 8);
}
