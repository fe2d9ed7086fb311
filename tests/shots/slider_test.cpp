// Sliders under a hand: drags, keys, wheel, undo; and the headings under which they stand.
#include "lab_hand.h"

#include <catch2/catch_test_macros.hpp>

#include <cmath>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

TEST_CASE("a press beside the grip brings it there, and a drag is one step of undo", "[lab]") {
    LabHand hand("time/integration");
    const Real before = hand.value("time_step");
    hand.move_onto("time_step", 0.2f);
    hand.button(true);
    const Real pressed = hand.value("time_step");
    CHECK(pressed < before);
    CHECK(pressed < 0.01);  // of a slider from 1 ms to 10 s that is logarithmic
    for (const float along : {0.3f, 0.4f, 0.8f}) hand.move_onto("time_step", along);
    hand.button(false);
    CHECK(hand.value("time_step") > 1);
    hand.session().undo();
    CHECK(hand.value("time_step") == before);
}

TEST_CASE("a press on the grip alone changes nothing", "[lab]") {
    LabHand hand("time/integration");
    const Parameter& dt = hand.session().lesson().parameter("time_step");
    hand.session().assign(dt, 0.0123456);
    hand.frames(2);
    const SliderScale scale(dt, false, 0.0123456);
    const Rectangle r = hand.place("time_step");
    const float grip = ImGui::GetStyle().GrabMinSize, margin = 2 + grip / 2;
    const float x = margin + (r.width - 2 * margin) * static_cast<float>(scale.place(0.0123456));
    hand.move(r.x + x, r.y + r.height / 2);
    hand.button(true), hand.button(false);
    CHECK(hand.value("time_step") == 0.0123456);
}

TEST_CASE("with Shift a drag goes a tenth of the way", "[lab]") {
    LabHand hand("mesh/mass_spring");
    const auto dragged_by = [&](bool fine) {
        hand.session().restore_defaults();
        hand.frames(40);  // else it is a double click
        hand.move_onto("time_step", 0.5f);
        hand.button(true);
        const Real from = std::log(hand.value("time_step"));
        if (fine) hand.hold(ImGuiMod_Shift, true);
        hand.move_onto("time_step", 0.5f, 40);
        hand.button(false);
        if (fine) hand.hold(ImGuiMod_Shift, false);
        return std::log(hand.value("time_step")) - from;
    };
    const Real plain = dragged_by(false), fine = dragged_by(true);
    CHECK(plain > 1);
    CHECK(std::abs(fine / plain - 0.1) < 0.03);
}

TEST_CASE("arrows go by a step on the slider that was used last, with Shift by less; whole numbers by 1", "[lab]") {
    LabHand hand("mesh/mass_spring");
    hand.session().playing = false;
    hand.click("time_step", 0.5f);
    const Real from = hand.value("time_step");
    hand.press(ImGuiKey_RightArrow);
    const Real coarse = hand.value("time_step") - from;
    CHECK(coarse > 0);
    hand.press(ImGuiKey_LeftArrow);
    CHECK(std::abs(hand.value("time_step") - from) < coarse);
    const Real here = hand.value("time_step");
    hand.hold(ImGuiMod_Shift, true);
    hand.press(ImGuiKey_RightArrow);
    hand.hold(ImGuiMod_Shift, false);
    const Real fine = hand.value("time_step") - here;
    CHECK(fine > 0);
    CHECK(fine < 0.3 * coarse);
    // Each press is one step of undo.
    hand.session().undo();
    CHECK(hand.value("time_step") == here);

    for (const Group group : all_groups) open_heading(hand.state(), hand.state().parameters, group, group == Group::shape);
    hand.frames(3);
    hand.session().assign(hand.session().lesson().parameter("cells_x"), 4);
    hand.frames(2);
    hand.state().focus.reset();
    hand.click("cells_x", 0.4f);
    const Real cells = hand.value("cells_x");
    hand.press(ImGuiKey_RightArrow);
    CHECK(hand.value("cells_x") == cells + 1);
}

TEST_CASE("the wheel with Alt sets the slider below the pointer, and without it scrolls", "[lab]") {
    LabHand hand("mesh/mass_spring", {1280, 720});
    hand.session().playing = false;
    const Real from = hand.value("time_step");
    hand.move_onto("time_step");
    const float y = hand.place("time_step").y;
    hand.hold(ImGuiMod_Alt, true);
    hand.frames(1);
    hand.wheel(1);
    hand.wheel(1);
    hand.hold(ImGuiMod_Alt, false);
    const Real up = hand.value("time_step");
    CHECK(up > from);
    CHECK(hand.place("time_step").y == y);
    hand.wheel(-1);
    CHECK(hand.value("time_step") == up);
    CHECK(hand.place("time_step").y < y);
    hand.wheel(3);
    hand.session().undo();
    CHECK(hand.value("time_step") == from);  // both notches of one go of the wheel
}

TEST_CASE("Space plays while the keys act on a slider", "[lab]") {
    LabHand hand("mesh/mass_spring");
    hand.session().playing = false;
    hand.click("time_step");
    hand.press(ImGuiKey_RightArrow);
    const bool before = hand.session().playing;
    hand.press(ImGuiKey_Space);
    CHECK(hand.session().playing != before);
}

TEST_CASE("a group is folded and opened by its heading, and what the scene does not use lies behind it", "[lab]") {
    LabHand hand("mesh/mass_spring");
    hand.session().playing = false;
    REQUIRE(hand.state().controls.contains("group method"));
    REQUIRE(hand.state().controls.contains("time_step"));
    hand.click("group method", 0.1f);
    hand.state().controls.clear();
    hand.frames(2);
    CHECK_FALSE(hand.state().controls.contains("time_step"));
    // The lesson's own choice comes back with a press, and with the lesson.
    hand.session().open(find_lesson("elasticity/moduli"));
    hand.frames(2);
    hand.session().open(find_lesson("mesh/mass_spring"));
    hand.state().controls.clear();
    hand.frames(2);
    CHECK_FALSE(hand.state().controls.contains("time_step"));
    hand.click("group method", 0.1f);
    CHECK(hand.state().controls.contains("time_step"));

    CHECK_FALSE(hand.state().controls.contains("test"));
    hand.click("unused scene", 0.1f);
    hand.frames(2);
    CHECK(hand.state().controls.contains("test"));
}

TEST_CASE("a slide that names a parameter shows it, whatever was folded", "[lab]") {
    LabHand hand("fluids/navier_stokes");
    for (const Group group : all_groups) open_heading(hand.state(), hand.state().parameters, group, false);
    hand.session().start_walkthrough();
    const auto& slides = hand.session().walkthrough->walkthrough().slides;
    int with_controls = 0;
    for (std::size_t n = 0; n < slides.size() && n < 4; ++n) {
        hand.session().go_to_slide(n);
        hand.state().controls.clear();
        hand.frames(2);
        for (const Parameter* p : hand.session().lesson().parameters) {
            if (!slides[n].has(BlockKind::controls) || hand.session().locked(*p) || !p->used()) continue;
            CAPTURE(n, p->info.key);
            CHECK(hand.state().controls.contains(std::string(p->info.key)));
            ++with_controls;
        }
    }
    CHECK(with_controls > 0);
}
