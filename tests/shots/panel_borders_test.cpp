// The borders between panels, dragged by the mouse.
#include "app/lab.h"
#include "unseen.h"

#include <imgui.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <cmath>
#include <memory>
#include <string>

using namespace pliant;
using namespace pliant::viewer;

namespace {

struct Dragger {
    std::unique_ptr<Context> context = test::open_unseen({1920, 1000});
    Lab lab{*context, "mesh/mass_spring"};

    void frame() { lab.frame(0), context->present(); }
    void frames(int count) {
        for (int i = 0; i < count; ++i) frame();
    }
    Rectangle place(const std::string& control) { return lab.state().controls.at(control); }
    // The middle of a border, and the pointer on it.
    ImVec2 take(const std::string& border) {
        const Rectangle r = place(border);
        const ImVec2 at{r.x + r.width / 2, r.y + r.height / 2};
        ImGui::GetIO().AddMousePosEvent(at.x, at.y);
        frames(2);
        ImGui::GetIO().AddMouseButtonEvent(0, true);
        frame();
        return at;
    }
    void let_go() {
        ImGui::GetIO().AddMouseButtonEvent(0, false);
        frames(2);
    }
    float scene_width() { return place("scene").width; }
};

}  // namespace

TEST_CASE("a border that is dragged moves what stands at both sides in the same frame", "[session][borders]") {
    Dragger hand;
    hand.lab.set_scale(GENERATE(1.f, 1.5f));
    hand.frames(4);
    const Rectangle scene = hand.place("scene");
    for (const auto& [border, sign] : {std::pair{"border left", -1.f}, {"border right", 1.f}}) {
        const float before = hand.scene_width();
        const ImVec2 at = hand.take(border);
        for (const float by : {10.f, 25.f}) {
            ImGui::GetIO().AddMousePosEvent(at.x + by, at.y);
            hand.frame();
            INFO(border << " by " << by);
            CHECK(std::abs(hand.scene_width() - before - sign * by) < 1);
        }
        hand.let_go();
        CHECK(std::abs(hand.scene_width() - before - sign * 25) < 1);
    }
    CHECK(hand.lab.state().sizes.left);
    // A double click puts both back.
    for (const char* border : {"border left", "border right"}) {
        hand.take(border), hand.let_go();
        ImGui::GetIO().AddMouseButtonEvent(0, true);
        hand.frame();
        hand.let_go();
    }
    CHECK(hand.lab.state().sizes == PanelSizes{});
    CHECK(std::abs(hand.scene_width() - scene.width) < 1);
}

TEST_CASE("no panel is dragged away", "[session][borders]") {
    Dragger hand;
    hand.frames(3);
    const std::string border = GENERATE("border left", "border right", "border lessons");
    for (const float far : {-5000.f, 5000.f}) {
        const ImVec2 at = hand.take(border);
        ImGui::GetIO().AddMousePosEvent(at.x + far, at.y + far);
        hand.frames(2);
        hand.let_go();
        INFO(border << " by " << far);
        CHECK(hand.place("scene").width > 200);
        CHECK(hand.place("integrator").width > 100);
        CHECK(hand.place("tab plots").x + 100 < 1920);
    }
}

TEST_CASE("the border of the slide layout and that below a slide can be dragged", "[session][borders]") {
    Dragger hand;
    hand.lab.set_layout(Layout::slide);
    hand.frames(3);
    const float before = hand.scene_width();
    const ImVec2 at = hand.take("border plots");
    ImGui::GetIO().AddMousePosEvent(at.x - 60, at.y);
    hand.frame();
    CHECK(std::abs(hand.scene_width() - before + 60) < 1);
    hand.let_go();
    CHECK(hand.lab.state().sizes.plots);
    CHECK_FALSE(hand.lab.state().sizes.right);
}
