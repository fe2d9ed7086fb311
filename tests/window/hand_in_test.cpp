// A student's session ends in a file to hand in, which the program reads and repeats.
#include "desk.h"

#include <fstream>

using namespace pliant::test;

TEST_CASE("a student predicts, notes a number and an answer, goes on after a restart, and hands in", "[window][handin]") {
    need_screen_and_mouse();
    const Scratch scratch;
    const std::string config = scratch.path("config"), kept = config + "/pliant/noted.handin.json";
    const auto check = [&](const std::string& path) { return run_process(PLIANT_PROGRAM, {"handin", path, "--json"}); };
    {
        Desk desk({"--lesson", "fluids/projection"}, config);
        desk.key("n");
        REQUIRE(desk.becomes([](const Json& s) { return s["slide"] == 1 && s["prediction"]["given"] == false; }));
        desk.click("predict 2");
        REQUIRE(desk.becomes([](const Json& s) { return s["prediction"]["option"] == 2; }));
        desk.click("walkthrough next");
        REQUIRE(desk.becomes([](const Json& s) { return s["revealed"] == true && s["prediction"]["right"] == true; }));
        desk.key("h");
        desk.click("hand-in name");
        desk.type("Ada");
        desk.click("hand-in number");
        desk.click("hand-in number cell_divergence");
        desk.click("hand-in answer");
        desk.type("more leaves than enters");
        desk.click("hand-in add answer");
        REQUIRE(desk.becomes("handed_in", 3));
        desk.click("hand-in close");
        CHECK(desk.close_window() == 0);
    }
    const Outcome good = check(kept);
    INFO(good.out << good.err);
    REQUIRE(good.exit_code == 0);
    const Json report = Json::parse(good.out);
    CHECK(report["name"] == "Ada");
    CHECK(report["entries"].size() == 3);
    CHECK(report["entries"][1]["repeated"] == true);
    CHECK(report["entries"][1]["holds"] == true);

    // Changed by hand.
    std::string text = contents_of(kept);
    text.replace(text.find("Ada"), 3, "Eve");
    const std::string changed = scratch.file("changed.handin.json", text);
    CHECK(check(changed).exit_code == 1);
    CHECK(Json::parse(check(changed).out)["unchanged"] == false);
    CHECK(check(scratch.file("none.handin.json", "{}")).exit_code == 2);

    // Another day, another lesson: the same file goes on.
    Desk desk({"--lesson", "elasticity/moduli"}, config);
    CHECK(desk.becomes("handed_in", 3));
    desk.key("space");
    REQUIRE(desk.becomes("playing", false));
    desk.key("h");
    desk.click("hand-in answer");
    desk.type("Y is a slope");
    desk.click("hand-in add answer");
    CHECK(desk.becomes("handed_in", 4));
    CHECK(desk.complaints().empty());
}

namespace {

// On with the walkthrough to the next slide that asks for such a prediction, its answer hidden.
void walk_to(Desk& desk, const std::string& kind) {
    constexpr int most = 60;
    for (int k = 0; k < most; ++k) {
        const Json before = desk.state();
        if (before["revealed"] == false && !before["prediction"].is_null() && before["prediction"]["kind"] == kind) return;
        desk.key("n");
        REQUIRE(desk.becomes([&](const Json& s) {
            return s["busy"].is_null() && (s["slide"] != before["slide"] || s["revealed"] != before["revealed"]);
        }));
    }
    FAIL("no slide asks for a " << kind);
}

void reveal(Desk& desk) {
    desk.click("walkthrough next");
    REQUIRE(desk.becomes([](const Json& s) { return s["revealed"] == true && s["prediction"].contains("right"); }));
}

}  // namespace

TEST_CASE("a session over two lessons: a choice by a key, a number with a comma, a curve drawn by the mouse, methods, what if",
          "[window][handin]") {
    need_screen_and_mouse();
    const Scratch scratch;
    const std::string config = scratch.path("config");
    {
        Desk desk({"--lesson", "time/integration"}, config);
        desk.key("n");
        walk_to(desk, "choice");
        desk.key("d");
        REQUIRE(desk.becomes("layout", "deck"));
        desk.key("2");
        REQUIRE(desk.becomes([](const Json& s) { return s["prediction"]["option"] == 2; }));
        desk.key("d");
        REQUIRE(desk.becomes("layout", "lab"));
        reveal(desk);
        walk_to(desk, "number");
        desk.click("predict number");
        desk.type("0,85");
        desk.key("Return");
        REQUIRE(desk.becomes([](const Json& s) { return s["prediction"]["number"] == 0.85; }));
        reveal(desk);
        desk.click("walkthrough");
        REQUIRE(desk.becomes("slide", 0));
        desk.click_right(desk.on("omega"));
        desk.click("what if 2");
        REQUIRE(desk.becomes([](const Json& s) { return !s["companion"].is_null(); }));
        desk.key("s");
        CHECK(desk.becomes(
            [](const Json& s) { return s["summary"].get<std::string>().find("Beside it runs B") != std::string::npos; }));
        desk.key("Escape");
        desk.key("y");
        CHECK(desk.becomes([](const Json& s) { return s["methods"]["busy"] == false && s["methods"]["rows"].size() > 4; }));
        desk.key("h");
        desk.click("hand-in name");
        desk.type("Ada");
        REQUIRE(desk.becomes("handed_in", 2));
        CHECK(desk.close_window() == 0);
    }
    Desk desk({"--lesson", "mesh/mass_spring"}, config);
    REQUIRE(desk.becomes("handed_in", 2));
    desk.key("n");
    walk_to(desk, "sketch");
    desk.move(desk.on("predict sketch", 0.01, 0.8));
    desk.press();
    for (const double along : {0.2, 0.4, 0.6, 0.8, 0.99}) desk.move(desk.on("predict sketch", along, 0.8 - 0.5 * along));
    desk.release();
    REQUIRE(desk.becomes([](const Json& s) {
        const Json& drawn = s["prediction"]["sketch"];
        return drawn.size() == 33 && drawn.front() < drawn[16] && drawn[16] < drawn.back();
    }));
    reveal(desk);
    REQUIRE(desk.becomes("handed_in", 3));
    desk.key("h");
    desk.click("hand-in picture");
    REQUIRE(desk.becomes("handed_in", 4));
    desk.click("hand-in number");
    desk.click("hand-in number energy");
    REQUIRE(desk.becomes("handed_in", 5));
    desk.click("hand-in save");
    REQUIRE(desk.becomes("dialog", "Save what you hand in"));
    desk.key("Return");
    const std::string handed_in = desk.scratch().path("ada_work.handin.json");
    REQUIRE(desk.becomes([&](const Json&) { return fs::exists(handed_in); }));
    CHECK(desk.complaints().empty());

    const Outcome outcome = run_process(PLIANT_PROGRAM, {"handin", handed_in, "--json"});
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const Json report = Json::parse(outcome.out);
    REQUIRE(report["entries"].size() == 5);
    for (const int prediction : {0, 1, 2}) {
        CHECK(report["entries"][prediction]["repeated"] == true);
        CHECK(report["entries"][prediction]["holds"] == true);
    }
    // Said to have been right where it was not: the run says otherwise, and the checksum, too.
    std::string text = contents_of(handed_in);
    const auto at = text.find("\"right\": false");
    REQUIRE(at != std::string::npos);
    const Outcome changed = run_process(
        PLIANT_PROGRAM, {"handin", scratch.file("changed.handin.json", text.replace(at, 14, "\"right\": true")), "--json"});
    CHECK(changed.exit_code == 1);
    CHECK(Json::parse(changed.out)["unchanged"] == false);
}
