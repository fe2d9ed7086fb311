// Looking never changes a run: whatever is clicked, hovered, opened or asked, it stands where it stood, with the same bits.
#include "../every_lesson.h"
#include "app/lab.h"
#include "unseen.h"

#include <imgui.h>
#include <catch2/catch_test_macros.hpp>

#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

// What looking leaves alone.
struct Standing {
    Place place, reach;
    std::uint64_t state = 0;
    int runs = 0, opened = 0;
    bool playing = false, undo = false;
    std::optional<Camera> camera{};
    bool turned = false;
    std::vector<Real> parameters{};  // but those that only look
    std::size_t events = 0;
    bool operator==(const Standing&) const = default;
};

class Watcher {
public:
    explicit Watcher(std::string_view lesson, Size size = {1280, 720}) : context_(open_unseen(size)), lab(*context_, lesson) {
        draw(3);
    }
    void draw(int frames = 2) {
        for (int i = 0; i < frames; ++i) lab.frame(1.0 / 60), context_->present();
    }
    Session& session() { return lab.session(); }

    Standing standing() {
        Session& s = session();
        Standing now{.place = s.runner().place(),
                     .reach = s.runner().reach(),
                     .state = state_hash(s.lesson()),
                     .runs = s.run_count(),
                     .opened = s.open_count(),
                     .playing = s.playing,
                     .undo = s.can_undo(),
                     .camera = s.camera,
                     .turned = s.viewpoint.turned(),
                     .events = s.runner().recording().events().size()};
        for (const Parameter* p : s.lesson().parameters)
            if (!p->looks()) now.parameters.push_back(s.runner().wanted(*p));
        return now;
    }
    void move_to(float x, float y) {
        ImGui::GetIO().AddMousePosEvent(x, y);
        draw();
    }
    void click(float x, float y, int button = 0) {
        move_to(x, y);
        for (const bool down : {true, false}) {
            ImGui::GetIO().AddMouseButtonEvent(button, down);
            draw();
        }
    }
    void click(const std::string& control, int button = 0) {
        const auto found = lab.state().controls.find(control);
        if (found == lab.state().controls.end()) return;
        const Rectangle r = found->second;
        click(r.x + r.width / 2, r.y + r.height / 2, button);
    }
    void escape() {
        for (const bool down : {true, false}) {
            ImGui::GetIO().AddKeyEvent(ImGuiKey_Escape, down);
            draw();
        }
    }

private:
    std::unique_ptr<Context> context_;

public:
    Lab lab;
};

// Inside a step where there is one, with a camera of the person's own.
void stand_inside(Watcher& w) {
    Session& s = w.session();
    s.step();
    s.step_stage();
    w.draw();
    Camera& own = s.own_camera();
    own.distance *= 1.1, own.yaw += 0.2;
    w.draw();
    s.dismiss();
}

// Calls look for each kind of looking, and checks after each.
template <class Look>
void check_after(Watcher& w, const std::string& what, const Look& look) {
    const Standing before = w.standing();
    look();
    w.draw();
    const Standing after = w.standing();
    INFO(what);
    CHECK(after.place == before.place);
    CHECK(after.camera == before.camera);
    CHECK(after.runs == before.runs);
    REQUIRE(after == before);
    w.session().dismiss();
}

void look_over_picture(Watcher& w) {
    constexpr int places = 7;
    for (int i = 0; i < places; ++i)
        for (int j = 0; j < places; ++j) {
            const Rectangle r = w.lab.state().controls.at("scene");
            const float x = r.x + (static_cast<float>(i) + 0.5f) / places * r.width,
                        y = r.y + (static_cast<float>(j) + 0.5f) / places * r.height;
            check_after(w, "the pointer over the picture", [&] { w.move_to(x, y); });
            // A click on an offer of the lab is no look at the picture.
            bool covered = false;
            for (const auto& [name, c] : w.lab.state().controls)
                covered = covered || (name != "scene" && name != "scene B" && !name.starts_with("handle") && x >= c.x &&
                                      x < c.x + c.width && y >= c.y && y < c.y + c.height);
            if (!covered) check_after(w, "a click on the picture", [&] { w.click(x, y); });
        }
    for (std::size_t i = 0;; ++i) {
        const std::string handle = "handle " + std::to_string(i);
        if (!w.lab.state().controls.contains(handle)) break;
        check_after(w, handle, [&] { w.click(handle); });
    }
}

void ask_everything(Watcher& w) {
    Session& s = w.session();
    std::vector<Inspector::Asked> questions;
    for (const Field& f : s.lesson().fields)
        if (f.in_use() && f.size() > 0)
            for (int c = -1; c < f.components; ++c)
                questions.push_back({.field = std::string(f.name), .index = f.size() / 3, .component = c});
    for (const Probe& p : s.lesson().probes) questions.push_back({.field = "probe:" + std::string(p.name)});
    for (const Inspector::Asked& q : questions) check_after(w, "a question for " + q.field, [&] { s.ask(q); });
    check_after(w, "back to the question before", [&] { w.lab.perform(Action::why_back); });
}

}  // namespace

TEST_CASE("every lesson: no click, hover, layout or question changes the run, or turns the camera",
          "[shots][looking][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        CAPTURE(entry.info.id);
        Watcher w(entry.info.id);
        Session& s = w.session();
        stand_inside(w);
        for (const Action action :
             {Action::hide_panels,    Action::hide_panels, Action::compare,  Action::compare, Action::compare, Action::compare,
              Action::compare,        Action::patterns,    Action::patterns, Action::arrows,  Action::arrows,  Action::theme,
              Action::theme,          Action::larger,      Action::smaller,  Action::cost,    Action::cost,    Action::help,
              Action::help,           Action::summary,     Action::dismiss,  Action::extreme, Action::extreme, Action::find,
              Action::stops,          Action::menu,        Action::inspect,  Action::claims,  Action::atlas,   Action::next_panel,
              Action::previous_panel, Action::pin,         Action::pin}) {
            check_after(w, "action " + std::to_string(static_cast<int>(action)), [&] { w.lab.perform(action); });
            if (action == Action::stops || action == Action::menu || action == Action::find) w.escape();
        }
        for (const char* control : {"tab plots", "tab inspect", "tab claims", "tab atlas", "tab plots", "hide hints"})
            check_after(w, control, [&] { w.click(control); });
        for (const Stage* stage : s.runner().stages())
            check_after(w, "a right click on a stage", [&] { w.click("stage " + std::string(stage->name), 1); });
        s.compare(Compare::now);
        for (const Field& f : s.lesson().fields)
            check_after(w, "colours", [&] { s.colours = {std::string(f.name), -1}, s.range = {}, s.view_changed(); });
        look_over_picture(w);
        ask_everything(w);

        // And it goes on as one that nobody has looked at.
        s.step();
        s.step();
        Session alone(entry.info.id);
        alone.step();
        alone.step_stage();
        alone.step();
        alone.step();
        CHECK(state_hash(s.lesson()) == state_hash(alone.lesson()));
    }
}

TEST_CASE("two runs beside each other: looking at them changes neither, nor the camera", "[shots][looking]") {
    Watcher w("mesh/mass_spring");
    Session& s = w.session();
    Camera& own = s.own_camera();
    own.yaw += 0.3, own.distance *= 0.9;
    const Camera chosen = own;
    s.toggle_companion();
    CHECK(s.camera == chosen);
    s.assign(s.companion()->lesson().parameter("k_structural"), 300);
    s.step();
    w.draw();
    // Half the room shows all that the whole showed: the camera stands farther away, and turns nowhere.
    CHECK(s.seen_by().distance > chosen.distance);
    CHECK(s.seen_by().yaw == chosen.yaw);
    const auto b = state_hash(s.companion()->lesson());
    const auto check = [&](const std::string& what, const auto& look) {
        check_after(w, what, look);
        CHECK(state_hash(s.companion()->lesson()) == b);
    };
    check("A − B", [&] { s.show_difference(true); });
    check("both again", [&] { s.show_difference(false); });
    check("the sliders of B", [&] { s.address(true); });
    check("a slide", [&] { w.lab.set_layout(Layout::slide); });
    check("the lab", [&] { w.lab.set_layout(Layout::lab); });
    s.close_companion();
    w.draw();
    CHECK(s.seen_by() == chosen);
}
