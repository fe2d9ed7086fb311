// A static lesson that nothing was solved of yet says what to do.
#include <pliant/run/until.h>

#include "lab_hand.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

TEST_CASE("a static scene that stands undeformed and paused says to press Space, and a click does it", "[unsolved]") {
    LabHand lab("elasticity/moduli");
    lab.session().playing = false;
    lab.session().reset();
    lab.frames(3);
    REQUIRE(lab.session().runner().place() == Place{});
    lab.click("solve");
    CHECK(lab.session().playing);
    lab.session().run(Until::at_rest());
    REQUIRE(lab.session().runner().place().step == 1);
    lab.state().controls.erase("solve");
    lab.frames(2);
    CHECK_FALSE(lab.state().controls.contains("solve"));
}

TEST_CASE("on a slide with a question, and in a lesson that moves, nothing says to press Space", "[unsolved]") {
    LabHand lab("elasticity/moduli");
    lab.session().start_walkthrough();
    lab.state().controls.erase("solve");
    lab.frames(3);
    REQUIRE(lab.session().runner().place() == Place{});
    CHECK_FALSE(lab.state().controls.contains("solve"));
    LabHand moving("mesh/mass_spring");
    moving.session().playing = false;
    moving.frames(3);
    CHECK_FALSE(moving.state().controls.contains("solve"));
}

TEST_CASE("a number that is not computed yet has no exact value beside it", "[unsolved]") {
    LabHand lab("elasticity/moduli");
    lab.session().playing = false;
    lab.session().reset();
    lab.frames(3);
    const auto& numbers = lab.state().held.key_numbers;
    const auto waits = [](const auto& number) { return !number.awaits.empty(); };
    const auto is_told = [](const auto& number) { return number.exact.has_value(); };
    CHECK(std::ranges::any_of(numbers, waits));
    for (const auto& number : numbers) CHECK_FALSE((waits(number) && is_told(number)));
    lab.session().run(Until::at_rest());
    lab.frames(3);
    CHECK(std::ranges::none_of(numbers, waits));
    CHECK(std::ranges::any_of(numbers, is_told));
}
