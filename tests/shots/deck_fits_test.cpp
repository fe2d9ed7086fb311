// What stands on a slide for a hall stands apart, and whole: on a small screen with large type too.
#include "command_line/pictures.h"
#include "hand.h"
#include "panels/deck_panel.h"
#include "platform/png_file.h"

#include <pliant/document/scene_file.h>
#include <pliant/lecture/lecture.h>

#include <fmt/format.h>
#include <imgui_internal.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace deck_fits {

namespace {

struct Screen {
    Size size;
    float scale;
};

// The two that halls have.
Screen small_or_large() { return GENERATE(Screen{{1280, 720}, 1.5f}, Screen{{1920, 1080}, 1.f}); }

bool lies_in(const Rectangle& inner, const Rectangle& outer) {
    constexpr float hair = 1;  // px
    return inner.x >= outer.x - hair && inner.y >= outer.y - hair && inner.x + inner.width <= outer.x + outer.width + hair &&
           inner.y + inner.height <= outer.y + outer.height + hair;
}

bool apart(const Rectangle& a, const Rectangle& b) {
    return a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
}

std::vector<std::pair<std::string, Rectangle>> lights(const Hand& hand) {
    std::vector<std::pair<std::string, Rectangle>> found;
    for (const auto& [name, place] : hand.lab.state().controls)
        if (name.starts_with("light ")) found.emplace_back(name, place);
    return found;
}

}  // namespace

TEST_CASE("the lights on a slide stand in rows, each name behind its mark", "[deck]") {
    const Screen screen = small_or_large();
    Hand hand("fluids/navier_stokes", screen.size);
    hand.lab.set_scale(screen.scale);
    hand.lab.state().layout = Layout::deck;
    show_slide(hand.lab.session(), 0, false);
    std::size_t most = 0;
    for (std::size_t n = 0; n < hand.lab.session().slide_count(); ++n) {
        show_slide(hand.lab.session(), n, true);
        hand.lab.state().controls.clear();
        hand.frames(2);
        const auto all = lights(hand);
        most = std::max(most, all.size());
        CHECK(all.size() == (slide_speaks_of_lights(hand.lab.state()) ? hand.lab.state().held.lights.size() : 0));
        for (const auto& [name, place] : all) {
            CAPTURE(n + 1, name);
            CHECK(lies_in(place, hand.place("scene")));
            CHECK(place.width > ImGui::CalcTextSize(name.c_str() + 6).x);
            for (const auto& [other, there] : all) CHECK((other == name || apart(place, there)));
        }
    }
    CHECK(most > 3);  // more than one row
}

namespace {

// How much of the words of the card lies outside of their part, px.
float hidden_words_of_card() {
    float hidden = -1;
    for (const ImGuiWindow* w : ImGui::GetCurrentContext()->Windows)
        if (w->Active && std::string_view(w->Name).find("autopsy words") != std::string_view::npos) hidden = w->ScrollMax.y;
    return hidden;
}

void check_card(Hand& hand) {
    Session& s = hand.lab.session();
    s.playing = true;
    for (int frame = 0; frame < 2000 && !s.autopsy(); ++frame) hand.lab.frame(0.02), hand.context->present();
    REQUIRE(s.autopsy());
    hand.lab.state().controls.clear();
    hand.frames(3);
    CHECK(hidden_words_of_card() == 0);
    const ImGuiWindow* scene = ImGui::FindWindowByName("Scene");
    const Rectangle card = hand.place("autopsy"), picture{scene->Pos.x, scene->Pos.y, scene->Size.x, scene->Size.y};
    CHECK(lies_in(card, picture));
    CHECK(card.height < 0.8f * picture.height);
    for (const char* button : {"fix", "autopsy back", "autopsy reset", "dismiss"}) CHECK(lies_in(hand.place(button), card));
}

}  // namespace

TEST_CASE("the card of a blow-up leaves some of the picture, and shows reason, number, bound and buttons", "[deck][autopsy]") {
    const Screen screen = small_or_large();
    Hand hand("mesh/mass_spring", screen.size, std::getenv("CARD_OUT") ? Pixels::seen : Pixels::unseen);
    hand.lab.set_scale(screen.scale);
    SECTION("on a slide") {
        hand.lab.open_lecture(read_lecture("soft_bodies"), 13);
        hand.frames(3);
        check_card(hand);
    }
    SECTION("in the lab") {
        hand.lab.session().open_scene(preset(find_lesson("mesh/mass_spring"), "explicit_blow_up"));
        hand.frames(3);
        check_card(hand);
    }
    if (const char* out = std::getenv("CARD_OUT"))
        write_png(hand.pixels(), fmt::format("{}/card_{}_{}.png", out, screen.size.width, hand.lab.in_deck() ? "deck" : "lab"));
}

namespace {

void press(Hand& hand, Action action) {
    hand.lab.state().wanted.push_back(action);
    hand.frames(3);
}

// Controls that are gone stay in the list, so it is made anew.
bool shows(Hand& hand, const std::string& control) {
    hand.lab.state().controls.clear();
    hand.frames(1);
    return hand.lab.state().controls.contains(control);
}

constexpr const char* map_and_scene = R"({"pliant_lecture": 1, "title": "Two", "slides": [
  {"title": "A block", "lesson": "mesh/mass_spring"},
  {"title": "Map", "text": "A spring.", "ask": "How long?", "lesson": "time/integration", "set": {"integrator": "semi_implicit_euler"},
   "atlas": ["time_step=0.01:1:8:log", "damping_ratio=0:1:8"]},
  {"title": "A rod", "lesson": "mesh/rod"}]})";

const ImGuiWindow* tip() {
    for (const ImGuiWindow* w : ImGui::GetCurrentContext()->Windows)
        if (w->Active && !w->Hidden && (w->Flags & ImGuiWindowFlags_Tooltip)) return w;
    return nullptr;
}

}  // namespace

TEST_CASE("the slide of a map has title, question and field, and keeps its map", "[deck][atlas][lecture]") {
    const Screen screen = small_or_large();
    Hand hand("elasticity/moduli", screen.size, std::getenv("CARD_OUT") ? Pixels::seen : Pixels::unseen);
    hand.lab.set_scale(screen.scale);
    hand.lab.open_lecture(parse_lecture(map_and_scene, "two.json"), 1);
    hand.frames(4);
    LabState& s = hand.lab.state();
    const Atlas& atlas = s.atlas.atlas;
    CHECK_FALSE(s.fill);
    CHECK(shows(hand, "atlas unmade"));
    CHECK_FALSE(s.controls.contains("atlas make"));
    const Rectangle field = hand.place("atlas unmade");
    const auto has_words = [] {
        return std::ranges::any_of(ImGui::GetCurrentContext()->Windows, [](const ImGuiWindow* w) {
            return w->Active && std::string_view(w->Name).starts_with("Slide words/words") && w->ContentSize.y > 0;
        });
    };
    CHECK(has_words());

    press(hand, Action::walkthrough_next);
    while (atlas.busy()) hand.frames(1);
    REQUIRE(shows(hand, "atlas map"));
    CHECK(has_words());
    CHECK_FALSE(s.controls.contains("atlas unmade"));
    const Rectangle map = hand.place("atlas map"), area = hand.place("atlas area");
    CHECK(map.width == field.width);
    CHECK(map.height == field.height);
    // Each corner of the map tells its cell, in sight.
    for (const auto& [x, y] : {std::pair{0.05f, 0.05f}, {0.95f, 0.05f}, {0.05f, 0.95f}, {0.95f, 0.95f}, {0.5f, 0.5f}}) {
        hand.move(area.x + x * area.width, area.y + y * area.height);
        hand.frames(3);
        REQUIRE(s.atlas.cell);
        const ImGuiWindow* told = tip();
        REQUIRE(told);
        CHECK(lies_in({told->Pos.x, told->Pos.y, told->Size.x, told->Size.y},
                      {0, 0, static_cast<float>(screen.size.width), static_cast<float>(screen.size.height)}));
    }
    hand.move(1, 1);

    for (const Action away : {Action::walkthrough_next, Action::walkthrough_back}) {
        press(hand, away);
        CHECK(hand.lab.session().slide_number() == (away == Action::walkthrough_next ? 2 : 0));
        CHECK_FALSE(atlas.map());
        press(hand, away == Action::walkthrough_next ? Action::walkthrough_back : Action::walkthrough_next);
        CHECK(hand.lab.session().slide_number() == 1);
        CHECK(shows(hand, "atlas map"));
        CHECK_FALSE(atlas.busy());
        CHECK(atlas.map()->complete);
    }
    if (const char* out = std::getenv("CARD_OUT")) write_png(hand.pixels(), fmt::format("{}/map_{}.png", out, screen.size.width));
}

}  // namespace deck_fits
