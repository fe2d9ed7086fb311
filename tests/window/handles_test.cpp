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

    // P is 0 and Q is 1, on the front of the outline to the left.
    Spot grip{};
    const auto holds_point = [&] {
        for (double down = 0.34; down < 0.56; down += 0.02)
            for (double across = 0.1; across < 0.34; across += 0.015) {
                grip = desk.on("scene", across, down);
                desk.move(grip);
                const Json hovered = desk.state()["hovered"];
                if (hovered != 0 && hovered != 1) continue;
                desk.press();
                if (desk.state()["pulling"] >= 0) return true;
                desk.release();
            }
        return false;
    };
    REQUIRE(holds_point());
    const std::string key = desk.state()["pulling"] == 0 ? "P_x" : "Q_x";
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
    Spot grip{};
    const auto holds_end = [&] {
        for (double down = 0.3; down < 0.7; down += 0.02)
            for (double across = 0.35; across < 0.8; across += 0.012) {
                grip = desk.on("scene", across, down);
                desk.move(grip);
                if (desk.state()["hovered"] != 0) continue;
                desk.press();
                if (desk.state()["pulling"] == 0) return true;
                desk.release();
            }
        return false;
    };
    REQUIRE(holds_end());
    desk.move({grip.x - 30, grip.y - 8});
    desk.move({grip.x - 160, grip.y - 40});
    CHECK(desk.becomes([&](const Json&) { return desk.parameter("force") < 0; }));
    desk.release();
    CHECK(desk.becomes([&](const Json& s) { return s["probes"]["strain"] < 0; }));
    desk.key("ctrl+z");
    CHECK(desk.becomes([&](const Json&) { return desk.parameter("force") == 300; }));
}
