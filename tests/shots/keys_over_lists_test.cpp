// Who has a key: a list that is open, a control that keys went to, a window over the lab, a choice that waits; else the lab.
#include "lab_hand.h"
#include "panels/lesson_list.h"

#include <cmath>
#include <string>

using namespace pliant;
using namespace pliant::viewer;
using namespace pliant::test;

namespace {

// A letter or a digit, as a keyboard gives it: the key and what it types.
void type(LabHand& hand, ImGuiKey key, char character) {
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(character));
    hand.press(key);
}

}  // namespace

TEST_CASE("Space plays when a panel came up with its control marked; what keys went to has it", "[keys]") {
    LabHand hand("mesh/mass_spring");
    Session& s = hand.session();
    s.playing = false;
    hand.press(ImGuiKey_W);
    hand.frames(6);
    REQUIRE(hand.state().focus);
    hand.press(ImGuiKey_Space);
    CHECK(s.playing);
    CHECK_FALSE(list_is_open());
    hand.press(ImGuiKey_Space);
    CHECK_FALSE(s.playing);
    // Keys go on from there: Space opens, presses or ticks what they are at.
    hand.press(ImGuiKey_DownArrow);
    hand.frames(4);
    REQUIRE(hand.state().focus);
    hand.press(ImGuiKey_Space);
    CHECK_FALSE(s.playing);
}

TEST_CASE("what is typed over an open list is no key of the lab", "[keys]") {
    LabHand hand("mesh/mass_spring");
    Session& s = hand.session();
    s.playing = false;
    const bool arrows = s.show_arrows;
    hand.click("compare");
    hand.frames(3);
    REQUIRE(list_is_open());
    type(hand, ImGuiKey_2, '2');
    type(hand, ImGuiKey_A, 'a');
    type(hand, ImGuiKey_Slash, '/');
    CHECK_FALSE(s.companion());
    CHECK(s.show_arrows == arrows);
    CHECK_FALSE(s.runner().inside_step());
    hand.press(ImGuiKey_Escape);
    hand.frames(3);
    REQUIRE_FALSE(list_is_open());
    // The mouse opened it: Space is the lab's again.
    hand.press(ImGuiKey_Space);
    CHECK(s.playing);
    type(hand, ImGuiKey_A, 'a');
    CHECK(s.show_arrows != arrows);
}

TEST_CASE("beside the panel of a walkthrough the digits choose; else 2 opens a second run", "[keys]") {
    LabHand hand("time/integration");
    Session& s = hand.session();
    s.start_walkthrough();
    hand.frames(4);
    const auto waits = [&] {
        const auto& p = s.walkthrough->prediction();
        return p && p->kind == Prediction::Kind::choice && !s.walkthrough->revealed();
    };
    for (int k = 0; k < 40 && !waits(); ++k) s.walkthrough_next(), hand.frames(2);
    REQUIRE(waits());
    type(hand, ImGuiKey_2, '2');
    CHECK(s.walkthrough->guess().option == 1);
    CHECK(hand.told().empty());
    CHECK_FALSE(s.companion());
    s.end_walkthrough();
    hand.frames(3);
    type(hand, ImGuiKey_2, '2');
    CHECK(s.companion());
}

TEST_CASE("Escape closes the window to hand in, from a field too, and letters typed over it are not the lab's", "[keys]") {
    LabHand hand("mesh/mass_spring");
    Session& s = hand.session();
    s.playing = false;
    const bool arrows = s.show_arrows;
    type(hand, ImGuiKey_H, 'h');
    hand.frames(3);
    REQUIRE(hand.state().hand_in.shown);
    type(hand, ImGuiKey_A, 'a');
    CHECK(s.show_arrows == arrows);
    hand.press(ImGuiKey_Escape);
    CHECK_FALSE(hand.state().hand_in.shown);
    type(hand, ImGuiKey_H, 'h');
    hand.frames(3);
    hand.click("hand-in answer");
    for (const char c : {'n', 'o'}) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
    hand.frames(3);
    hand.press(ImGuiKey_Escape);
    hand.frames(3);
    CHECK_FALSE(hand.state().hand_in.shown);
    CHECK(std::string(hand.state().hand_in.answer.data()) == "no");
    type(hand, ImGuiKey_A, 'a');
    CHECK(s.show_arrows != arrows);
}

TEST_CASE("the window of the stops opens at its button, wherever the mouse is, and Clear all takes the last stop away",
          "[keys]") {
    LabHand hand("mesh/mass_spring");
    Session& s = hand.session();
    s.playing = false;
    hand.move(10, 10);
    s.inspector.stopped = "before integrate";
    hand.press(ImGuiKey_F9);
    hand.frames(4);
    const Rectangle button = hand.place("breaks"), clear = hand.place("clear breaks");
    CHECK(clear.x >= button.x - 1);
    CHECK(clear.x < button.x + 60);
    CHECK(hand.place("break " + std::string(s.runner().stages().front()->name)).y < button.y + button.height + 100);
    CHECK(clear.y + clear.height > button.y);
    hand.click("clear breaks");
    CHECK(s.inspector.stopped.empty());
}

TEST_CASE("a search finds titles and ids before summaries; the arrows mark, Enter opens what is marked", "[keys]") {
    const auto first = [](std::string_view search) { return std::string(found_lessons(search).at(0)->info.id); };
    CHECK(first("projection") == "fluids/projection");
    CHECK(first("mass") == "mesh/mass_spring");
    CHECK(first("mass spring") == "mesh/mass_spring");
    CHECK(found_lessons("").size() == lessons().size());
    for (const LessonEntry& e : lessons()) CHECK(first(e.info.id) == e.info.id);

    const auto found = found_lessons("mass");
    REQUIRE(found.size() > 1);
    LabHand hand("elasticity/moduli");
    const auto search = [&](int down) {
        hand.press(ImGuiKey_F);
        hand.frames(3);
        for (const char c : std::string("mass")) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
        hand.frames(10);
        for (int k = 0; k < down; ++k) hand.press(ImGuiKey_DownArrow);
        hand.press(ImGuiKey_Enter);
        hand.frames(4);
        return hand.session().entry().info.id;
    };
    CHECK(search(1) == found[1]->info.id);
    CHECK(search(0) == found[0]->info.id);
}
