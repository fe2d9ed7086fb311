// What the lab does, without a picture: time, undo, colours, steps back and scenes that are refused.
#include "session/session.h"
#include "../every_lesson.h"
#include "parameters.h"
#include "walker.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Told = Session::Message::Kind;

namespace {

Real x_of(const Session& session) { return *session.lesson().probe("x").value(); }

}  // namespace

// ---------------------------------------------------------------------------------------------------------------- time

TEST_CASE("a session plays as many steps as the clock asks for", "[session]") {
    Session session = walking();
    session.playing = true;
    for (int frame = 0; frame < 60; ++frame) session.update(1.0 / 60, 1e9);
    CHECK_THAT(session.runner().time(), WithinAbs(1, 2e-3));
    session.speed = 0.25;
    for (int frame = 0; frame < 60; ++frame) session.update(1.0 / 60, 1e9);
    CHECK_THAT(session.runner().time(), WithinAbs(1.25, 2e-3));
    session.playing = false;
    session.update(1, 1e9);
    CHECK_THAT(session.runner().time(), WithinAbs(1.25, 2e-3));
}

TEST_CASE("a slow machine drops frames and never changes the time step", "[session]") {
    Session session = walking();
    session.playing = true;
    constexpr int frames = 20;
    for (int frame = 0; frame < frames; ++frame) {
        const Index before = session.runner().place().step;
        session.update(1.0 / 60, Budget::of_passes(4));  // a frame has room for two steps of two passes
        CHECK(session.runner().place().step - before == 2);
    }
    const auto steps = static_cast<Real>(session.runner().place().step);
    CHECK(session.runner().time_step() == 0.001);
    CHECK_THAT(session.runner().time(), WithinAbs(0.001 * steps, 1e-15));
    CHECK_THAT(x_of(session), WithinAbs(0.001 * steps, 1e-12));
    CHECK(session.runner().time() < frames / 60.0 / 2);
    CHECK(session.reached_speed() < 0.7);

    // Quick again, it goes on from where it is: what was missed is not made up for.
    const Real here = session.runner().time();
    session.update(1.0 / 60, 1e9);
    CHECK(session.runner().time() - here < 2.5 / 60);
}

TEST_CASE("a long pause between two frames does not freeze the lab", "[session]") {
    Session session = walking();
    session.playing = true;
    session.update(3600, Budget::of_passes(6));
    CHECK(session.runner().place() == Place{3, 0});
}

TEST_CASE("a session steps back to what it was", "[session][every_lesson]") {
    Session session(lessons().front().info.id);
    for (const LessonEntry& entry : every_lesson()) {
        CAPTURE(entry.info.id);
        session.open(entry);
        for (int i = 0; i < 3; ++i) session.step();
        const auto hash = state_hash(session.lesson());
        const Place place = session.runner().place();
        session.step();
        const auto recorded = session.recorder().series(0).steps().size();
        REQUIRE(session.runner().place().step == place.step + 1);
        session.step_back();
        CHECK(session.runner().place() == place);
        CHECK(state_hash(session.lesson()) == hash);
        // What was measured ahead stays, until the run goes on from here.
        CHECK(session.recorder().series(0).steps().size() == recorded);
        session.step();
        CHECK(session.recorder().series(0).steps().size() == recorded);
        CHECK(session.recorder().series(0).steps().back() == place.step + 1);
    }
}

TEST_CASE("stepping back from the beginning says so", "[session]") {
    Session session = walking();
    session.step_back();
    REQUIRE(session.message());
    CHECK(session.message()->kind == Told::info);
    CHECK(session.runner().place() == Place{});
    session.step();
    session.step_back();
    CHECK_FALSE(session.message());
    CHECK(x_of(session) == 0);
}

TEST_CASE("a hand that let go does not come back with a step back", "[session]") {
    Session session = walking({{"speed", "0"}});
    session.step();
    session.pull(Pull{0, Vec<3>::Zero(), Vec<3>::Ones()});
    session.step();
    session.step();
    CHECK(x_of(session) == 2);
    session.pull(std::nullopt);
    session.step_back();
    CHECK(x_of(session) == 1);
    session.step();
    CHECK(x_of(session) == 1);
}

TEST_CASE("a run that blows up pauses, keeps the last good state and can step back", "[session]") {
    Session session = walking({{"speed", "1000"}, {"time_step", "0.03"}});
    session.playing = true;
    for (int frame = 0; frame < 60 && session.playing; ++frame) session.update(1.0 / 60, 1e9);
    CHECK_FALSE(session.playing);
    REQUIRE(session.message());
    CHECK(session.message()->kind == Told::diverged);
    CHECK_THAT(session.message()->text, ContainsSubstring("walk") && ContainsSubstring("100"));
    CHECK(session.runner().place() == Place{3, 0});
    CHECK_THAT(x_of(session), WithinAbs(90, 1e-12));
    session.step_back();
    CHECK_THAT(x_of(session), WithinAbs(60, 1e-12));
    session.reset();
    CHECK(x_of(session) == 0);
    CHECK_FALSE(session.message());
}

// ---------------------------------------------------------------------------------------------------------- parameters

TEST_CASE("undo goes back one change after another, a whole drag at a time", "[session]") {
    Session session = walking();
    session.assign(parameter(session, "speed"), 2);
    session.assign(parameter(session, "speed"), 3);
    session.assign(parameter(session, "speed"), 4, true);
    session.assign(parameter(session, "speed"), 5, true);
    session.assign(parameter(session, "start"), 0.5);
    CHECK(session.can_undo());
    session.undo();
    CHECK(wanted(session, "start") == 0);
    CHECK(x_of(session) == 0);
    session.undo();
    CHECK(wanted(session, "speed") == 2);
    session.undo();
    CHECK(wanted(session, "speed") == 1);
    CHECK_FALSE(session.can_undo());
    session.undo();
    CHECK(wanted(session, "speed") == 1);
}

TEST_CASE("a refused value changes nothing and is not undone", "[session]") {
    Session session = walking();
    session.step();
    session.assign(parameter(session, "speed"), 1e9);
    REQUIRE(session.message());
    CHECK(session.message()->kind == Told::refused);
    CHECK_THAT(session.message()->text, ContainsSubstring("speed"));
    CHECK(wanted(session, "speed") == 1);
    CHECK(session.runner().place() == Place{1, 0});
    CHECK_FALSE(session.can_undo());
    session.assign(parameter(session, "speed"), 2);
    CHECK_FALSE(session.message());
}

TEST_CASE("the default of a parameter can be restored and that undone", "[session]") {
    Session session = walking({{"speed", "7"}});
    session.restore_default(parameter(session, "speed"));
    CHECK(wanted(session, "speed") == 1);
    session.undo();
    CHECK(wanted(session, "speed") == 7);
}

TEST_CASE("a live change inside a step waits for the next one, a rebuilding one restarts", "[session]") {
    Session session = walking();
    session.step_stage();
    session.assign(parameter(session, "speed"), 5);
    CHECK(wanted(session, "speed") == 5);
    session.step();
    CHECK_THAT(x_of(session), WithinAbs(0.001, 1e-15));
    session.step();
    CHECK_THAT(x_of(session), WithinAbs(0.006, 1e-15));
    session.assign(parameter(session, "start"), 0.5);
    CHECK(session.runner().place() == Place{});
    CHECK(x_of(session) == 0.5);
}

// ------------------------------------------------------------------------------------------------------------- colours

TEST_CASE("the range of the colours does not flicker", "[session]") {
    ColourRange range;
    int changes = 0;
    ColourScale last;
    for (int frame = 0; frame < 600; ++frame) {
        const Real swing = 1 + 0.5 * std::sin(0.1 * frame);
        range.update({0, 0.3 * swing, swing}, false);
        if (range.scale.max != last.max || range.scale.min != last.min) ++changes;
        last = range.scale;
        CHECK(range.scale.max >= swing);
    }
    CHECK(changes <= 20);
    const Real widest = range.scale.max;
    for (int frame = 0; frame < 600; ++frame) range.update({0, 1 + 0.5 * std::sin(0.1 * frame)}, false);
    CHECK(range.scale.max == widest);
}

TEST_CASE("the range of the colours follows numbers that leave it for good, and stays when it is fixed", "[session]") {
    ColourRange range;
    range.update({0, 1}, false);
    range.update({0, 50}, false);
    CHECK(range.scale.max >= 50);
    range.update({0, 0.01}, false);
    CHECK(range.scale.max < 1);
    range.automatic = false;
    const ColourScale fixed = range.scale;
    range.update({-5, 70}, false);
    CHECK(range.scale.min == fixed.min);
    CHECK(range.scale.max == fixed.max);
}

// -------------------------------------------------------------------------------------------------------------- scenes

TEST_CASE("opening a bad scene leaves the present one as it was", "[session]") {
    const std::string id(lessons().front().info.id);
    Session session(id);
    for (int i = 0; i < 2; ++i) session.step();
    const auto hash = state_hash(session.lesson());
    const Runner* runner = &session.runner();
    const std::string key(session.lesson().parameters.front()->info.key);
    const std::vector<SceneFile> bad{{.lesson = "no/such_lesson", .parameters = {}},
                                     {.lesson = id, .parameters = {{"no_such_parameter", "1"}}},
                                     {.lesson = id, .parameters = {{key, "nan"}}},
                                     {.lesson = id, .parameters = {}, .events = {{.step = 0, .assign = {{key, "nan"}}}}}};
    for (const SceneFile& scene : bad) {
        CHECK_THROWS_AS(session.open_scene(scene), Refused);
        CHECK(&session.runner() == runner);
        CHECK(session.runner().place() == Place{2, 0});
        CHECK(state_hash(session.lesson()) == hash);
    }
}

TEST_CASE("parameters that do not go together are refused with the scene as it was", "[session]") {
    Session session = walking();
    session.step();
    CHECK_THROWS_AS(session.open(walker, {{"speed", "200000"}}), Refused);
    CHECK(session.runner().place() == Place{1, 0});
    CHECK(wanted(session, "speed") == 1);
}

TEST_CASE("a scene saved from a session opens as the same run", "[session][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        CAPTURE(entry.info.id);
        Session session(entry.info.id);
        for (const Parameter* p : session.lesson().parameters)
            if (p->info.kind == Kind::toggle) session.assign(*p, p->info.initial == 0 ? 1 : 0);
        session.camera = Camera{Vec<3>(0.1, 0.2, 0.3), 1.0 / 3, 0.7, -0.1};
        const std::string text = scene_text(session.scene_file());
        session.reset();
        for (int i = 0; i < 3; ++i) session.step();

        Session opened(lessons().front().info.id);
        opened.open_scene(parse_scene(text, "saved"));
        CHECK(opened.entry().info.id == entry.info.id);
        CHECK(opened.camera == session.camera);
        CHECK(opened.colours.field == session.colours.field);
        CHECK(opened.colours.component == session.colours.component);
        CHECK(scene_text(opened.scene_file()) == text);
        for (int i = 0; i < 3; ++i) opened.step();
        CHECK(state_hash(opened.lesson()) == state_hash(session.lesson()));
    }
}

TEST_CASE("a scene saved inside a step opens inside it", "[session]") {
    const std::string id(lessons().front().info.id);
    Session session(id);
    session.step_stage();
    const Place place = session.runner().place();
    REQUIRE(place.passes > 0);
    Session opened(id);
    opened.open_scene(parse_scene(scene_text(session.scene_file()), "saved"));
    CHECK(opened.runner().place() == place);
}

TEST_CASE("going on to the next lesson comes round to the first", "[session]") {
    Session session(lessons().front().info.id);
    session.open_next(-1);
    CHECK(session.entry().info.id == lessons().back().info.id);
    session.open_next(1);
    CHECK(session.entry().info.id == lessons().front().info.id);
    for (std::size_t i = 0; i < lessons().size(); ++i) {
        session.playing = true;
        session.open_next(1);
        CHECK(session.runner().place() == Place{});
    }
    CHECK(session.entry().info.id == lessons().front().info.id);
}

TEST_CASE("a saved scene plays what was done again, to the same bits", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        INFO(entry.info.id);
        Session session(entry.info.id);
        const auto steps = [](Session& s, int count) {
            for (int i = 0; i < count; ++i) s.step();
        };
        steps(session, 4);
        const auto live = std::ranges::find_if(session.lesson().parameters, [](const Parameter* p) {
            return p->info.effect == Effect::live && p->info.kind == Kind::number && p->used() && p->value() > 0;
        });
        if (live != session.lesson().parameters.end()) session.assign(**live, 0.97 * (*live)->value());
        steps(session, 3);
        if (session.lesson().can_pull()) {
            session.pull(Pull{0, {0, 0, 0}, {0.1, 0.2, 0}});
            steps(session, 4);
            session.step_back();
            session.step_back();
            session.pull(std::nullopt);
        }
        steps(session, 3);
        Session again(lessons().front().info.id);
        again.open_scene(parse_scene(scene_text(session.scene_file()), "saved"));
        CHECK((again.runner().place() == session.runner().place()));
        CHECK(state_hash(again.lesson()) == state_hash(session.lesson()));
        session.reset();
        CHECK(session.scene_file().events.empty());
    }
}

TEST_CASE("a static test that was done answers a live slider at once") {
    Session session("mesh/mass_spring");
    session.assign(parameter(session, "cells_x"), 2);
    session.assign(parameter(session, "lattice"), parameter(session, "lattice").parse("square"));
    session.assign(parameter(session, "scene"), parameter(session, "scene").parse("stretch_test"));
    const auto modulus = [&] { return session.lesson().probe("youngs_modulus").value(); };
    session.assign(parameter(session, "k_shear"), 50);
    CHECK_FALSE(modulus());  // nothing was asked for yet
    session.step();
    const Real before = modulus().value();
    session.assign(parameter(session, "k_shear"), 200);
    REQUIRE(modulus());
    CHECK(*modulus() > 1.05 * before);
    CHECK(session.lesson().at_rest());
}

TEST_CASE("the default values of all parameters are one step of undo") {
    Session session("mesh/mass_spring");
    const Parameter& dt = session.lesson().parameter("time_step");
    const Parameter& mass = *session.lesson().parameters.front();
    session.assign(dt, 0.0005);
    session.restore_defaults();
    CHECK(dt.value() == dt.info.initial);
    session.undo();
    CHECK(dt.value() == 0.0005);
    CHECK(mass.value() == mass.info.initial);
    session.undo();
    CHECK(dt.value() == dt.info.initial);
    CHECK_FALSE(session.can_undo());
    session.restore_defaults();
    CHECK_FALSE(session.can_undo());
}
