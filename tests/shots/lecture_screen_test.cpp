// What lies over the whole screen in a lecture: the black-out, the lens around the pointer, the table of keys.
#include "app/settings.h"
#include "command_line/pictures.h"
#include "hand.h"
#include "panels/deck_panel.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

bool is_black(const Image& image) {
    return std::ranges::all_of(image.rgb, [](int level) { return level == 0; });
}

const std::uint8_t* pixel(const Image& image, int x, int y) { return image.row(y).data() + 3 * x; }

}  // namespace

TEST_CASE("B and the full stop of a remote control make the deck black; whatever is pressed next does nothing else", "[deck]") {
    Hand hand("elasticity/moduli", {1280, 720}, Pixels::seen);
    LabState& s = hand.lab.state();
    hand.lab.open_deck();
    hand.frames(4);
    const auto go_black = [&](bool by_letter) {
        if (by_letter)
            hand.key(ImGuiKey_B);
        else
            hand.type('.');
        REQUIRE(s.black);
        CHECK(is_black(hand.pixels()));
        hand.move(300, 300);
        hand.wheel(1);
        CHECK(s.black);
    };
    const auto unchanged = [&] {
        return s.session.walkthrough->slide_number() == 0 && !s.session.walkthrough->revealed() &&
               s.session.runner().place() == Place{};
    };
    for (const ImGuiKey lifts : {ImGuiKey_PageDown, ImGuiKey_B, ImGuiKey_Escape, ImGuiKey_Space}) {
        go_black(lifts == ImGuiKey_B);
        hand.key(lifts);
        CHECK_FALSE(s.black);
        CHECK_FALSE(is_black(hand.pixels()));
        CHECK(hand.lab.in_deck());
        CHECK(unchanged());
        CHECK_FALSE(s.session.playing);
    }
    go_black(true);
    hand.click(640, 360);
    CHECK_FALSE(s.black);
    CHECK_FALSE(s.session.camera);
    hand.key(ImGuiKey_PageDown);
    CHECK_FALSE(unchanged());
}

TEST_CASE("in the lab the same keys step and go back", "[deck]") {
    Hand hand("mesh/mass_spring");
    hand.lab.session().playing = false;
    hand.type('.');
    CHECK(hand.lab.session().runner().place().step == 1);
    hand.key(ImGuiKey_B);
    CHECK_FALSE(hand.lab.state().black);
}

TEST_CASE("the lens shows what lies under the pointer, enlarged, and nothing is left of it without the mouse", "[deck]") {
    Hand hand("mesh/mass_spring", {900, 600}, Pixels::seen);
    LabState& s = hand.lab.state();
    hand.lab.set_layout(Layout::slide);
    s.session.colours = {"velocity", -1};  // one colour for all that is at rest
    s.session.view_changed();
    hand.move(300, 300);
    hand.frames(30);
    const Image before = hand.pixels();
    hand.key(ImGuiKey_Z);
    REQUIRE(s.lens_shown);
    const Image with = hand.pixels();
    int alike = 0, all = 0;
    for (int dy = -60; dy <= 60; dy += 3)
        for (int dx = -60; dx <= 60; dx += 3, ++all) {
            const auto source = [](int d) { return static_cast<int>(std::lround(static_cast<float>(d) / Lens::enlargement)); };
            const std::uint8_t *shown = pixel(with, 300 + dx, 300 + dy),
                               *there = pixel(before, 300 + source(dx), 300 + source(dy));
            alike += std::abs(shown[0] - there[0]) + std::abs(shown[1] - there[1]) + std::abs(shown[2] - there[2]) < 60;
        }
    CHECK(alike > 0.75 * all);
    CHECK(compare(with, before, 10).fraction_over > 0.01);
    // Beyond the ring all is as it was.
    CHECK(compare(crop(with, 450, 0, 450, 600), crop(before, 450, 0, 450, 600)).largest == 0);
    CHECK(hand.lab.next_change() == std::numeric_limits<Real>::infinity());
    hand.key(ImGuiKey_Z);
    CHECK(compare(hand.pixels(), before).largest == 0);
}

TEST_CASE("the table of keys fits a small screen at a large scale, is searched, and closes", "[deck]") {
    Hand hand("mesh/mass_spring", {1280, 720}, Pixels::seen);
    LabState& s = hand.lab.state();
    hand.lab.set_scale(1.5f);
    hand.frames(3);
    hand.key(ImGuiKey_F1);
    REQUIRE(s.help_shown);
    const Rectangle r = hand.place("help");
    CHECK(r.x >= 0);
    CHECK(r.y >= 0);
    CHECK(r.x + r.width <= 1280);
    CHECK(r.y + r.height <= 720);
    // In both columns it says what the keys do.
    for (const int left : {220, 820}) {
        const Image column = crop(hand.pixels(), left, 110, 380, 550);
        int bright = 0;
        for (int y = 0; y < column.height; ++y)
            for (int x = 0; x < column.width; ++x) bright += pixel(column, x, y)[0] > 180;
        CHECK(bright > 0.02 * column.width * column.height);
    }
    for (const char c : std::string("black")) hand.type(c);
    CHECK(std::string(s.help.search.data()) == "black");
    CHECK(s.session.runner().place() == Place{});
    hand.key(ImGuiKey_Escape);
    CHECK_FALSE(s.help_shown);
    hand.key(ImGuiKey_F1);
    CHECK(s.help_shown);
    CHECK(std::string(s.help.search.data()).empty());
    hand.key(ImGuiKey_F1);
    CHECK_FALSE(s.help_shown);
}

TEST_CASE("a search finds keys by their name, by what they do and by their heading") {
    const auto has = [](std::string_view search, std::string_view meaning) {
        return std::ranges::any_of(key_rows(search),
                                   [&](const KeyRow& r) { return r.meaning.find(meaning) != std::string::npos; });
    };
    CHECK(has("F12", "lecturer"));
    CHECK(has("black screen", "black screen"));
    CHECK(has("two runs", "side by side"));
    CHECK_FALSE(has("black screen", "side by side"));
    CHECK(key_rows("no such word").empty());
    CHECK(key_rows("").size() == key_rows().size());
    for (const KeyRow& row : key_rows()) CHECK_FALSE(heading_of(row.group).empty());
}

TEST_CASE("the type of a deck follows the height of the picture; the lab's stays as it was chosen", "[deck]") {
    Hand hand("elasticity/moduli", {1920, 1080});
    LabState& s = hand.lab.state();
    CHECK(s.scale == 1);
    hand.lab.open_deck();
    hand.frames(4);
    CHECK(s.scale == 1.5f);
    CHECK(s.fonts.normal->FontSize == 22);  // px, whole
    CHECK(settings_of(s).scale == 1.f);
    hand.lab.set_scale(2);
    hand.frames(2);
    CHECK(s.scale == 2);
    hand.lab.set_scale(1);
    hand.lab.set_layout(Layout::lab);
    hand.frames(2);
    CHECK(s.scale == 1);
    CHECK(s.fonts.normal->FontSize == 15);
}

TEST_CASE("a slide that speaks of a light has the lights in its picture", "[deck]") {
    Hand hand("elasticity/energy_density");
    const auto lights = [&] {
        return std::ranges::any_of(hand.lab.state().controls, [](const auto& c) { return c.first.starts_with("light "); });
    };
    hand.lab.open_deck();
    hand.frames(4);
    CHECK_FALSE(lights());
    std::size_t with = 0;
    Session& s = hand.lab.session();
    for (std::size_t n = 0; n < s.slide_count(); ++n)
        for (const bool revealed : {false, true}) {
            show_slide(s, n, revealed);
            hand.lab.state().controls.clear();
            hand.frames(2);
            CHECK(lights() == slide_speaks_of_lights(hand.lab.state()));
            if (!revealed && s.walkthrough->slide().has(BlockKind::ask)) CHECK_FALSE(lights());
            with += lights();
        }
    CHECK(with > 0);
    CHECK(hand.lab.state().cut.empty());
}
