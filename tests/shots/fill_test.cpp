// One panel fills the screen, and all is as it was when it goes back.
#include "hand.h"

#include <pliant/math/error.h>

#include <imgui_internal.h>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

const Fill picture{Filled::picture, ""}, matrix{Filled::matrix, ""}, atlas{Filled::atlas, ""};

// The middle of what may fill the screen.
ImVec2 middle_of(Hand& hand, const Fill& what) {
    const auto& all = hand.lab.state().fillable;
    const auto found = std::ranges::find(all, what, &std::pair<Rectangle, Fill>::second);
    REQUIRE(found != all.end());
    const Rectangle& r = found->first;
    return {r.x + r.width / 2, r.y + r.height / 2};
}

Fill first_plot(Hand& hand) {
    const auto& all = hand.lab.state().fillable;
    const auto found = std::ranges::find_if(all, [](const auto& f) { return f.second.what == Filled::plot; });
    REQUIRE(found != all.end());
    return found->second;
}

bool zoomed(Hand& hand, const Fill& plot) {
    PlotState& plots = hand.lab.state().plots.memory;
    const std::string title = words(plot.plot) + "##" + plot.plot;
    return plots.of(ImHashStr(title.c_str(), 0, plots.place)).memory.x.fixed.has_value();
}

}  // namespace

TEST_CASE("X fills the screen with the plot under the mouse; Escape puts all back as it was", "[fill]") {
    for (const Layout layout : {Layout::lab, Layout::slide}) {
        Hand hand("mesh/mass_spring", {1280, 720}, Pixels::seen);
        LabState& s = hand.lab.state();
        hand.lab.set_layout(layout);
        hand.lab.session().run(Until::after_steps(20));
        hand.frames(4);
        const Fill plot = first_plot(hand);
        const ImVec2 at = middle_of(hand, plot);
        hand.move(at.x, at.y);
        hand.wheel(2);
        REQUIRE(zoomed(hand, plot));
        hand.frames(10);
        const Image before = hand.pixels();
        const Place place = s.session.runner().place();
        hand.key(ImGuiKey_X);
        CHECK(s.fill == plot);
        CHECK(s.layout == layout);
        CHECK(zoomed(hand, plot));
        CHECK(s.controls.at("filled").width == 1280);
        CHECK(compare(hand.pixels(), before, 40).fraction_over > 0.05);
        hand.key(ImGuiKey_Escape);
        CHECK_FALSE(s.fill);
        CHECK(s.layout == layout);
        CHECK(s.session.runner().place() == place);
        hand.frames(10);
        CHECK(compare(hand.pixels(), before).largest == 0);
        hand.key(ImGuiKey_X);
        hand.key(ImGuiKey_X);
        CHECK_FALSE(s.fill);
    }
}

TEST_CASE("every picture, plot and matrix that is seen can fill the screen, and the atlas by its menu", "[fill]") {
    Hand hand("elasticity/deformation_gradient", {1280, 800});
    LabState& s = hand.lab.state();
    hand.lab.session().run(Until::at_rest());
    hand.frames(3);
    std::vector<Fill> all;
    for (const auto& [place, what] : s.fillable) all.push_back(what);
    CHECK(std::ranges::count(all, picture) == 1);
    CHECK(std::ranges::count(all, matrix) >= 1);
    for (const Fill& what : all) {
        CAPTURE(text_of(what));
        CHECK(fill_from(text_of(what)) == what);
        const ImVec2 at = middle_of(hand, what);
        hand.move(at.x, at.y);
        // A matrix lies over the picture, and is meant where the mouse is over it.
        hand.key(ImGuiKey_X);
        CHECK(s.fill.what == what.what);
        hand.key(ImGuiKey_Escape);
        CHECK_FALSE(s.fill);
    }
    hand.click("menu View");
    hand.click("menu Fill the screen with");
    hand.frames(20);
    hand.click("menu fill atlas");
    CHECK(s.fill == atlas);
    CHECK(s.controls.contains("atlas make"));
    hand.click("fill back");
    CHECK_FALSE(s.fill);
}

TEST_CASE("a right click offers it, and the way back", "[fill]") {
    Hand hand("mesh/rod");
    LabState& s = hand.lab.state();
    const ImVec2 at = middle_of(hand, picture);
    hand.click(at.x, at.y, 1);
    hand.frames(20);
    hand.click("menu fill");
    CHECK(s.fill == picture);
    hand.click(at.x, at.y, 1);
    hand.frames(20);
    hand.click("menu fill");
    CHECK_FALSE(s.fill);
    CHECK_FALSE(s.session.camera);
}

TEST_CASE("in the deck the place stays, and the run goes on in what fills the screen", "[fill]") {
    Hand hand("elasticity/moduli");
    LabState& s = hand.lab.state();
    hand.lab.open_deck();
    hand.frames(4);
    REQUIRE(hand.lab.in_deck());
    const Fill plot = first_plot(hand);
    const ImVec2 at = middle_of(hand, plot);
    hand.move(at.x, at.y);
    hand.key(ImGuiKey_X);
    REQUIRE(s.fill == plot);
    hand.key(ImGuiKey_RightArrow);
    CHECK(s.session.walkthrough->revealed());
    CHECK(s.session.walkthrough->slide_number() == 0);
    CHECK(s.fill == plot);
    hand.key(ImGuiKey_Escape);
    CHECK_FALSE(s.fill);
    CHECK(hand.lab.in_deck());
    hand.key(ImGuiKey_X);
    REQUIRE(s.fill);
    hand.key(ImGuiKey_RightArrow);
    CHECK(s.session.walkthrough->slide_number() == 1);
    CHECK_FALSE(s.fill);
}

TEST_CASE("a plot that another scene lacks does not stay, and a name that means nothing is refused", "[fill]") {
    Hand hand("mesh/mass_spring");
    hand.lab.state().fill = {Filled::plot, "energy"};
    hand.frames(2);
    CHECK(hand.lab.state().fill);
    hand.lab.session().open(find_lesson("elasticity/poisson"));
    hand.frames(2);
    CHECK_FALSE(hand.lab.state().fill);
    CHECK_FALSE(fill_from(""));
    for (const char* text : {"plot", "plot ", "pictures", "Picture"}) CHECK_THROWS_AS(fill_from(text), Refused);
}
