// In a deck Space and the arrows play and turn slides, whatever control was clicked before; a control has the keys after Tab
// alone.
#include "app/lab.h"
#include "unseen.h"

#include <imgui.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>

using namespace pliant;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;

namespace {

class Lecturer {
public:
    explicit Lecturer(std::string_view lesson) : context_(test::open_unseen({1280, 720})), lab_(*context_, lesson) {
        lab_.open_deck();
        frames(4);
        REQUIRE(lab_.in_deck());
    }
    Lab& lab() { return lab_; }
    Session& session() { return lab_.session(); }
    std::size_t slide() { return session().walkthrough->slide_number() + 1; }
    bool revealed() { return session().walkthrough->revealed(); }
    Real value(std::string_view key) { return session().runner().wanted(session().lesson().parameter(key)); }
    bool ring() { return lab_.state().focus.has_value(); }

    void frames(int count) {
        for (int i = 0; i < count; ++i) lab_.frame(0), context_->present();
    }
    void press(ImGuiKey key) {
        ImGui::GetIO().AddKeyEvent(key, true);
        frames(2);
        ImGui::GetIO().AddKeyEvent(key, false);
        frames(3);
    }
    void type(char c) {
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
        frames(3);
    }
    void click(const std::string& control, float across = 0.5f) {
        REQUIRE(lab_.state().controls.contains(control));
        const Rectangle r = lab_.state().controls.at(control);
        ImGuiIO& io = ImGui::GetIO();
        io.AddMousePosEvent(r.x + across * r.width, r.y + r.height / 2);
        frames(2);
        io.AddMouseButtonEvent(0, true);
        frames(2);
        io.AddMouseButtonEvent(0, false);
        frames(3);
    }
    // To this slide, its answer still hidden.
    void go_to(std::size_t n) { session().go_to_slide(n - 1), frames(3); }

private:
    std::unique_ptr<Context> context_;
    Lab lab_;
};

}  // namespace

TEST_CASE("deck: the arrows turn slides and Space plays behind a click on a slider", "[deck]") {
    Lecturer it("mesh/mass_spring");
    it.go_to(5);
    REQUIRE(it.lab().state().controls.contains("time_step"));
    it.click("time_step", 0.3f);
    const Real dt = it.value("time_step");
    it.press(ImGuiKey_RightArrow);
    CHECK(it.revealed());
    CHECK_FALSE(it.ring());
    it.press(ImGuiKey_Space);
    CHECK(it.session().playing);
    it.press(ImGuiKey_Space);
    CHECK_FALSE(it.session().playing);
    it.press(ImGuiKey_RightArrow);
    CHECK(it.slide() == 6);
    it.press(ImGuiKey_LeftArrow);
    CHECK(it.slide() == 5);
    it.press(ImGuiKey_UpArrow), it.press(ImGuiKey_DownArrow);
    CHECK_FALSE(it.ring());
    it.press(ImGuiKey_RightArrow);
    CHECK(it.value("time_step") != dt);  // the slide has set its own, and no arrow has moved it since
    CHECK(it.value("time_step") == 5e-4);
}

TEST_CASE("deck: a list that is open does not keep the arrows", "[deck]") {
    Lecturer it("fluids/projection");
    it.go_to(5);
    it.click("solver");
    REQUIRE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup));
    it.press(ImGuiKey_RightArrow);
    CHECK(it.revealed());
    CHECK_FALSE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup));
    it.click("solver");
    it.press(ImGuiKey_Escape);
    CHECK(it.lab().in_deck());
    it.press(ImGuiKey_Escape);
    CHECK_FALSE(it.lab().in_deck());
    CHECK(it.lab().state().layout == Layout::lab);
}

TEST_CASE("deck: Tab gives a control the keys, which is seen and said; Escape gives them back before it leaves", "[deck]") {
    Lecturer it("elasticity/moduli");
    it.press(ImGuiKey_Tab);
    REQUIRE(ImGui::GetIO().WantTextInput);
    CHECK_THAT(it.lab().state().focus_words, ContainsSubstring("Enter") && ContainsSubstring("Escape"));
    it.press(ImGuiKey_RightArrow);
    CHECK_FALSE(it.revealed());
    it.press(ImGuiKey_Escape);
    CHECK(it.lab().in_deck());
    CHECK(it.lab().state().focus_words.empty());
    it.press(ImGuiKey_RightArrow);
    CHECK(it.revealed());
    it.press(ImGuiKey_Escape);
    CHECK_FALSE(it.lab().in_deck());
}

TEST_CASE("deck: the keys of lessons stay in it and say how to leave", "[deck]") {
    Lecturer it("mesh/rod");
    it.type(']');
    CHECK(it.lab().in_deck());
    CHECK(it.session().entry().info.id == "mesh/rod");
    REQUIRE(it.session().message());
    CHECK_THAT(it.session().message()->text, ContainsSubstring("Escape"));
}

TEST_CASE("deck: what was compared in the lab, or on the slide before, is not compared on a slide", "[deck]") {
    Lecturer it("fluids/projection");
    it.press(ImGuiKey_Escape);
    it.session().compare(Compare::swipe);
    it.lab().open_deck();
    it.frames(3);
    CHECK(it.session().inspector.compare == Compare::now);
    it.press(ImGuiKey_V);
    CHECK(it.session().inspector.compare == Compare::before);
    it.press(ImGuiKey_RightArrow);
    CHECK(it.session().inspector.compare == Compare::before);  // with the answer of the same slide
    it.press(ImGuiKey_RightArrow);
    CHECK(it.session().inspector.compare == Compare::now);
}
