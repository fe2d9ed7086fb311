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
        desk.click("predict 1");
        REQUIRE(desk.becomes([](const Json& s) { return s["prediction"]["option"] == 1; }));
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
