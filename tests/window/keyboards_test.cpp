// The keys of README on a German and a French keyboard, by the keys that a hand presses: X counts a key by its place, 8 more than
// the kernel, whatever stands on it.
#include "desk.h"

using namespace pliant::test;

namespace {

const std::string with_shift = "50+", with_alt_gr = "108+", with_ctrl = "37+";

// What to press for each sign, and for the letters that other keyboards have elsewhere.
struct Keyboard {
    std::string layout, step, step_back, stage, comma, stage_back, pass, pass_back, lesson_before, next_lesson, larger, smaller,
        undo;
};
const Keyboard german{"de",
                      "60",
                      "94",
                      with_shift + "16",
                      "59",
                      "58",
                      with_shift + "59",
                      with_shift + "51",
                      with_alt_gr + "17",
                      with_alt_gr + "18",
                      with_ctrl + "35",
                      with_ctrl + "61",
                      with_ctrl + "29"};
const Keyboard french{"fr",
                      with_shift + "59",
                      "94",
                      with_shift + "60",
                      "58",
                      "47",
                      "59",
                      "13",
                      with_alt_gr + "14",
                      with_alt_gr + "20",
                      with_ctrl + with_shift + "21",
                      with_ctrl + "15",
                      with_ctrl + "25"};

void try_keys(const Keyboard& keys) {
    Desk desk({"--lesson", "elasticity/moduli"}, "", keys.layout);
    desk.key("space");
    REQUIRE(desk.becomes("playing", false));
    desk.key("r");
    REQUIRE(desk.becomes("step", 0));

    desk.key(keys.next_lesson);
    CHECK(desk.becomes([](const Json& s) { return s["lesson"] != "elasticity/moduli"; }));
    desk.key(keys.lesson_before);
    CHECK(desk.becomes("lesson", "elasticity/moduli"));

    desk.key(keys.step);
    CHECK(desk.becomes("step", 1));
    desk.key(keys.step_back);
    CHECK(desk.becomes("step", 0));
    desk.key(keys.stage);
    CHECK(desk.becomes([](const Json& s) { return s["passes"] > 0; }));
    const long passes = desk.state()["passes"];
    desk.key(keys.pass);
    CHECK(desk.becomes("passes", passes + 1));
    desk.key(keys.pass_back);
    CHECK(desk.becomes("passes", passes));
    desk.key(keys.stage_back);
    CHECK(desk.becomes([&](const Json& s) { return s["passes"] < passes; }));
    desk.key(keys.stage);
    CHECK(desk.becomes([&](const Json& s) { return s["passes"] >= passes; }));
    desk.key(keys.comma);
    CHECK(desk.becomes([&](const Json& s) { return s["passes"] < passes; }));
    desk.key("r");

    // The twins, which are where they are.
    desk.key("F2");
    CHECK(desk.becomes("step", 1));
    desk.key("shift+F2");
    CHECK(desk.becomes("step", 0));
    desk.key("F3");
    CHECK(desk.becomes([](const Json& s) { return s["passes"] > 0; }));
    desk.key("F7");
    CHECK(desk.becomes([](const Json& s) { return s["lesson"] != "elasticity/moduli"; }));
    desk.key("shift+F7");
    CHECK(desk.becomes("lesson", "elasticity/moduli"));

    desk.key(keys.larger);
    CHECK(desk.becomes("scale", 1.25));
    desk.key(keys.smaller);
    CHECK(desk.becomes("scale", 1.0));
    desk.drag(desk.on("poisson_ratio"), desk.on("poisson_ratio", 0.3));
    CHECK(desk.parameter("poisson_ratio") < 0.25);
    desk.key(keys.undo);
    CHECK(desk.becomes([&](const Json& s) { return s["parameters"]["poisson_ratio"] == "0.3"; }));
    CHECK(desk.complaints().empty());
}

}  // namespace

TEST_CASE("the keys work on a German keyboard", "[window]") {
    need_screen_and_mouse();
    try_keys(german);
}

TEST_CASE("the keys work on a French keyboard", "[window]") {
    need_screen_and_mouse();
    try_keys(french);
}
