// Every control has its place: none is cut off by its panel or lies under another, at the sizes of projectors and small screens.
#include "../every_lesson.h"
#include "app/lab.h"
#include "unseen.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

struct Screen {
    Size size;
    float scale;
};
const Screen screens[]{{{1280, 720}, 1.5f}, {{1920, 1080}, 1.5f}, {{1280, 720}, 1}};

bool overlap(const Rectangle& a, const Rectangle& b) {
    constexpr float hair = 1;  // px
    return a.x + hair < b.x + b.width && b.x + hair < a.x + a.width && a.y + hair < b.y + b.height && b.y + hair < a.y + a.height;
}

class Screened {
public:
    Screened(const Screen& s, std::string_view lesson) : screen(s), context_(open_unseen(s.size)), lab(*context_, lesson) {
        lab.set_scale(s.scale);
        draw();
    }
    void draw(int frames = 4) {
        for (int i = 0; i < frames; ++i) lab.state().controls.clear(), lab.frame(0), context_->present();
    }
    // Names of controls that no hand reaches as they should be reached.
    std::vector<std::string> lost() {
        draw();
        const auto& controls = lab.state().controls;
        std::vector<std::string> names;
        for (const std::string& name : lab.state().cut)
            if (is_bar(name)) names.push_back(name + " (cut off)");
        for (const auto& [name, r] : controls)
            if (is_bar(name) && (r.x < -1 || r.y < -1 || r.x + r.width > static_cast<float>(screen.size.width) + 1 ||
                                 r.y + r.height > static_cast<float>(screen.size.height) + 1))
                names.push_back(name + " (outside)");
        for (const auto& [a, of_a] : controls)
            for (const auto& [b, of_b] : controls)
                if (a < b && is_bar(a) && is_bar(b) && overlap(of_a, of_b)) names.push_back(a + " over " + b);
        return names;
    }

    const Screen screen;

private:
    // Controls that stand still, each in a place of its own.
    bool is_bar(const std::string& name) {
        // A parameter may bear the name of a control.
        const auto& parameters = lab.session().lesson().parameters;
        if (std::ranges::any_of(parameters, [&](const Parameter* p) { return p->info.key == name; })) return false;
        constexpr const char* names[]{"play",        "pass",        "stage",      "step",      "stage back", "back",
                                      "reset",       "pin",         "speed",      "colour",    "auto range", "arrows",
                                      "smooth",      "beside",      "run A",      "run B",     "difference", "plots",
                                      "tab plots",   "tab inspect", "tab claims", "tab atlas", "search",     "presets",
                                      "walkthrough", "extreme",     "breaks",     "past",      "compare",    "hide hints"};
        return std::ranges::find(names, name) != std::end(names);
    }

    std::unique_ptr<Context> context_;

public:
    Lab lab;
};

void check(Screened& s, const std::string& what) {
    const std::vector<std::string> lost = s.lost();
    std::string all;
    for (const std::string& name : lost) all += name + ", ";
    INFO(what << " at " << s.screen.size.width << "x" << s.screen.size.height << " scale " << s.screen.scale << ": " << all);
    CHECK(lost.empty());
}

}  // namespace

TEST_CASE("every lesson: all controls fit into every layout, on small screens too", "[shots][fits][every_lesson]") {
    for (const LessonEntry& entry : every_lesson())
        for (const Screen& screen : screens) {
            CAPTURE(entry.info.id);
            Screened s(screen, entry.info.id);
            Session& session = s.lab.session();
            session.step();
            check(s, "lab");
            for (const SideTab tab : {SideTab::inspect, SideTab::claims, SideTab::atlas, SideTab::plots}) {
                s.lab.state().side_wanted = tab;
                check(s, "tab");
            }
            session.toggle_companion();
            check(s, "two runs");
            s.lab.set_layout(Layout::slide);
            check(s, "slide of two runs");
            session.close_companion();
            check(s, "slide");
        }
}

TEST_CASE("every lesson: all controls of its deck fit", "[shots][fits][slow][every_lesson]") {
    for (const LessonEntry& entry : every_lesson())
        for (const Screen& screen : screens) {
            CAPTURE(entry.info.id);
            Screened s(screen, entry.info.id);
            s.lab.open_deck();
            const std::size_t count = s.lab.session().walkthrough->walkthrough().slides.size();
            for (std::size_t n = 0; n < count; ++n) {
                s.lab.session().go_to_slide(n);
                check(s, "slide " + std::to_string(n + 1));
            }
        }
}
