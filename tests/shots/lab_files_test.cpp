// The lab without a window: scenes in and out of files and the clipboard, and what it exports.
#include "app/lab.h"

#include "../process/process.h"
#include "platform/png_file.h"

#include <pliant/document/share.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using namespace pliant::viewer;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;

namespace {

// A lab that runs in a folder of its own.
class Bench {
public:
    Bench() {
        fs::current_path(scratch.folder());
        lab.state().scene.hints_shown = false;
        frames(3);
    }
    ~Bench() { fs::current_path(before_); }
    void frames(int count) {
        for (int i = 0; i < count; ++i) lab.frame(0.01), context->present();
    }
    // As an entry of a menu.
    void choose(Action action) {
        lab.state().wanted.push_back(action);
        frames(1);
    }
    // Answers the dialog.
    void answer(const std::string& name) {
        REQUIRE(lab.state().files.asking());
        lab.state().files.name = name;
        lab.state().files.accept();
        frames(4);
    }
    std::string told() { return lab.session().message() ? lab.session().message()->text : ""; }

    Scratch scratch;
    std::unique_ptr<Context> context = open_headless({900, 600});
    Lab lab{*context, "mesh/mass_spring"};

private:
    fs::path before_ = fs::current_path();
};

}  // namespace

TEST_CASE("a scene dropped on the window opens and is remembered; anything else is refused in words", "[lab]") {
    Bench b;
    const std::string scene = b.scratch.file("s.json", R"({"pliant": 1, "lesson": "elasticity/moduli"})");
    b.lab.drop_file(scene);
    CHECK(b.lab.session().entry().info.id == "elasticity/moduli");
    CHECK(b.lab.state().file == scene);
    CHECK(b.lab.state().recent == std::vector<std::string>{scene});
    for (const std::string& other :
         {b.scratch.file("a.png", "\x89PNG\r\n"), b.scratch.folder().string(), b.scratch.path("none")}) {
        b.lab.drop_file(other);
        CHECK_THAT(b.told(), ContainsSubstring(other));
        CHECK(b.lab.session().message()->kind == Session::Message::Kind::refused);
        CHECK(b.lab.state().recent.size() == 1);
        CHECK(b.lab.session().entry().info.id == "elasticity/moduli");
    }
}

TEST_CASE("recent files: the latest first, each once, eight of them", "[lab]") {
    Bench b;
    std::vector<std::string> files;
    for (int i = 0; i < 10; ++i)
        files.push_back(b.scratch.file(std::to_string(i) + ".json", R"({"pliant": 1, "lesson": "elasticity/moduli"})"));
    for (const std::string& f : files) b.lab.drop_file(f);
    b.lab.drop_file(files[5]);
    const auto& recent = b.lab.state().recent;
    REQUIRE(recent.size() == most_recent);
    CHECK(recent[0] == files[5]);
    CHECK(recent[1] == files[9]);
    CHECK(std::ranges::count(recent, files[5]) == 1);
}

TEST_CASE("Ctrl S saves in the file of the scene, until another scene is opened", "[lab]") {
    Bench b;
    b.choose(Action::save);
    CHECK(fs::exists(b.scratch.path("mass_spring.scene.json")));
    CHECK(b.lab.state().file.empty());

    b.choose(Action::save_as);
    b.answer("mine");
    const std::string mine = b.scratch.path("mine.json");
    CHECK(b.lab.state().file == mine);
    CHECK(fs::exists(mine));
    fs::remove(mine);
    b.choose(Action::save);
    CHECK(fs::exists(mine));
    b.lab.session().open_next(1);
    b.frames(1);
    CHECK(b.lab.state().file.empty());
}

TEST_CASE("Ctrl O tells what is wrong with a file and stays", "[lab]") {
    Bench b;
    b.scratch.file("bad.json", R"({"pliant": 1, "lesson": "mesh/mass_sprong"})");
    b.scratch.file("good.json", R"({"pliant": 1, "lesson": "elasticity/moduli"})");
    b.choose(Action::open);
    b.answer("bad.json");
    CHECK(b.lab.state().files.asking());
    CHECK_THAT(b.lab.state().files.complaint(), ContainsSubstring("mesh/mass_spring"));
    b.answer("good.json");
    CHECK_FALSE(b.lab.state().files.asking());
    CHECK(b.lab.session().entry().info.id == "elasticity/moduli");
}

TEST_CASE("a share string is copied and pasted; other text is refused", "[lab]") {
    Bench b;
    Session& s = b.lab.session();
    s.assign(s.lesson().parameter("time_step"), 0.00075);
    b.choose(Action::copy_share);
    const std::string text = ImGui::GetClipboardText();
    CHECK(is_share(text));
    s.open_next(1);
    b.choose(Action::paste_share);
    CHECK(s.entry().info.id == "mesh/mass_spring");
    CHECK(s.lesson().parameter("time_step").value() == 0.00075);
    for (const char* wrong : {"", "hello", "pliant2:AAAA", "pliant1:!"}) {
        ImGui::SetClipboardText(wrong);
        s.dismiss();
        b.choose(Action::paste_share);
        CHECK(b.told() != "");
        CHECK(s.lesson().parameter("time_step").value() == 0.00075);
    }
}

TEST_CASE("pictures, plots and numbers are saved", "[lab]") {
    Bench b;
    for (int i = 0; i < 5; ++i) b.lab.session().step();
    b.choose(Action::save_window_picture);
    b.answer("window");
    CHECK(read_png(b.scratch.path("window.png")).width == 900);
    b.choose(Action::save_scene_picture);
    b.answer("scene");
    const Image scene = read_png(b.scratch.path("scene.png"));
    CHECK(scene.width == static_cast<int>(b.lab.state().controls["scene"].width));
    b.choose(Action::save_probes);
    b.answer("numbers");
    const std::string csv = contents_of(b.scratch.path("numbers.csv"));
    CHECK_THAT(csv, ContainsSubstring("step,time [s],energy [J]"));
    CHECK(std::ranges::count(csv, '\n') == 7);

    b.choose(Action::save_plots);
    b.frames(1);
    std::size_t plots = 0;
    for (const std::string& name : b.scratch.names())
        if (name.ends_with(".svg")) {
            ++plots;
            CHECK_THAT(contents_of(b.scratch.path(name)), ContainsSubstring("</svg>"));
        }
    CHECK(plots >= 2);
    CHECK_THAT(b.told(), ContainsSubstring(".svg"));
}

TEST_CASE("an animation is recorded while the run plays, and Escape gives it up", "[lab]") {
    Bench b;
    b.lab.session().speed = 0.1;
    b.lab.state().animation.seconds = 1;
    b.lab.state().animation.width = 480;
    const Real before = b.lab.session().runner().time();
    b.lab.state().animation.path = b.scratch.path("a.gif");
    b.frames(10);
    REQUIRE(b.lab.state().animation.progress.has_value());
    CHECK(*b.lab.state().animation.progress > 0.2);
    b.frames(14);
    for (int i = 0; i < 100 && b.lab.state().animation.progress; ++i) b.frames(1);
    CHECK_FALSE(b.lab.state().animation.progress.has_value());
    CHECK(contents_of(b.scratch.path("a.gif")).starts_with("GIF89a"));
    // 19 frames after the first, each 0.1/20 s later.
    CHECK(std::abs(b.lab.session().runner().time() - before - 0.095) < 0.0015);

    b.lab.state().animation.path = b.scratch.path("b.gif");
    b.frames(5);
    ImGui::GetIO().AddKeyEvent(ImGuiKey_Escape, true);
    b.frames(2);
    CHECK_FALSE(b.lab.state().animation.progress.has_value());
    CHECK_FALSE(fs::exists(b.scratch.path("b.gif")));
    CHECK_THAT(b.told(), ContainsSubstring("given up"));
}

TEST_CASE("another scene, opened over the deck, leaves the deck", "[lab]") {
    Bench b;
    b.lab.open_deck();
    b.frames(2);
    REQUIRE(b.lab.in_deck());
    b.lab.session().open_next(1);
    b.frames(3);
    CHECK(b.lab.session().entry().info.id != "mesh/mass_spring");
    CHECK(b.lab.state().layout == Layout::lab);
}
