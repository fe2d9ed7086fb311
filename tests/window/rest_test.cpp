// A lab that is left alone draws nothing, and wakes up at once.
#include "desk.h"

using namespace pliant::test;

namespace {

// The frames drawn while nobody touches it for two seconds.
long frames_at_rest(Desk& desk) {
    REQUIRE(desk.becomes("resting", true));
    const long before = desk.frames();
    std::this_thread::sleep_for(2s);
    return desk.frames() - before;
}

}  // namespace

TEST_CASE("a paused lab draws no frame until something happens", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    CHECK(desk.state()["resting"] == false);
    desk.key("space");
    REQUIRE(desk.becomes("playing", false));
    CHECK(frames_at_rest(desk) == 0);

    // It wakes up for the mouse, which makes the frames that a tip takes to come, and for keys.
    const long before = desk.frames();
    desk.move(desk.on("play"));
    REQUIRE(desk.becomes([&](const Json& s) { return s["frame"] > before; }));
    CHECK(frames_at_rest(desk) == 0);
    desk.key("period");
    CHECK(frames_at_rest(desk) == 0);
    desk.key("space");
    REQUIRE(desk.becomes("playing", true));
    CHECK(desk.state()["resting"] == false);
    const long playing = desk.frames();
    CHECK(desk.becomes([&](const Json& s) { return s["frame"] > playing + 10; }));
    CHECK(desk.complaints().empty());
}

TEST_CASE("a window that is closed while it rests ends", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    desk.key("space");
    REQUIRE(desk.becomes("resting", true));
    CHECK(desk.close_window() == 0);
    CHECK(desk.complaints().empty());
}

TEST_CASE("a solve that takes long is watched pass by pass, and Space stops it where it stands", "[window]") {
    need_screen_and_mouse();
    const Scratch scratch;
    const std::string scene = scratch.file(
        "slow.json", R"({"pliant": 1, "lesson": "elasticity/moduli", "parameters": {"resolution": 16, "load_levels": 100}})");
    Desk desk({"--scene", scene});
    desk.key("space");
    REQUIRE(desk.becomes("playing", false));
    desk.key("r");
    REQUIRE(desk.becomes([](const Json& s) { return s["step"] == 0 && s["passes"] == 0; }));
    desk.key("period");
    REQUIRE(desk.becomes([](const Json& s) { return s["computing"] == true && s["passes"] > 3; }));
    const long frames = desk.frames(), passes = desk.state()["passes"];
    REQUIRE(desk.becomes([&](const Json& s) { return s["frame"] > frames + 10 && s["passes"] > passes; }));
    desk.key("space");
    REQUIRE(desk.becomes("computing", false));
    CHECK(desk.state()["step"] == 0);
    const long there = desk.state()["passes"];
    CHECK(there > 0);
    CHECK(desk.stays("passes", there));
    CHECK(desk.complaints().empty());
}
