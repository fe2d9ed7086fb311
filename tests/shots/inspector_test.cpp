// Looking inside a step, without a picture: stops, before and after, pins and questions.
#include "../every_lesson.h"
#include "session/session.h"

#include <pliant/text/spoken.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;

namespace {

// Plays until it stops by itself; false when it does not.
bool play_until_stopped(Session& s, int frames = 300) {
    s.playing = true;
    for (int k = 0; k < frames && s.playing; ++k) s.update(1.0 / 30, 1e9);
    return !s.playing;
}

}  // namespace

TEST_CASE("a run that plays stops before a stage and goes on to the next step's", "[session][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        INFO(entry.info.id);
        Session s(entry.info.id);
        const std::string stage(s.runner().stages().back()->name);
        s.toggle_break(stage);
        REQUIRE(play_until_stopped(s));
        CHECK(s.inspector.stopped == "before " + spoken(stage));
        CHECK(s.runner().stages()[s.runner().next_stage()]->name == stage);
        const Place first = s.runner().place();
        REQUIRE(play_until_stopped(s));
        CHECK(s.runner().place() > first);
        s.toggle_break(stage);
        CHECK(!s.inspector.breaks.any());
    }
}

TEST_CASE("what a stage changed is what it left less what it found", "[session][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        INFO(entry.info.id);
        Session s(entry.info.id);
        for (int k = 0; k < 3; ++k) s.step();
        for (std::size_t k = 0; k + 1 < s.runner().stages().size(); ++k) s.step_stage();
        const Stage* shown = s.inspector.shown_stage(s.runner());
        REQUIRE(shown);
        for (const Field& field : s.lesson().fields) {
            if (!field.in_use() || !changes(s.lesson(), *shown, field) || field.size() == 0) continue;
            s.inspector.renew_trace(s.runner());
            const auto found = s.inspector.before(s.runner(), field.name);
            const auto change = s.inspector.change(s.runner(), field, 0);
            REQUIRE(change);
            REQUIRE(found.size() == field.view().size());
            const auto now = field.view();
            for (std::size_t r = 0; r < change->size(); ++r) {
                const std::size_t at = r * static_cast<std::size_t>(field.components);
                CHECK((*change)[r] == now[at] - found[at]);
            }
        }
    }
}

TEST_CASE("the picture of before is drawn as the stage found it, and nothing moves", "[session]") {
    Session s("mass_spring");
    for (int k = 0; k < 20; ++k) s.step();
    s.run_to_stage("integrate");
    const Place here = s.runner().place();
    const std::uint64_t hash = state_hash(s.lesson());
    const auto first_point = [](const Scene& scene) { return scene.triangles.at(0).corners.at(0); };
    const auto now = first_point(s.scene());
    s.compare(Compare::before);
    CHECK(first_point(s.scene()) != now);
    s.compare(Compare::side_by_side);
    CHECK(first_point(s.scene()) == now);
    REQUIRE(s.other_picture());
    CHECK(first_point(s.other_picture()->scene) != now);
    CHECK(s.runner().place() == here);
    CHECK(state_hash(s.lesson()) == hash);
}

TEST_CASE("the difference has colours of its own", "[session]") {
    Session s("navier_stokes");
    for (int k = 0; k < 10; ++k) s.step();
    s.colours = {"velocity", -1};
    s.run_to_stage("projection");
    const ColourScale field = s.colour_scale();
    s.compare(Compare::difference);
    CHECK(s.shows_change());
    CHECK(s.colour_scale().max < field.max);
    REQUIRE(s.scene().override_values);
    s.compare(Compare::now);
    CHECK(!s.shows_change());
    CHECK(!s.scene().override_values);
}

TEST_CASE("the past can be scrubbed without losing what was measured", "[session]") {
    Session s("mass_spring");
    for (int k = 0; k < 30; ++k) s.step();
    const auto times = s.recorder().series(0).at();
    s.go_to({7, 0});
    CHECK(s.runner().place() == Place{7, 0});
    CHECK(s.recorder().series(0).at() == times);
    s.go_to({30, 0});
    CHECK(s.runner().place() == Place{30, 0});
    s.go_to({7, 0});
    s.step();
    CHECK(s.recorder().series(0).steps().back() == 8);
}

TEST_CASE("pinned quantities are followed over time and written with their units", "[session]") {
    Session s("mass_spring");
    s.step();
    const Field& field = s.lesson().field("velocity");
    s.inspector.pin(s.runner(), field, 3, 1);
    s.inspector.pin(s.runner(), s.lesson().field("tension"), 5, -1);
    for (int k = 0; k < 5; ++k) s.step();
    REQUIRE(s.inspector.pins.size() == 2);
    CHECK(s.inspector.pins[0].series.size() == 6);
    CHECK(s.inspector.pins[0].series.values().back() == row_value(field, 3, 1));
    const std::string csv = s.inspector.pins_csv(true);
    CHECK_THAT(csv, ContainsSubstring("velocity.y of node 3 [m/s]"));
    CHECK(std::ranges::count(csv, '\n') == 7);
    s.inspector.thing = Thing{On::node, 3};
    CHECK_THAT(s.inspector.thing_csv(s.lesson()), ContainsSubstring("velocity,y,"));
}

TEST_CASE("questions follow their inputs and come back", "[session]") {
    Session s("navier_stokes");
    for (int k = 0; k < 5; ++k) s.step();
    const std::uint64_t hash = state_hash(s.lesson());
    s.ask({.field = "pressure", .index = 4000});
    REQUIRE(s.inspector.answer);
    const Answer first = *s.inspector.answer;
    const Answer& below = first.inputs.front();
    s.ask({.field = below.field, .index = below.index, .component = below.component, .when = below.when});
    CHECK(s.inspector.asked.size() == 2);
    CHECK(s.inspector.answer->value == below.value);
    s.inspector.ask_back(s.runner());
    CHECK(s.inspector.answer->value == first.value);
    // The number that is asked about is followed as the run goes on.
    CHECK(state_hash(s.lesson()) == hash);
    s.step();
    CHECK(s.inspector.answer->value == s.lesson().field("pressure").view()[4000]);
    s.ask({.field = "no_such_field"});
    CHECK(s.message());
}

TEST_CASE("a question can be followed into the steps before", "[session]") {
    Session s("mass_spring");
    for (int k = 0; k < 4; ++k) s.step();
    s.ask({.field = "velocity", .index = 60, .component = 1});
    Answer a = *s.inspector.answer;
    const Index last = a.when.step;
    for (int depth = 0; depth < 40 && a.when.step == last; ++depth) {
        const auto next =
            std::ranges::find_if(a.inputs, [](const Answer& in) { return in.field == "velocity" || in.field == "position"; });
        REQUIRE(next != a.inputs.end());
        s.ask({.field = next->field, .index = next->index, .component = next->component, .when = next->when});
        REQUIRE(!s.message());
        a = *s.inspector.answer;
    }
    CHECK(a.when.step < last);
}
