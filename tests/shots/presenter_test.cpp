// What the page of the lecturer tells.
#include "app/presenter_view.h"
#include "hand.h"
#include "session/next_slide.h"
#include "waiting.h"

#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

TEST_CASE("the lecturer sees the notes, what the next press does, what comes then, and the numbers", "[deck]") {
    Hand hand("elasticity/moduli");
    const LabState& s = hand.lab.state();
    hand.lab.open_deck();
    hand.frames(4);
    PresenterView view = presenter_view(s);
    const Walkthrough& all = s.session.walkthrough->walkthrough();
    CHECK(view.in_deck);
    CHECK(view.number == 1);
    CHECK(view.count == all.slides.size());
    CHECK(view.title == all.slides[0].title);
    CHECK(view.next_title == all.slides[1].title);
    CHECK_FALSE(view.question.empty());
    CHECK_FALSE(view.answer.empty());
    CHECK(view.minutes == planned_minutes(all.slides[0].notes()));
    CHECK(view.minutes_so_far == view.minutes);
    CHECK(view.readings.size() >= 2);
    const std::string before = view.readings[0].number;

    hand.key(ImGuiKey_PageDown);
    view = presenter_view(s);
    CHECK(view.number == 1);
    CHECK(view.next_press == "turns to slide 2");
    CHECK(view.readings[0].number != before);

    hand.key(ImGuiKey_End);
    hand.key(ImGuiKey_PageDown);
    view = presenter_view(s);
    CHECK(view.number == view.count);
    CHECK(view.next_press == "nothing: this is the last slide");
    CHECK(view.next_title.empty());
    CHECK(view.minutes_so_far == view.minutes_in_all);
    hand.key(ImGuiKey_B);
    CHECK(presenter_view(s).black);
}

TEST_CASE("the audience sees no notes while the lecturer has a window for them", "[deck]") {
    Hand hand("elasticity/moduli");
    LabState& s = hand.lab.state();
    hand.lab.open_deck();
    hand.frames(4);
    hand.key(ImGuiKey_O);
    CHECK(s.controls.contains("notes"));
    s.controls.clear();
    hand.key(ImGuiKey_F12);
    s.controls.clear();
    hand.frames(2);
    CHECK_FALSE(s.controls.contains("notes"));
    hand.key(ImGuiKey_F12);
    CHECK(s.controls.contains("notes"));
}

TEST_CASE("a slide of a lecture has the minutes that the lecture plans", "[deck]") {
    Hand hand("elasticity/moduli");
    const Lecture lecture = read_lecture("soft_bodies");
    hand.lab.open_lecture(lecture, 1);
    hand.frames(4);
    const PresenterView view = presenter_view(hand.lab.state());
    CHECK(view.number == 2);
    CHECK(view.count == lecture.slides.size());
    CHECK(view.minutes == lecture.slides[1].minutes);
    CHECK(view.minutes_so_far == lecture.slides[0].minutes + lecture.slides[1].minutes);
    CHECK(view.minutes_in_all == lecture.minutes());
}

TEST_CASE("minutes are read from what notes begin with") {
    CHECK(planned_minutes("Three minutes. Ask first.") == 3);
    CHECK(planned_minutes("One minute.") == 1);
    CHECK(planned_minutes("Half a minute, no more.") == 0.5);
    CHECK(planned_minutes("12 minutes; a break behind it") == 12);
    for (const char* notes : {"", "Ask.", " minutes", "A few minutes.", "Wait three minutes."})
        CHECK_FALSE(planned_minutes(notes));
    CHECK(elapsed_text(0) == "0:00");
    CHECK(elapsed_text(754.9) == "12:34");
    CHECK(elapsed_text(3723) == "1:02:03");
}

TEST_CASE("the lecturer's page has a picture of the next slide, played once, and none of words alone", "[presenter]") {
    Session session("mesh/mass_spring");
    NextSlide next;
    next.make_now(session);
    CHECK_FALSE(next.preview().picture);  // no slides are open
    session.start_walkthrough();
    next.make_now(session);
    REQUIRE(next.preview().picture);
    CHECK(next.preview().picture->scene.points.size() + next.preview().picture->scene.lines.size() > 0);
    const long first = next.preview().picture->number;
    next.make_now(session);
    CHECK(next.preview().picture->number == first);
    session.go_to_slide(1);
    next.make_now(session);
    REQUIRE(next.preview().picture);
    CHECK(next.preview().picture->number != first);
    session.go_to_slide(session.slide_count() - 1);
    next.make_now(session);
    CHECK_FALSE(next.preview().picture);

    session.open_lecture(
        parse_lecture("# L\n\n## One\n\nA word.\n\n## Two\n\nWords.\n\n## Three\n\n```show\nlesson mesh/rod\n```\n", "l.md"));
    next.make_now(session);
    CHECK_FALSE(next.preview().picture);
    session.walkthrough_next();
    REQUIRE(session.slide_number() == 1);
    next.make_now(session);
    CHECK(next.preview().picture);

    // Beside the lab, in a thread of its own.
    NextSlide beside;
    CHECK(comes_true([&] {
        beside.follow(session);
        return beside.preview().picture != nullptr;
    }));
    CHECK_FALSE(beside.busy());
}
