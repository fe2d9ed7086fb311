// Numbers typed in the lab, through ImGui's own queue of events: read as the command line reads them, taken or refused in words,
// never cut off or clamped.
#include <pliant/lesson/setting_words.h>

#include "app/lab.h"
#include "unseen.h"

#include <imgui.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>

using namespace pliant;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;
using Told = Session::Message::Kind;

namespace {

class Typist {
public:
    explicit Typist(std::string_view lesson) : context_(test::open_unseen({1280, 900})), lab_(*context_, lesson) { frames(3); }

    Session& session() { return lab_.session(); }
    LabState& state() { return lab_.state(); }
    Real value(std::string_view key) { return session().runner().wanted(session().lesson().parameter(key)); }
    std::string told() { return session().message() ? session().message()->text : ""; }
    bool refused() { return session().message() && session().message()->kind == Told::refused; }

    void frames(int count) {
        for (int i = 0; i < count; ++i) lab_.frame(0), context_->present();
    }
    // Ctrl and a click on a control.
    void begin(const std::string& control) {
        session().dismiss();
        frames(2);
        REQUIRE(state().controls.contains(control));
        const Rectangle r = state().controls.at(control);
        ImGuiIO& io = ImGui::GetIO();
        io.AddMousePosEvent(r.x + r.width / 2, r.y + r.height / 2);
        frames(1);
        io.AddKeyEvent(ImGuiMod_Ctrl, true);
        io.AddMouseButtonEvent(0, true);
        frames(1);
        io.AddMouseButtonEvent(0, false);
        io.AddKeyEvent(ImGuiMod_Ctrl, false);
        frames(2);
        REQUIRE(io.WantTextInput);
    }
    void press(ImGuiKey key) {
        ImGui::GetIO().AddKeyEvent(key, true);
        frames(1);
        ImGui::GetIO().AddKeyEvent(key, false);
        frames(2);
    }
    void write(const std::string& text) {
        ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
        frames(2);
    }
    void type(const std::string& control, const std::string& text) {
        begin(control);
        write(text);
        press(ImGuiKey_Enter);
    }

private:
    std::unique_ptr<Context> context_;
    Lab lab_;
};

}  // namespace

TEST_CASE("a number typed at a slider is in the unit that is shown, unless it brings one", "[lab]") {
    Typist typist("time/integration");
    const Parameter& dt = typist.session().lesson().parameter("time_step");
    // Beside "20 ms".
    for (const char* text : {"50", "5e1", " 50,0 ", "0.05 s", "0,05 s", "5e-2 s", "50 ms", "50ms", "50000 µs"}) {
        CAPTURE(text);
        typist.session().assign(dt, 0.02);
        typist.type("time_step", text);
        CHECK(typist.value("time_step") == 0.05);
        CHECK(typist.value("time_step") == dt.parse(text, "ms"));
        CHECK(typist.told().empty());
        // One step of undo, however many keys it took.
        typist.session().undo();
        CHECK(typist.value("time_step") == 0.02);
    }
}

TEST_CASE("what is no number, or not in its unit, is refused in the words of the command line", "[lab]") {
    Typist typist("time/integration");
    const Parameter& dt = typist.session().lesson().parameter("time_step");
    const Real before = typist.value("time_step");
    for (const char* text : {"2*3", "0,5,1", "20 kg", "abc", "", "1,250", "nan", "1e400", "-1", "1e12"}) {
        CAPTURE(text);
        typist.begin("time_step");
        typist.press(ImGuiKey_Delete);  // what was there is selected
        typist.write(text);
        typist.press(ImGuiKey_Enter);
        CHECK(typist.value("time_step") == before);
        REQUIRE(typist.refused());
        std::string words;
        try {
            dt.parse(text, "ms");
        } catch (const Refused& e) {
            words = refusal_words(dt, e.what());  // by its name
        }
        CHECK(typist.told() == words);
        CHECK_THAT(words, ContainsSubstring("give ") || ContainsSubstring("accepted range"));
    }
}

TEST_CASE("a number outside the useful and inside the accepted range is taken, and the slider widens", "[lab]") {
    Typist typist("mesh/mass_spring");
    const Parameter& h = typist.session().lesson().parameter("mass");
    REQUIRE(h.info.useful.max < h.accepted().max);
    const Real beyond = h.info.useful.max + (std::min(h.accepted().max, 10 * h.info.useful.max) - h.info.useful.max) / 2;
    typist.type("mass", h.text(beyond));
    CHECK(typist.value("mass") == beyond);
    CHECK(typist.told().empty());
    // A frame later it is still there, and a drag reaches it.
    typist.frames(3);
    CHECK(typist.value("mass") == beyond);
    typist.type("mass", "1e300");
    CHECK(typist.value("mass") == beyond);
    CHECK(typist.refused());
    CHECK_THAT(typist.told(), ContainsSubstring("outside the accepted range"));
}

TEST_CASE("a whole number is not rounded in silence, and is shown without a point", "[lab]") {
    Typist typist("mesh/mass_spring");
    open_heading(typist.state(), typist.state().parameters, Group::shape, true);
    open_heading(typist.state(), typist.state().parameters, Group::material, false);
    typist.frames(3);
    typist.begin("cells_x");
    CHECK(std::string(typist.state().typed.text.data()) == "4");
    typist.press(ImGuiKey_Escape);
    const Real before = typist.value("cells_x");
    typist.type("cells_x", "2.5");
    CHECK(typist.value("cells_x") == before);
    CHECK_THAT(typist.told(), ContainsSubstring("not a whole number"));
    typist.type("cells_x", "2");
    CHECK(typist.value("cells_x") == 2);
}

TEST_CASE("the text begins with the value in full and its unit; Escape takes it back, going elsewhere enters it", "[lab]") {
    Typist typist("time/integration");
    const Parameter& dt = typist.session().lesson().parameter("time_step");
    typist.session().assign(dt, 0.012345678901);
    typist.begin("time_step");
    CHECK(std::string(typist.state().typed.text.data()) == "12.345678901 ms");
    typist.write("0.5");
    typist.press(ImGuiKey_Escape);
    CHECK(typist.value("time_step") == 0.012345678901);
    CHECK_FALSE(ImGui::GetIO().WantTextInput);
    typist.begin("time_step");
    typist.write("0,25 s");
    typist.press(ImGuiKey_Tab);
    CHECK(typist.value("time_step") == 0.25);
    // What it begins with is the same number, however often it is entered.
    for (const Real value : {0.012345678901, 1.0 / 3, 0.1 + 0.2, 7e-6}) {
        typist.session().assign(dt, value);
        typist.begin("time_step");
        typist.press(ImGuiKey_End);
        typist.write(" ");
        typist.press(ImGuiKey_Enter);
        CHECK(typist.value("time_step") == value);
    }
}

TEST_CASE("the other numbers that can be typed are not clamped either", "[lab]") {
    Typist typist("mesh/mass_spring");
    typist.session().run(Until::after_steps(50));
    typist.type("past", "20");
    CHECK(typist.session().runner().place() == Place{20, 0});
    for (const char* text : {"500", "2*3", "-1", "1.5"}) {
        CAPTURE(text);
        typist.type("past", text);
        CHECK(typist.session().runner().place() == Place{20, 0});
        CHECK(typist.refused());
        CHECK_THAT(typist.told(), ContainsSubstring("give a whole number from 0 to 50"));
    }
    typist.session().inspector.thing = Thing{On::node, 3};
    typist.state().side_wanted = SideTab::inspect;
    typist.frames(3);
    typist.type("thing index", "7");
    CHECK(typist.session().inspector.thing->index == 7);
    typist.type("thing index", "2*3");
    CHECK(typist.session().inspector.thing->index == 7);
    CHECK(typist.refused());
}
