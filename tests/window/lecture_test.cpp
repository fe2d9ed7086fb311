// A lecture given from its file by real keys, and gone on with after a restart.
#include "desk.h"

#include <catch2/generators/catch_generators.hpp>

using namespace pliant::test;

namespace {

bool lecture_at(Desk& desk, long slide, bool revealed) {
    return desk.becomes([&](const Json& s) { return s["slide"] == slide && s["revealed"] == revealed && s["busy"].is_null(); });
}

// Goes on, as a remote control does, until this slide comes up.
void go_on_to(Desk& desk, long slide) {
    for (int presses = 0; presses < 60 && desk.state()["slide"] < slide; ++presses) desk.key("Next");
    REQUIRE(desk.becomes("slide", slide));
}

}  // namespace

TEST_CASE("a lecture is given from its file: a comparison, a blow-up, a map on its slide, and the end", "[window][lecture]") {
    need_screen_and_mouse();
    const auto [size, scale] = GENERATE(table<std::string, std::string>({{"1280x720", "1.5"}, {"1920x1080", "1"}}));
    INFO(size << " at " << scale);
    Desk desk({"lecture", "soft_bodies", "--present", "--size", size, "--ui-scale", scale}, "", "us", size);
    REQUIRE(lecture_at(desk, 1, false));
    CHECK(desk.state()["layout"] == "deck");
    go_on_to(desk, 13);
    CHECK_FALSE(desk.state()["companion"].is_null());
    desk.key("Next");
    REQUIRE(lecture_at(desk, 13, true));
    CHECK(desk.state()["companion"]["step"] == desk.state()["step"]);

    desk.key("Next");
    REQUIRE(lecture_at(desk, 14, false));
    desk.key("space");
    REQUIRE(desk.becomes([](const Json& s) { return s["autopsy"] != ""; }));
    CHECK(lecture_at(desk, 14, false));
    desk.key("Escape");
    REQUIRE(desk.becomes("autopsy", ""));
    desk.key("Next");
    REQUIRE(lecture_at(desk, 14, true));

    desk.key("Next");
    REQUIRE(desk.becomes("slide", 15));
    desk.key("Next");
    REQUIRE(desk.becomes([](const Json& s) { return s["atlas"]["mapped"] == true && s["atlas"]["busy"] == false; }));
    CHECK(desk.state()["slide"] == 15);
    CHECK(desk.state()["fill"] == "");
    CHECK(desk.state()["controls"].contains("atlas map"));
    go_on_to(desk, 19);
    CHECK(desk.complaints().empty());
    CHECK(desk.close_window() == 0);
}

TEST_CASE("a lecture goes on from a map to the slide of a lesson that lacks its knobs", "[window][lecture]") {
    need_screen_and_mouse();
    Desk desk({"lecture", "fluids", "--present", "--slide", "9"});
    REQUIRE(lecture_at(desk, 9, false));
    desk.key("Next");
    REQUIRE(desk.becomes([](const Json& s) { return s["atlas"]["cells_done"] > 0; }));
    go_on_to(desk, 10);
    desk.key("Prior");
    CHECK(desk.becomes("slide", 9));
    CHECK(desk.complaints().empty());
    CHECK(desk.close_window() == 0);
}

TEST_CASE("a lecture goes on where it was left, with what was done there", "[window][lecture]") {
    need_screen_and_mouse();
    const Scratch kept;
    const Arguments lecture{"lecture", "soft_bodies", "--present"};
    std::string parameters, step;
    {
        Desk desk({"lecture", "soft_bodies", "--present", "--slide", "12"}, kept.path("config"));
        REQUIRE(lecture_at(desk, 12, false));
        desk.key("Next");
        REQUIRE(lecture_at(desk, 12, true));
        desk.drag(desk.on("gravity"), desk.on("gravity", 0.25));
        REQUIRE(desk.becomes([&](const Json&) { return desk.parameter("gravity") < 9; }));
        desk.key("F2");
        desk.key("F3");
        REQUIRE(desk.becomes([](const Json& s) { return s["passes"] > 0; }));
        parameters = desk.state()["parameters"].dump(), step = desk.state()["step"].dump() + desk.state()["stage"].dump();
        CHECK(desk.close_window() == 0);
    }
    Desk desk(lecture, kept.path("config"));
    REQUIRE(lecture_at(desk, 12, true));
    CHECK(desk.state()["layout"] == "deck");
    CHECK(desk.state()["parameters"].dump() == parameters);
    CHECK(desk.state()["step"].dump() + desk.state()["stage"].dump() == step);
    desk.key("Home");
    CHECK(lecture_at(desk, 1, false));
}
