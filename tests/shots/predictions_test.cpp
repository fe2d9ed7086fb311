// Predictions at the desk and in the hall: entered by mouse and keys, compared with the run, kept to be handed in.
#include <pliant/document/hand_in.h>
#include <pliant/document/scene_file.h>

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

class Student {
public:
    explicit Student(std::string_view lesson, Layout layout = Layout::lab, Size size = {1280, 720}, float scale = 1)
        : context_(test::open_unseen(size)), lab_(*context_, lesson) {
        lab_.set_scale(scale);
        layout == Layout::deck ? lab_.open_deck() : session().start_walkthrough();
        frames(4);
    }
    Lab& lab() { return lab_; }
    Session& session() { return lab_.session(); }
    WalkthroughPlayer& player() { return *session().walkthrough; }
    void frames(int count) {
        for (int i = 0; i < count; ++i) lab_.frame(0), context_->present();
    }
    // To the slide of this title, its answer hidden.
    void go_to(std::string_view title) {
        const auto& slides = player().walkthrough().slides;
        const auto found = std::ranges::find(slides, title, &Slide::title);
        REQUIRE(found != slides.end());
        session().go_to_slide(static_cast<std::size_t>(found - slides.begin()));
        frames(6);
        REQUIRE(player().prediction());
    }
    Rectangle control(const std::string& name) {
        INFO(name);
        REQUIRE(lab_.state().controls.contains(name));
        return lab_.state().controls.at(name);
    }
    void drag(const std::string& name, ImVec2 from, ImVec2 to) {
        const Rectangle r = control(name);
        ImGuiIO& io = ImGui::GetIO();
        const auto move = [&](float part) {
            io.AddMousePosEvent(r.x + std::lerp(from.x, to.x, part) * r.width, r.y + std::lerp(from.y, to.y, part) * r.height);
            frames(2);
        };
        move(0);
        io.AddMouseButtonEvent(0, true);
        frames(2);
        for (int k = 1; k <= 8; ++k) move(static_cast<float>(k) / 8);
        io.AddMouseButtonEvent(0, false);
        frames(3);
    }
    void click(const std::string& name) { drag(name, {0.5f, 0.5f}, {0.5f, 0.5f}); }
    void press(ImGuiKey key) {
        ImGui::GetIO().AddKeyEvent(key, true);
        frames(2);
        ImGui::GetIO().AddKeyEvent(key, false);
        frames(3);
    }
    void write(const std::string& text) {
        ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
        frames(2);
    }
    void next() { session().walkthrough_next(), frames(6); }

private:
    std::unique_ptr<Context> context_;
    Lab lab_;
};

}  // namespace

TEST_CASE("a slide is set up when it is entered, and its answer waits", "[prediction]") {
    Student it("mesh/mass_spring");
    it.go_to("Implicit Euler");
    const Runner& r = it.session().runner();
    CHECK(r.wanted(r.lesson().parameter("time_step")) == 0.05);
    CHECK(r.place() == Place{});
    CHECK(it.session().hides("energy"));
    CHECK_FALSE(it.session().hides("height"));
    it.next();
    CHECK(r.place().step == 20);
    CHECK_FALSE(it.session().hides("energy"));
    // What was moved on the way is put right before the answer.
    it.session().reset_slide();
    it.session().step();
    it.next();
    CHECK(r.place().step == 20);
    for (const ExpectationResult& e : it.player().results()) CHECK(e.met);
}

TEST_CASE("a choice is made with the mouse in the lab, and by a show of hands in the deck", "[prediction]") {
    Student it("mesh/mass_spring");
    it.go_to("Implicit Euler");
    it.click("predict 3");
    CHECK(it.player().guess().option == 2u);
    it.click("walkthrough next");
    REQUIRE(it.player().verdict());
    CHECK(it.player().verdict()->right);
    CHECK_THAT(it.player().verdict()->words, ContainsSubstring("You were right"));

    Student lecturer("mesh/mass_spring", Layout::deck);
    lecturer.go_to("Implicit Euler");
    lecturer.press(ImGuiKey_2);
    CHECK(lecturer.player().guess().option == 1u);
    CHECK_FALSE(lecturer.session().companion());
    lecturer.press(ImGuiKey_1);
    CHECK(lecturer.player().guess().option == 0u);
    lecturer.press(ImGuiKey_RightArrow);
    REQUIRE(lecturer.player().verdict());
    CHECK_FALSE(lecturer.player().verdict()->right);
    CHECK_THAT(lecturer.player().verdict()->words, ContainsSubstring("All of it") && ContainsSubstring("Less than a tenth"));
}

TEST_CASE("a number is typed with its unit, and one that is none is refused in words", "[prediction]") {
    Student it("mesh/mass_spring");
    it.go_to("A chain and its frequencies");
    it.click("predict number");
    it.write("0.15 rad/s");
    it.press(ImGuiKey_Enter);
    CHECK(it.player().guess().number == 0.15);
    it.click("predict number");
    it.write("fast");
    it.press(ImGuiKey_Enter);
    REQUIRE(it.session().message());
    CHECK_THAT(it.session().message()->text, ContainsSubstring("'fast'") && ContainsSubstring("rad/s"));
    CHECK(it.player().guess().number == 0.15);
    it.next();
    REQUIRE(it.player().verdict());
    CHECK(it.player().verdict()->right);
}

TEST_CASE("a curve is drawn with the mouse or typed, and stands beside the one that is measured", "[prediction]") {
    for (const Layout layout : {Layout::lab, Layout::deck}) {
        Student it("mesh/mass_spring", layout);
        it.go_to("Explicit Euler");
        it.drag("predict sketch", {0.02f, 0.8f}, {0.98f, 0.2f});
        const Sketch drawn = it.player().guess().sketch;
        REQUIRE(drawn.size() == sketch_points);
        CHECK(drawn.front() < 4);
        CHECK(drawn.back() > 11);
        if (layout == Layout::lab) {
            it.click("predict curve");
            it.write("3.1, 5, 12");
            it.press(ImGuiKey_Enter);
            CHECK(it.player().guess().sketch.back() == 12);
        }
        it.next();
        CHECK(it.player().measured_curve().size() == sketch_points);
        REQUIRE(it.player().verdict());
        CHECK_THAT(it.player().verdict()->words, ContainsSubstring("on average"));
        CHECK(it.lab().state().controls.contains("verdict"));
    }
}

TEST_CASE("without a prediction Next goes on, and says what came", "[prediction]") {
    Student it("fluids/projection");
    it.go_to("A pressure that pushes back");
    it.next();
    REQUIRE(it.player().verdict());
    CHECK_FALSE(it.player().verdict()->right);
    CHECK_THAT(it.player().verdict()->words, ContainsSubstring("The run gives “A valley"));
    CHECK(it.session().notebook.hand_in().entries.empty());
}

TEST_CASE("question, entry and answer stand in the panel without scrolling, at every size", "[prediction]") {
    for (const auto& [size, scale] : {std::pair{Size{1280, 720}, 1.f}, {Size{1280, 720}, 1.5f}, {Size{1920, 1080}, 1.5f}}) {
        Student it("mesh/mass_spring", Layout::lab, size, scale);
        it.go_to("Implicit Euler");
        INFO(size.width << " x " << size.height << " scale " << scale);
        const Rectangle next = it.control("walkthrough next");
        for (const char* option : {"predict 1", "predict 2", "predict 3"}) {
            const Rectangle r = it.control(option);
            CHECK(r.y + r.height <= next.y);
        }
        it.next();
        const Rectangle verdict = it.control("verdict");
        CHECK(verdict.y + verdict.height <= next.y);
        CHECK(verdict.y >= 0);
    }
}

TEST_CASE("predictions, numbers and answers of several lessons are handed in, and come out again", "[prediction][handin]") {
    Student it("mesh/mass_spring");
    it.go_to("Implicit Euler");
    it.click("predict 3");
    it.next();
    it.session().note_number("energy");
    it.session().note_answer("It damps by itself.");
    it.session().open(find_lesson("fluids/projection"));
    it.session().run(Until::at_rest());
    it.session().note_number("cell_pressure");
    it.session().notebook.set_name("Ada");
    const HandInRead read = read_hand_in(hand_in_text(it.session().notebook.hand_in()), "h");
    REQUIRE(read.hand_in.entries.size() == 4);
    CHECK(read.unchanged);
    CHECK(read.hand_in.entries[0].kind == HandInEntry::Kind::prediction);
    CHECK(read.hand_in.entries[0].right);
    CHECK_THAT(read.hand_in.entries[2].question, ContainsSubstring("Steps of 50 ms"));
    for (const HandInFinding& f : check_hand_in(read.hand_in)) {
        INFO(f.words);
        CHECK(f.holds);
    }
    // The window: all that was noted, to be taken out again.
    it.press(ImGuiKey_H);
    it.frames(3);
    it.click("hand-in remove 1");
    CHECK(it.session().notebook.hand_in().entries.size() == 3);
    it.click("hand-in picture");
    it.frames(6);
    REQUIRE(it.session().notebook.hand_in().entries.size() == 4);
    CHECK(it.session().notebook.hand_in().entries.back().png.starts_with("iVBOR"));  // the signature of PNG
}

TEST_CASE("an answer in words stands beside that of the slide, and only who gave it judges it", "[prediction][handin]") {
    Student it("mesh/mass_spring");
    it.session().open_extension(0);
    it.frames(6);
    REQUIRE(it.player().prediction());
    REQUIRE(it.player().prediction()->kind == Prediction::Kind::words);
    it.click("predict words");
    it.write("Länger: sie");
    it.press(ImGuiKey_Space);  // a key of the run, but here a blank
    it.write(" fällt weit.");
    CHECK_FALSE(it.session().playing);
    it.press(ImGuiKey_Enter);
    CHECK(it.player().guess().words == "Länger: sie fällt weit.");
    CHECK_FALSE(it.lab().state().controls.contains("own verdict right"));
    it.click("walkthrough next");
    it.frames(6);
    REQUIRE(it.player().verdict());
    CHECK_THAT(it.player().verdict()->words, ContainsSubstring("You said: “Länger: sie fällt weit.”"));
    CHECK_FALSE(it.player().verdict()->right);
    REQUIRE(it.session().notebook.hand_in().entries.size() == 1);
    CHECK_FALSE(it.session().notebook.hand_in().entries[0].own_verdict);
    it.click("own verdict not right");
    it.click("own verdict right");
    CHECK(it.player().guess().was_right == true);
    // One entry, with both answers.
    REQUIRE(it.session().notebook.hand_in().entries.size() == 1);
    const HandInEntry e = it.session().notebook.hand_in().entries[0];
    CHECK(e.kind == HandInEntry::Kind::answer);
    CHECK(e.text == "Länger: sie fällt weit.");
    CHECK_FALSE(e.came.empty());
    CHECK(e.own_verdict == true);
}

TEST_CASE("a scene restores what was predicted on its slide", "[prediction]") {
    Student it("mesh/mass_spring");
    it.go_to("Implicit Euler");
    it.click("predict 2");
    const auto restored = [&] { return parse_scene(scene_text(it.session().scene_file()), "s.json"); };
    SceneFile scene = restored();
    it.session().open_scene(scene);
    it.frames(4);
    CHECK(it.player().guess().option == 1u);
    CHECK_FALSE(it.player().revealed());
    it.next();
    scene = restored();
    const std::size_t noted = it.session().notebook.hand_in().entries.size();
    it.session().open_scene(scene);
    it.frames(4);
    CHECK(it.player().guess().option == 1u);
    REQUIRE(it.player().verdict());
    CHECK_THAT(it.player().verdict()->words, ContainsSubstring("You predicted"));
    CHECK(it.session().notebook.hand_in().entries.size() == noted);
    scene.slide->predicted = {.words = "Something else"};
    it.session().open_scene(scene);
    REQUIRE(it.session().message());
    CHECK_THAT(it.session().message()->text, ContainsSubstring("another kind"));
}

TEST_CASE("a deck has no line for an answer in words: in a hall it is given aloud", "[prediction]") {
    Student it("mesh/mass_spring", Layout::deck);
    const auto& slides = it.player().walkthrough().slides;
    for (std::size_t n = 0; n < slides.size(); ++n) {
        it.session().go_to_slide(n);
        it.frames(2);
        CHECK_FALSE(it.lab().state().controls.contains("predict words"));
    }
}
