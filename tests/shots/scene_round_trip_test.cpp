// A scene restores all that a person had: the lab that opens it shows what the lab showed that saved it, to the bit.
#include "../every_lesson.h"
#include "app/lab.h"
#include "app/state_report.h"
#include "platform/headless_context.h"
#include "platform/image.h"

#include <pliant/document/share.h>
#include <catch2/catch_test_macros.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

using Json = nlohmann::ordered_json;

// What a lab shows, as far as a scene holds it.
struct Shown {
    std::string scene;
    Json state;
    Image picture;
    std::uint64_t run = 0, beside = 0, later = 0;
    Place place;
};

class Desk {
public:
    explicit Desk(std::string_view lesson = "mesh/mass_spring") : context_(open_headless({960, 540})), lab(*context_, lesson) {
        lab.state().scene.hints_shown = false;
        draw(2);
    }
    void draw(int frames = 1) {
        for (int i = 0; i < frames; ++i) lab.frame(0), context_->present();
    }

    Shown shown() {
        Session& s = lab.session();
        s.dismiss();
        // Type and strip of a picture keep the size that they once had; both begin anew.
        lab.state().scene.notes_strip = {}, lab.state().scene.label_type = {};
        lab.state().plots.memory.refit();
        draw(4);
        lab.frame(0);
        Shown all{.scene = scene_text(lab.scene_file()), .state = lasting(), .picture = picture(), .place = s.runner().place()};
        all.run = state_hash(s.lesson());
        if (s.companion()) all.beside = state_hash(s.companion()->lesson());
        s.step();
        s.step_stage();
        all.later = state_hash(s.lesson());
        return all;
    }

private:
    // The state without what is of this program alone, and of the past that is not run again.
    Json lasting() const {
        Json state = Json::parse(state_json(lab.state()));
        for (const char* key : {"frame", "resting", "controls", "focus", "hovered", "pulling", "message", "summary", "claims"})
            state.erase(key);
        for (const char* key : {"reach", "stopped"}) state["inspector"].erase(key);
        return state;
    }
    Image picture() {
        // Of a lab that a plot fills the whole.
        if (lab.state().fill) return read_pixels(*context_);
        const Rectangle r = lab.state().controls.at("scene");
        const auto px = [](float x) { return static_cast<int>(std::lround(x)); };
        return crop(read_pixels(*context_), px(r.x), px(r.y), px(r.width), px(r.height));
    }

    std::unique_ptr<Context> context_;

public:
    Lab lab;
};

// Does to a lab what a person might do.
class Hand {
public:
    Hand(Lab& lab, unsigned seed) : lab_(lab), s_(lab.session()), random_(seed) {}

    void play() {
        change_a_number(Effect::rebuild);
        change_a_number(Effect::live);
        walk();
        if (chance()) change_a_number(Effect::live), walk();
        if (chance()) {
            s_.toggle_pin();
            s_.reset();
        }
        if (chance()) beside();
        if (chance() && s_.lesson().can_pull()) pull();
        walk();
        look_at_numbers();
        if (chance()) change_a_number(Effect::look);
        inside();
        if (chance()) change_a_number(Effect::live);
        choose_view();
        move_camera();
        set_stops();
        choose_panels();
        ask();
    }

private:
    bool chance() { return random_() % 2 == 0; }
    std::size_t upto(std::size_t count) { return random_() % count; }

    void change_a_number(Effect effect) {
        std::vector<const Parameter*> all;
        for (const Parameter* p : s_.lesson().parameters)
            if (p->info.effect == effect && p->info.kind == Kind::number && p->used() && p->value() > 0) all.push_back(p);
        if (all.empty()) return;
        const Parameter& p = *all[upto(all.size())];
        s_.assign(p, std::clamp(0.97 * p.value(), p.info.useful.min, p.info.useful.max));
    }
    void walk() {
        for (std::size_t n = 1 + upto(3); n > 0; --n) s_.step();
    }
    void inside() {
        for (std::size_t n = upto(s_.runner().stages().size() + 1); n > 0; --n) s_.step_stage();
        if (s_.runner().inside_step() && chance()) s_.step_pass();
    }
    void beside() {
        s_.toggle_companion();
        s_.address(chance());
        if (chance()) change_a_number_of_b();
        walk();
        if (chance()) change_a_number_of_b();
        walk();
        if (chance() && s_.has_difference()) s_.show_difference(true);
    }
    void change_a_number_of_b() {
        for (const Parameter* p : s_.companion()->lesson().parameters)
            if (p->info.effect == Effect::live && p->info.kind == Kind::number && p->used() && p->value() > 0)
                return s_.assign(*p, std::max(0.96 * p->value(), p->info.useful.min));
    }
    void pull() {
        const Vec<3> at(0.1, 0.2, 0);
        s_.pull(Pull{0, at, at + Vec<3>(0.01, 0.02, 0)});
        s_.step();
        s_.pull(std::nullopt);
    }
    const Field* some_field() {
        std::vector<const Field*> all;
        for (const Field& f : s_.lesson().fields)
            if (f.in_use() && f.size() > 0) all.push_back(&f);
        return all.empty() ? nullptr : all[upto(all.size())];
    }
    void look_at_numbers() {
        const Field* f = some_field();
        if (!f) return;
        s_.inspector.thing = Thing{f->on, f->size() / 2};
        if (chance()) s_.inspector.pin(s_.runner(), *f, f->size() / 2, -1), s_.step();
    }
    void choose_view() {
        if (const Field* f = some_field(); f && chance()) s_.colours = {std::string(f->name), f->components - 1}, s_.range = {};
        s_.view_changed();
        s_.range.automatic = chance();
        s_.show_arrows = chance(), s_.smooth = chance(), s_.patterns = chance(), s_.extreme = chance();
        s_.compare(static_cast<Compare>(upto(5)));
        if (chance()) s_.inspector.stage = s_.runner().stages().front()->name;
        s_.inspector.swipe = 0.25f;
        s_.view_changed();
    }
    void move_camera() {
        lab_.frame(0);
        if (chance()) s_.viewpoint.turn(40, 8);
        if (!chance()) return;
        Camera& own = s_.own_camera();
        own.target += Vec<3>(0.01, 0.02, 0), own.distance *= 1.2, own.yaw += 0.1;
    }
    void set_stops() {
        if (chance()) s_.toggle_break(s_.runner().stages().back()->name);
        if (chance()) s_.inspector.breaks.conditions.push_back({std::string(s_.lesson().probes.front().name), ">", 1e30});
        s_.inspector.breaks.laws = chance();
    }
    void choose_panels() {
        LabState& l = lab_.state();
        lab_.set_layout(chance() ? Layout::slide : Layout::lab);
        l.side_wanted = static_cast<SideTab>(upto(4));
        if (chance()) {
            l.plots.picked = true;
            l.plots.chosen = {std::string(s_.lesson().probes.back().name), "along"};
        }
        lab_.frame(0);
        if (chance()) {
            PlotSetting zoom{.x = Range{0, 0.5}, .y_scale = AxisScale::log, .hidden = {"exact"}};
            l.plots.memory.begin_with({{std::string(s_.lesson().probes.back().name), zoom}});
        }
        if (chance() && chance()) l.fill = {Filled::plot, std::string(s_.lesson().probes.back().name)};
        if (chance()) l.atlas.atlas.cells = 12, l.atlas.atlas.steps = 100;
    }
    void ask() {
        const Field* f = some_field();
        if (!f || !chance()) return;
        s_.ask({.field = std::string(f->name), .index = 0, .component = f->components > 1 ? 0 : -1});
        if (s_.inspector.answer && !s_.inspector.answer->inputs.empty())
            for (const Answer& in : s_.inspector.answer->inputs)
                if (in.can_ask && in.kind != Answer::Kind::part && chance())
                    return s_.ask({.field = in.of_probe ? "probe:" + in.field : in.field,
                                   .index = in.index,
                                   .component = in.component,
                                   .when = in.when});
    }

    Lab& lab_;
    Session& s_;
    std::mt19937 random_;
};

void check_same(const Shown& opened, const Shown& saved) {
    CHECK(opened.scene == saved.scene);
    CHECK(opened.place == saved.place);
    CHECK(opened.run == saved.run);
    CHECK(opened.beside == saved.beside);
    CHECK(opened.later == saved.later);
    for (const auto& [key, value] : saved.state.items()) {
        INFO(key);
        CHECK(opened.state[key] == value);
    }
    REQUIRE(opened.picture.width == saved.picture.width);
    REQUIRE(opened.picture.height == saved.picture.height);
    CHECK(compare(opened.picture, saved.picture, 0).largest == 0);
}

}  // namespace

TEST_CASE("every lesson: a scene opens in another lab as it was left, whatever was done", "[shots][scene][every_lesson]") {
    for (const LessonEntry& entry : every_lesson())
        for (unsigned seed = 1; seed <= 4; ++seed) {
            CAPTURE(entry.info.id, seed);
            Shown saved;
            {
                Desk desk(entry.info.id);
                Hand(desk.lab, seed).play();
                saved = desk.shown();
            }
            INFO(saved.scene);
            Desk other;
            other.lab.open_scene(read_share(share_text(parse_scene(saved.scene, "saved"))));
            if (other.lab.session().message()) INFO(other.lab.session().message()->text);
            check_same(other.shown(), saved);
        }
}

TEST_CASE("every lesson: a slide of the walkthrough opens as it was left", "[shots][scene][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        CAPTURE(entry.info.id);
        Shown saved;
        {
            Desk desk(entry.info.id);
            Session& s = desk.lab.session();
            s.start_walkthrough();
            s.go_to_slide(1);
            s.walkthrough_next();
            s.step();
            s.step_stage();
            saved = desk.shown();
        }
        INFO(saved.scene);
        Desk other;
        other.lab.open_scene(parse_scene(saved.scene, "saved"));
        check_same(other.shown(), saved);
    }
}

TEST_CASE("a scene of the first version leaves the panels as they are", "[shots][scene]") {
    Desk desk;
    desk.lab.set_layout(Layout::slide);
    desk.lab.session().show_arrows = false;
    desk.lab.open_scene(parse_scene(R"({"pliant": 1, "lesson": "mesh/rod", "parameters": {}})", "old"));
    desk.draw();
    CHECK(desk.lab.state().layout == Layout::slide);
    CHECK_FALSE(desk.lab.session().show_arrows);
    CHECK(desk.lab.session().runner().place() == Place{});
}

TEST_CASE("a scene that broke down opens before the pass that breaks, with what went wrong", "[shots][scene]") {
    Desk desk("mesh/mass_spring");
    Session& s = desk.lab.session();
    s.assign(s.lesson().parameter("integrator"), 0);
    s.assign(s.lesson().parameter("time_step"), 0.05);
    for (int i = 0; i < 1000 && !s.autopsy(); ++i) s.step();
    REQUIRE(s.autopsy());
    const std::string text = scene_text(desk.lab.scene_file()), words = s.autopsy()->text();
    const Place place = s.runner().place();
    Session opened;
    opened.open_scene(parse_scene(text, "saved"));
    REQUIRE(opened.autopsy());
    CHECK(opened.autopsy()->text() == words);
    CHECK(opened.runner().place() == place);
}

TEST_CASE("a place that the step does not have is told, and so is a thing that is not there", "[shots][scene]") {
    Session s;
    s.open_scene(parse_scene(R"({"pliant": 2, "lesson": "mesh/rod", "place": {"step": 2, "passes": 500}})", "far"));
    REQUIRE(s.message());
    CHECK(s.message()->text.find("no pass 500") != std::string::npos);
    CHECK(s.runner().place() == Place{3, 0});
    s.open_scene(parse_scene(R"({"pliant": 2, "lesson": "mesh/rod", "inspector": {"on": "node", "index": 5000}})", "far"));
    REQUIRE(s.message());
    CHECK(s.message()->text.find("node 5000") != std::string::npos);
    s.open_scene(parse_scene(R"({"pliant": 2, "lesson": "mesh/rod", "slide": {"number": 90}})", "far"));
    REQUIRE(s.message());
    CHECK(s.message()->text.find("slide 90") != std::string::npos);
    // Refused before anything has changed.
    const int opened = s.open_count();
    CHECK_THROWS_AS(s.open_scene(parse_scene(
                        R"({"pliant": 2, "lesson": "elasticity/stress_strain", "beside": {"set": {"length": 1e-6}}})", "wrong")),
                    Refused);
    CHECK(s.open_count() == opened);
}
