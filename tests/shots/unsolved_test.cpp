// A static lesson that nothing was solved of yet says what to do.
#include <pliant/run/until.h>

#include "lab_hand.h"

#include <catch2/catch_test_macros.hpp>

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
