// Two runs at once, by hand.
#include "desk.h"

#include <cmath>

using namespace pliant::test;

TEST_CASE("two runs side by side have sliders of their own", "[window]") {
    need_screen_and_mouse();
    const Scratch scratch;
    Desk desk(
        {"--scene", scratch.file("small.json",
                                 R"({"pliant": 1, "lesson": "mesh/mass_spring", "parameters": {"cells_x": 2, "cells_y": 2}})")});
    desk.key("space");
    REQUIRE(desk.becomes("playing", false));
    CHECK(desk.state()["companion"].is_null());
    desk.key("2");
    REQUIRE(desk.becomes([](const Json& s) { return s["companion"].is_object(); }));
    const std::string size = desk.state()["parameters"]["mass"];
    CHECK(desk.state()["companion"]["parameters"]["mass"] == size);

    desk.click("run B");
    REQUIRE(desk.becomes([](const Json& s) { return s["companion"]["addressed"] == true; }));
    desk.drag(desk.on("mass"), desk.on("mass", 0.8));
    CHECK(desk.becomes([&](const Json& s) { return s["companion"]["parameters"]["mass"] != size; }));
    CHECK(desk.state()["parameters"]["mass"] == size);
    // Ctrl 1 gives the sliders back to A.
    desk.key("ctrl+1");
    REQUIRE(desk.becomes([](const Json& s) { return s["companion"]["addressed"] == false; }));
    const std::string of_b = desk.state()["companion"]["parameters"]["mass"];
    desk.drag(desk.on("mass"), desk.on("mass", 0.2));
    CHECK(desk.becomes([&](const Json& s) { return s["parameters"]["mass"] != size; }));
    CHECK(desk.state()["companion"]["parameters"]["mass"] == of_b);

    // Both go on together.
    const long step = desk.state()["step"];
    const auto both_at = [&](long at) {
        return desk.becomes([&](const Json& s) { return s["step"] == at && s["companion"]["step"] == at; });
    };
    desk.key("period");
    desk.key("period");
    CHECK(both_at(step + 2));
    desk.key("less");
    CHECK(both_at(step + 1));

    desk.key("3");
    CHECK(desk.becomes([](const Json& s) { return s["companion"]["difference"] == true; }));
    desk.key("3");
    CHECK(desk.becomes([](const Json& s) { return s["companion"]["difference"] == false; }));
    desk.click("beside");
    CHECK(desk.becomes([](const Json& s) { return s["companion"].is_null(); }));
}

TEST_CASE("a run is pinned, and its cost and error shown, by key and by button", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "elasticity/moduli"});
    desk.key("g");
    CHECK(desk.becomes("pinned", true));
    desk.click("pin");
    CHECK(desk.becomes("pinned", false));
    desk.key("c");
    CHECK(desk.becomes("cost_shown", true));
    CHECK(desk.becomes([](const Json& s) { return s["controls"].contains("cost and error"); }));
    desk.key("c");
    CHECK(desk.becomes("cost_shown", false));
}
