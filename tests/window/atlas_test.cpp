// A person and the atlas, with a real mouse and real keys.
#include "desk.h"

using namespace pliant::test;

TEST_CASE("a map is made, read under the pointer, and a click opens one of its cells", "[window][atlas]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "time/integration"});
    desk.key("w");
    REQUIRE(desk.becomes([](const Json& s) { return s["atlas"]["shown"] == true && s["controls"].contains("atlas make"); }));
    desk.click("atlas make");
    REQUIRE(desk.becomes([](const Json& s) { return s["atlas"]["mapped"] == true; }));
    desk.wait_frames(frames_to_notice);

    // The map has 24 × 24 cells.
    desk.move(desk.on("atlas area", 0.9, 0.1));
    REQUIRE(desk.becomes([](const Json& s) { return s["atlas"]["cell"] == Json{21, 21}; }));
    desk.click(desk.on("atlas area", 0.1, 0.99));
    REQUIRE(desk.becomes([](const Json& s) {
        return !s["atlas"]["present"].is_null() && std::abs(s["atlas"]["present"][0].get<double>() - 2) < 1e-6 &&
               std::abs(s["atlas"]["present"][1].get<double>()) < 1e-6;
    }));
    CHECK(desk.parameter("omega") == 0.1);
    desk.key("ctrl+z");
    CHECK(desk.becomes([](const Json& s) { return s["parameters"]["omega"] == "2"; }));
    CHECK(desk.complaints().empty());
}

TEST_CASE("a window may be closed while a map is made", "[window][atlas]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "mass_spring"});
    desk.key("w");
    REQUIRE(desk.becomes([](const Json& s) { return s["controls"].contains("atlas make"); }));
    desk.click("atlas make");
    REQUIRE(desk.becomes([](const Json& s) { return s["atlas"]["busy"] == true; }));
    CHECK(desk.close_window() == 0);
    CHECK(desk.complaints().empty());
}
