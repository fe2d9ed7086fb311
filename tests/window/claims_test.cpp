// A student and a claim of the lecture, with a real mouse and real keys.
#include "desk.h"

using namespace pliant::test;

namespace {

const Json& card(const Json& state, const std::string& id) { return state["claims"]["cards"][id]; }

}  // namespace

TEST_CASE("a student predicts, measures, opens the claim as a scene, and goes to another lesson meanwhile", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "moduli"});
    desk.key("k");
    REQUIRE(desk.becomes([](const Json& s) { return s["claims"]["shown"] == true && s["controls"].contains("claim E4"); }));
    desk.click("claim E4");
    REQUIRE(desk.becomes([](const Json& s) { return s["claims"]["unfolded"] == "E4"; }));
    desk.wait_frames(frames_to_notice);

    desk.click("claim answer 0");
    REQUIRE(desk.becomes([](const Json& s) { return card(s, "E4")["prediction"] == 0; }));
    desk.click("claim answer 1");
    REQUIRE(desk.becomes([](const Json& s) { return card(s, "E4")["prediction"] == 1; }));
    desk.click("claim run");
    REQUIRE(desk.becomes([](const Json& s) { return card(s, "E4")["stage"] == "measured"; }));
    CHECK(card(desk.state(), "E4")["verdict"] == "reproduced");
    CHECK(card(desk.state(), "E4")["right"] == true);

    desk.wait_frames(frames_to_notice);
    desk.click("claim scene");
    REQUIRE(desk.becomes([](const Json& s) { return s["parameters"]["test"] == "shear" && s["step"] == 1; }));

    // What is measured does not hold up the lab, and stays on its card in another lesson.
    desk.click("claims of all");
    REQUIRE(desk.becomes([](const Json& s) { return s["claims"]["all"] == true; }));
    desk.wait_frames(frames_to_notice);
    desk.click("claim E3");
    desk.wait_frames(frames_to_notice);
    desk.click("claim run");
    desk.key("bracketright");
    REQUIRE(desk.becomes([](const Json& s) { return s["lesson"] != "elasticity/moduli"; }));
    CHECK(desk.becomes([](const Json& s) { return card(s, "E3")["stage"] == "measured"; }));
    CHECK(card(desk.state(), "E4")["right"] == true);
    CHECK(desk.complaints().empty());
}

TEST_CASE("a window may be closed while a claim is measured", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "moduli"});
    desk.key("k");
    REQUIRE(desk.becomes([](const Json& s) { return s["controls"].contains("claim run"); }));
    desk.click("claim run");
    CHECK(desk.close_window() == 0);
    CHECK(desk.complaints().empty());
}

TEST_CASE("the claims are reached by keys alone", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "moduli"});
    desk.key("k");
    REQUIRE(desk.becomes([](const Json& s) { return s.contains("focus") && s["focus"]["control"] == "claim E3"; }));
    desk.key("Down");
    REQUIRE(desk.becomes([](const Json& s) { return s["focus"]["control"] == "claim answer 0"; }));
    desk.key("Down");
    desk.key("Return");
    CHECK(desk.becomes([](const Json& s) { return card(s, "E3")["prediction"] == 1; }));
    CHECK(desk.complaints().empty());
}
