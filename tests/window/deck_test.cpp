// A lecture: the walkthrough as a deck, under the keys of a presenter.
#include "desk.h"

using namespace pliant::test;

namespace {

// The first slide allows youngs_modulus and load.
const Arguments lecture{"walkthrough", "elasticity/moduli", "--present", "--notes"};

bool at(Desk& desk, long slide, bool revealed) {
    return desk.becomes([&](const Json& s) { return s["slide"] == slide && s["revealed"] == revealed; });
}

}  // namespace

TEST_CASE("the keys of a presenter go through the deck", "[window][deck]") {
    need_screen_and_mouse();
    Desk desk(lecture);
    CHECK(desk.state()["layout"] == "deck");
    CHECK(desk.state()["playing"] == false);
    REQUIRE(at(desk, 1, false));
    CHECK(desk.state()["step"] == 0);
    desk.key("Right");
    CHECK(at(desk, 1, true));
    CHECK(desk.state()["step"] == 1);
    desk.key("Right");
    CHECK(at(desk, 2, false));
    desk.key("Next");
    CHECK(at(desk, 2, true));
    desk.key("Left");
    CHECK(at(desk, 2, false));
    desk.key("Prior");
    CHECK(at(desk, 1, false));
    desk.key("End");
    CHECK(at(desk, 8, false));
    desk.key("Home");
    CHECK(at(desk, 1, false));
    desk.key("n");
    CHECK(at(desk, 1, true));
    desk.key("b");
    CHECK(desk.becomes("black", true));
    desk.key("Left");
    CHECK(desk.becomes("black", false));
    CHECK(at(desk, 1, true));
    CHECK(desk.complaints().empty());
}

TEST_CASE("in the deck a slider that the slide allows moves, and Backspace puts everything back", "[window][deck]") {
    need_screen_and_mouse();
    Desk desk(lecture);
    REQUIRE(at(desk, 1, false));
    const double load = desk.parameter("load");
    CHECK_FALSE(desk.state()["controls"].contains("poisson_ratio"));
    desk.drag(desk.on("load"), desk.on("load", 0.25));
    CHECK(desk.becomes([&](const Json&) { return desk.parameter("load") != load; }));
    desk.key("Right");
    CHECK(at(desk, 1, true));
    desk.key("BackSpace");
    CHECK(at(desk, 1, false));
    CHECK(desk.parameter("load") == load);
    CHECK(desk.state()["step"] == 0);
}

TEST_CASE("in the deck the arrows and Space are its own behind a click on a slider, too", "[window][deck]") {
    need_screen_and_mouse();
    Desk desk({"walkthrough", "mesh/mass_spring", "--present"});
    for (int presses = 0; presses < 8; ++presses) desk.key("Right");
    REQUIRE(at(desk, 5, false));
    desk.click(desk.on("time_step", 0.3));
    desk.key("Right");
    CHECK(at(desk, 5, true));
    CHECK(desk.parameter("time_step") == 5e-4);
    desk.key("Right");
    CHECK(at(desk, 6, false));
    desk.click(desk.on("time_step", 0.3));
    desk.key("space");
    CHECK(desk.becomes("playing", true));
    desk.key("space");
    CHECK(desk.becomes("playing", false));
    desk.type("]");
    CHECK(desk.stays("lesson", "mesh/mass_spring"));
    CHECK(desk.becomes([](const Json& s) { return s["message"].get<std::string>().find("Escape") != std::string::npos; }));
    desk.key("Escape");  // closes the message
    CHECK(desk.becomes("message", ""));
    desk.key("Escape");
    CHECK(desk.becomes("layout", "lab"));
}

TEST_CASE("Escape goes to the lab with this run; there a locked slider does not move until L unlocks it", "[window][deck]") {
    need_screen_and_mouse();
    Desk desk(lecture);
    desk.key("Right");
    REQUIRE(at(desk, 1, true));
    desk.key("Escape");
    REQUIRE(desk.becomes("layout", "lab"));
    CHECK(at(desk, 1, true));
    CHECK(desk.state()["step"] == 1);
    const std::string key = "poisson_ratio";
    REQUIRE(desk.becomes([&](const Json& s) { return s["controls"].contains(key); }));
    desk.drag(desk.on(key), desk.on(key, 0.25));
    CHECK(desk.stays("parameters", desk.state()["parameters"]));
    CHECK(desk.parameter(key) == 0.3);
    // The arrows belong to the deck alone.
    desk.key("Right");
    CHECK(at(desk, 1, true));
    desk.key("l");
    CHECK(desk.becomes("unlocked", true));
    desk.drag(desk.on(key), desk.on(key, 0.25));
    CHECK(desk.becomes([&](const Json&) { return desk.parameter(key) < 0.1; }));
    desk.key("l");
    CHECK(desk.becomes("unlocked", false));
    desk.click("walkthrough deck");
    CHECK(desk.becomes("layout", "deck"));
    desk.key("d");
    CHECK(desk.becomes("layout", "lab"));
    desk.click("walkthrough end");
    CHECK(desk.becomes("slide", 0));
}

TEST_CASE("a slider of the deck is set by keys alone", "[window][deck]") {
    need_screen_and_mouse();
    Desk desk(lecture);
    REQUIRE(at(desk, 1, false));
    desk.key("Tab");
    REQUIRE(desk.becomes("typing", true));
    desk.key("ctrl+a");
    desk.type("0.5");
    desk.key("Return");
    CHECK(desk.becomes([&](const Json&) { return desk.parameter("youngs_modulus") == 500000; }));
    CHECK(at(desk, 1, false));
    desk.key("Right");
    CHECK(at(desk, 1, true));
}

TEST_CASE("the notes are for the lecturer: by a key on the screen, and in the terminal", "[window][deck]") {
    need_screen_and_mouse();
    Desk desk(lecture);
    REQUIRE(at(desk, 1, false));
    CHECK(desk.state()["notes"] == false);
    CHECK_FALSE(desk.state()["controls"].contains("notes"));
    desk.key("o");
    CHECK(desk.becomes("notes", true));
    CHECK(desk.becomes([](const Json& s) { return s["controls"].contains("notes"); }));
    desk.key("End");
    REQUIRE(at(desk, 8, false));
    CHECK(desk.becomes([&](const Json&) {
        return desk.output().find("1 / 8  A pull\nThree minutes.") == 0 &&
               desk.output().find("8 / 8  How exact") != std::string::npos;
    }));
}

TEST_CASE("after a deck the lab opens with its panels", "[window][deck]") {
    need_screen_and_mouse();
    const Scratch scratch;
    const std::string config = scratch.path("config");
    {
        Desk desk({"walkthrough", "mesh/rod", "--present"}, config);
        REQUIRE(desk.becomes("layout", "deck"));
        desk.key("t");
        REQUIRE(desk.becomes("theme", "projector"));
        CHECK(desk.close_window() == 0);
    }
    Desk desk({}, config);
    CHECK(desk.state()["theme"] == "projector");
    CHECK(desk.state()["layout"] == "lab");
}

TEST_CASE("Escape leads from the slide without panels back to the lab", "[window][deck]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "elasticity/moduli"});
    desk.key("Tab");
    REQUIRE(desk.becomes("layout", "slide"));
    desk.key("Escape");
    CHECK(desk.becomes("layout", "lab"));
}
