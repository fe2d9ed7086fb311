// A student's way into a step, with a real mouse and real keys.
#include "desk.h"

using namespace pliant::test;

namespace {

const Json& inspector(const Json& state) { return state["inspector"]; }

}  // namespace

TEST_CASE("a student breaks on the projection, asks why a pressure is what it is, goes back and changes the step", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "navier_stokes"});
    REQUIRE(desk.becomes([](const Json& s) { return s["step"].get<long>() > 3; }));

    // Stop before the projection.
    desk.click("dot projection");
    REQUIRE(desk.becomes("playing", false));
    CHECK(inspector(desk.state())["stopped"] == "before projection");
    CHECK(desk.state()["stage"] == "viscosity");
    const long step = desk.state()["step"];

    // Run it, and look at what it changed.
    desk.click("stage");
    REQUIRE(desk.becomes("stage", "projection"));
    desk.key("v");
    desk.key("v");
    CHECK(desk.becomes(
        [](const Json& s) { return inspector(s)["compare"] == "difference" && inspector(s)["stage"] == "projection"; }));

    // Pick a cell and ask for its pressure, then for what went into it.
    desk.click(desk.on("scene", 0.45, 0.5));
    REQUIRE(desk.becomes([](const Json& s) { return inspector(s)["shown"] == true && inspector(s)["thing"]["on"] == "cell"; }));
    desk.click("why pressure");
    REQUIRE(desk.becomes(
        [](const Json& s) { return inspector(s).contains("answer") && inspector(s)["answer"]["field"] == "pressure"; }));
    const Json answer = inspector(desk.state())["answer"];
    CHECK(answer["stage"] == "projection");
    // Its neighbours were solved together with it: the divergence that the solver was given leads on.
    CHECK_FALSE(desk.state()["controls"].contains("ask p_left"));
    // It stands below what is in sight.
    const Spot inputs = desk.on("ask d̃");
    desk.move({inputs.x, 700});
    for (int turns = 0; turns < 8; ++turns) desk.wheel(true);
    desk.click("ask d̃");
    CHECK(desk.becomes([](const Json& s) { return inspector(s)["questions"] == 2; }));
    desk.key("BackSpace");
    CHECK(desk.becomes([&](const Json& s) { return inspector(s)["answer"]["index"] == answer["index"]; }));

    // Back, another Δt, and on.
    desk.key("comma");
    REQUIRE(desk.becomes("step", step));
    desk.click(desk.on("time_step", 0.9));
    CHECK(desk.becomes([](const Json& s) { return std::stod(s["parameters"]["time_step"].get<std::string>()) > 0.05; }));
    desk.key("space");
    REQUIRE(desk.becomes([&](const Json& s) { return inspector(s)["stopped"] == "before projection" && s["playing"] == false; }));
    CHECK(desk.complaints().empty());
}

TEST_CASE("the past is scrubbed back and forth", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    REQUIRE(desk.becomes([](const Json& s) { return s["step"].get<long>() > 40; }));
    desk.key("space");
    REQUIRE(desk.becomes("playing", false));
    const long reach = inspector(desk.state())["reach"];
    desk.click(desk.on("past", 0.25));
    REQUIRE(desk.becomes([&](const Json& s) { return s["step"].get<long>() < reach / 2; }));
    CHECK(inspector(desk.state())["reach"] == reach);
    desk.click(desk.on("past", 0.995));
    CHECK(desk.becomes([&](const Json& s) { return s["step"].get<long>() > reach - 5; }));
    CHECK(desk.complaints().empty());
}

TEST_CASE("a run stops on a condition that was typed", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    desk.key("space");
    REQUIRE(desk.becomes("playing", false));
    desk.key("r");
    desk.key("F9");
    REQUIRE(desk.becomes([](const Json& s) { return s["controls"].contains("condition"); }));
    desk.click("condition");
    desk.type("height < 0.3");
    desk.click("add condition");
    REQUIRE(desk.becomes([](const Json& s) { return inspector(s).contains("conditions"); }));
    desk.key("Escape");
    desk.key("Escape");
    desk.key("space");
    REQUIRE(desk.becomes([](const Json& s) { return s["playing"] == false && s["step"].get<long>() > 0; }));
    const Json state = desk.state();
    CHECK(inspector(state)["stopped"].get<std::string>().starts_with("height < 0.3"));
    CHECK(state["probes"]["height"] < 0.3);
    CHECK(desk.complaints().empty());
}
