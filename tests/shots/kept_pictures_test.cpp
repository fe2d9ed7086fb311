// A picture is drawn by its lesson when something that it depends on has changed, and only then.
#include "app/lab.h"
#include "walker.h"

#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

// Pictures that the lesson draws on account of this.
template <class Action>
long drawn_by(Session& s, Action&& action) {
    s.picture(), s.other_picture(), s.picture_beside();
    const long before = s.pictures_drawn();
    action();
    for (int frame = 0; frame < 5; ++frame) s.picture(), s.other_picture(), s.picture_beside();
    return s.pictures_drawn() - before;
}

}  // namespace

TEST_CASE("a lab at rest draws its picture once", "[pictures]") {
    const auto context = open_unseen({640, 400});
    Lab lab(*context);
    for (const LessonEntry& entry : lessons()) {
        CAPTURE(entry.info.id);
        lab.session().open(entry);
        for (int i = 0; i < 3; ++i) lab.frame(0);
        const long before = lab.session().pictures_drawn();
        for (int i = 0; i < 5; ++i) lab.frame(0.02);
        CHECK(lab.session().pictures_drawn() == before);
    }
}

TEST_CASE("whatever changes a picture has it drawn again, once", "[pictures]") {
    Session s("mesh/mass_spring");
    const Parameter& stiffness = s.lesson().parameter("k_structural");
    CHECK(drawn_by(s, [] {}) == 0);
    CHECK(drawn_by(s, [&] { s.step(); }) == 1);
    CHECK(drawn_by(s, [&] { s.step_pass(); }) == 1);
    CHECK(drawn_by(s, [&] { s.step_back(); }) == 1);
    CHECK(drawn_by(s, [&] { s.assign(stiffness, stiffness.value() * 1.5); }) == 1);
    CHECK(drawn_by(s, [&] { s.undo(); }) == 1);
    CHECK(drawn_by(s, [&] { s.reset(); }) == 1);
    CHECK(drawn_by(s, [&] { s.colours = {"velocity", -1}, s.view_changed(); }) == 1);
    CHECK(drawn_by(s, [&] { s.colours.component = 1, s.view_changed(); }) == 1);
    CHECK(drawn_by(s, [&] { s.show_arrows = !s.show_arrows; }) == 1);
    CHECK(drawn_by(s, [&] { s.toggle_pin(); }) == 1);
    CHECK(drawn_by(s, [&] { s.toggle_pin(); }) == 1);
    CHECK(drawn_by(s, [&] { s.open_next(1); }) == 1);
    CHECK(drawn_by(s, [&] { s.speed = 2; }) == 0);
    CHECK(drawn_by(s, [&] { s.extreme = true; }) == 0);
}

TEST_CASE("a picture of before is kept as well, and looking back does not make that of now again", "[pictures]") {
    Session s("mesh/mass_spring");
    s.step();
    CHECK(drawn_by(s, [&] { s.compare(Compare::side_by_side); }) == 2);
    CHECK(drawn_by(s, [&] { s.step_stage(); }) == 2);
    CHECK(drawn_by(s, [] {}) == 0);
    CHECK(drawn_by(s, [&] { s.ask({.field = "velocity", .index = 0}); }) == 0);
}

TEST_CASE("the pictures of two runs are both kept", "[pictures]") {
    Session s("mesh/mass_spring");
    s.toggle_companion();
    CHECK(drawn_by(s, [&] { s.step(); }) == 2);
    CHECK(drawn_by(s, [] {}) == 0);
}

TEST_CASE("a pinned run lies under the picture from then on", "[pictures]") {
    Session s("mesh/mass_spring");
    const auto lines = s.scene().lines.size();
    s.toggle_pin();
    CHECK(s.scene().lines.size() > lines);
    s.toggle_pin();
    CHECK(s.scene().lines.size() == lines);
}
