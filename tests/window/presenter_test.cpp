// The window of the lecturer beside that of the audience, by real keys and mouse; and the full screen.
#include "desk.h"

using namespace pliant::test;

namespace {

bool deck_at(Desk& desk, long slide, bool revealed) {
    return desk.becomes([&](const Json& s) { return s["slide"] == slide && s["revealed"] == revealed; });
}

bool lecturer_sees(Desk& desk, const std::string& key, const Json& value) {
    return desk.becomes([&](const Json& s) { return !s["presenter"].is_null() && s["presenter"][key] == value; });
}

Spot on_lecturers(Desk& desk, const std::string& control) {
    REQUIRE(
        desk.becomes([&](const Json& s) { return !s["presenter"].is_null() && s["presenter"]["controls"].contains(control); }));
    const Json r = desk.state()["presenter"]["controls"][control];
    return {static_cast<int>(r[0].get<double>() + r[2].get<double>() / 2),
            static_cast<int>(r[1].get<double>() + r[3].get<double>() / 2)};
}

}  // namespace

TEST_CASE("the lecturer has notes, what comes next and the keys of the deck in a window of their own", "[window][deck]") {
    need_screen_and_mouse();
    Desk desk({"walkthrough", "elasticity/moduli", "--present", "--presenter"});
    REQUIRE(lecturer_sees(desk, "slide", 1));
    CHECK(desk.state()["presenter"]["title"] == "A pull");
    CHECK(desk.state()["presenter"]["notes"].get<std::string>().starts_with("Three minutes."));
    CHECK(desk.state()["presenter"]["next"] == "runs, and shows the answer");
    // The audience sees no notes, whatever is pressed.
    desk.key("o");
    desk.wait_frames(frames_to_notice);
    CHECK_FALSE(desk.state()["controls"].contains("notes"));

    desk.turn_to("Lecturer");
    desk.key("Next");
    CHECK(deck_at(desk, 1, true));
    CHECK(lecturer_sees(desk, "next", "turns to slide 2"));
    desk.key("Right");
    CHECK(deck_at(desk, 2, false));
    CHECK(lecturer_sees(desk, "slide", 2));
    desk.key("period");
    CHECK(desk.becomes("black", true));
    CHECK(lecturer_sees(desk, "black", true));
    desk.key("Next");
    CHECK(desk.becomes("black", false));
    CHECK(deck_at(desk, 2, false));

    // Its clock: a press on a button of its own.
    desk.click(on_lecturers(desk, "pause clock"));
    CHECK(lecturer_sees(desk, "clock_paused", true));
    desk.key("Prior");
    CHECK(deck_at(desk, 1, false));

    // Keys in the window of the audience, and both show the same.
    desk.turn_to("Pliant");
    desk.key("Right");
    CHECK(deck_at(desk, 1, true));
    CHECK(lecturer_sees(desk, "next", "turns to slide 2"));

    // Closing it closes it alone; a key opens it again.
    desk.turn_to("Lecturer");
    desk.ask_to_close();
    CHECK(desk.becomes("presenter", nullptr));
    desk.turn_to("Pliant");
    CHECK(deck_at(desk, 1, true));
    CHECK(desk.state()["notes"] == false);
    CHECK_FALSE(desk.state()["controls"].contains("notes"));
    desk.key("F12");
    CHECK(lecturer_sees(desk, "slide", 1));
    desk.turn_to("Pliant");
    CHECK(desk.close_window() == 0);
    CHECK(desk.complaints().empty());
}

TEST_CASE("Space in the window of the lecturer plays and pauses the deck", "[window][deck]") {
    need_screen_and_mouse();
    Desk desk({"walkthrough", "mesh/mass_spring", "--present", "--presenter"});
    REQUIRE(lecturer_sees(desk, "slide", 1));
    desk.turn_to("Lecturer");
    desk.key("space");
    CHECK(desk.becomes("playing", true));
    desk.key("space");
    CHECK(desk.becomes("playing", false));
    CHECK(desk.state()["step"] > 0);
}

TEST_CASE("with the window of the lecturer a lab that is left alone rests, but for a clock once a second", "[window][deck]") {
    need_screen_and_mouse();
    Desk desk({"walkthrough", "elasticity/moduli", "--present", "--presenter"});
    REQUIRE(lecturer_sees(desk, "slide", 1));
    REQUIRE(desk.becomes("resting", true));
    const long lab = desk.frames(), page = desk.state()["presenter"]["frames"];
    CHECK(desk.becomes([&](const Json& s) { return s["presenter"]["frames"] >= page + 3; }));
    std::this_thread::sleep_for(2s);
    CHECK(desk.frames() == lab);
    CHECK(desk.state()["presenter"]["frames"].get<long>() - page < 60);
}

TEST_CASE("F11 fills the screen with the window and gives its size back", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--size", "900x600"});
    const auto size = desk.window_size();
    REQUIRE(size == std::pair(900, 600));
    desk.key("F11");
    CHECK(desk.becomes("full_screen", true));
    CHECK(desk.becomes([&](const Json&) { return desk.window_size() == std::pair(1280, 800); }));
    desk.key("F11");
    CHECK(desk.becomes("full_screen", false));
    CHECK(desk.becomes([&](const Json&) { return desk.window_size() == size; }));
    CHECK(desk.complaints().empty());
}
