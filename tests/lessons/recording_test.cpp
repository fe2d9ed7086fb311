// What is done to a run is recorded, and its scene plays it again to the same bits.
#include "../every_lesson.h"

#include <pliant/document/scene_file.h>
#include <pliant/document/share.h>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

using namespace pliant;
using namespace pliant::test;

namespace {

// Plays the scene of a run as far as the run has come.
std::uint64_t replayed(const Runner& run) {
    const SceneFile scene = read_share(share_text(scene_of(run)));
    Runner again(find_lesson(scene.lesson), scene.parameters);
    again.set_events(scene.events);
    while (again.place() < run.place()) again.step_pass();
    return state_hash(again.lesson());
}

// A live number in use whose value may change by a little, if the lesson has one.
const Parameter* live_number(const Lesson& lesson) {
    for (const Parameter* p : lesson.parameters)
        if (p->info.effect == Effect::live && p->info.kind == Kind::number && p->used() && p->value() > 0) return p;
    return nullptr;
}

}  // namespace

TEST_CASE("recording: changes and pulls of every lesson replay to the same bits", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        INFO(entry.info.id);
        Runner run(entry);
        const Parameter* live = live_number(run.lesson());
        const auto change = [&](Real factor) {
            if (live) run.assign(live->info.key, live->value() * factor);
        };
        change(0.9);  // before the start
        const auto steps = [&](int count) {
            for (int i = 0; i < count; ++i) run.step();
        };
        steps(3);
        change(0.95);
        steps(2);
        if (run.lesson().can_pull()) run.pull(Pull{0, {0, 0, 0}, {0.1, 0.2, 0}});
        run.step_stage();
        change(0.98);  // inside a step: from the next one on
        steps(3);
        run.pull(std::nullopt);
        steps(2);
        CHECK(replayed(run) == state_hash(run.lesson()));
        if (live) {
            CHECK(run.recording().events().size() >= 2);
            CHECK(run.recording().start(*live) != live->value());
        }
    }
}

TEST_CASE("recording: going back forgets what came later") {
    Runner run(find_lesson("mesh/mass_spring"));
    for (int i = 0; i < 4; ++i) run.step();
    run.assign({{"time_step", "0.0005"}});
    for (int i = 0; i < 4; ++i) run.step();
    run.pull(Pull{0, {0, 0, 0}, {0, 1, 0}});
    run.step();
    REQUIRE(run.recording().events().size() == 2);
    REQUIRE(run.go_to({6, 0}));
    REQUIRE(run.recording().events().size() == 1);
    CHECK(run.recording().events()[0].step == 4);
    run.pull(std::nullopt);
    for (int i = 0; i < 3; ++i) run.step();
    CHECK(replayed(run) == state_hash(run.lesson()));
    // The change itself stays when the run goes back to its step, and goes with the step before.
    REQUIRE(run.go_to({4, 0}));
    CHECK(run.recording().events().size() == 1);
    REQUIRE(run.go_to({3, 0}));
    CHECK(run.recording().events().empty());
    CHECK(run.lesson().parameter("time_step").value() != 0.0005);
}

TEST_CASE("recording: a reset and a rebuild begin another run, and the script stays") {
    Runner run(find_lesson("mesh/mass_spring"));
    run.set_events({{.step = 2, .assign = {{"time_step", "0.0004"}}}});
    const auto do_something = [&] {
        for (int i = 0; i < 3; ++i) run.step();
        run.assign({{"time_step", "0.0005"}});
        REQUIRE(run.recording().events().size() == 1);
    };
    do_something();
    CHECK(scene_of(run).events.size() == 2);
    run.reset();
    CHECK(run.recording().events().empty());
    CHECK(scene_of(run).events.size() == 1);
    CHECK(run.recording().start(run.lesson().parameter("time_step")) == 0.0005);
    do_something();
    for (const Parameter* p : run.lesson().parameters)
        if (p->info.effect == Effect::rebuild && p->info.kind == Kind::whole) {
            run.assign(p->info.key, p->value() == p->info.useful.min ? p->value() + 1 : p->value() - 1);
            break;
        }
    CHECK(run.place() == Place{});
    CHECK(run.recording().events().empty());
}

TEST_CASE("recording: a drag of one control within a step is one event") {
    Runner run(find_lesson("mesh/mass_spring"));
    run.step();
    for (int i = 1; i < 20; ++i) run.assign("time_step", 0.0005 + i * 1e-6), run.pull(Pull{0, {0, 0, 0}, {0, 0.1 * i, 0}});
    REQUIRE(run.recording().events().size() == 1);
    CHECK(run.recording().events()[0].assign.size() == 1);
    CHECK(std::abs(run.recording().events()[0].pull->to.y() - 1.9) < 1e-12);
    run.pull(std::nullopt);
    CHECK(run.recording().events()[0].release);
    CHECK_FALSE(run.recording().events()[0].pull);
}
