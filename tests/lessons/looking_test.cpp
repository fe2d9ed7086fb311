// Parameters that only choose what is shown: they take effect at once, inside a step too, and the run is the same to the bit.
#include "../every_lesson.h"

#include <pliant/document/scene_file.h>
#include <pliant/run/recorder.h>
#include <pliant/text/texts.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace pliant;
using namespace pliant::test;

namespace {

std::vector<const Parameter*> looking(const Lesson& lesson) {
    std::vector<const Parameter*> all;
    std::ranges::copy_if(lesson.parameters, std::back_inserter(all), [](const Parameter* p) { return p->looks() && p->used(); });
    return all;
}

// The bits of all fields; NaN has bits like any other number.
std::vector<Real> fields_of(const Lesson& lesson) {
    std::vector<Real> all;
    for (const Field& f : lesson.fields)
        if (f.in_use()) all.insert(all.end(), f.view().begin(), f.view().end());
    return all;
}

// Another value of it than now, if k is 0 the least that its slider has.
Real other_value(const Parameter& p, int k) {
    const Interval span = p.info.useful;
    const Real value = k == 0 ? span.min : k == 1 ? span.max : span.min + 0.37 * (span.max - span.min);
    return p.info.kind == Kind::number ? value : std::floor(value);
}

void look_around(Runner& run) {
    const Place here = run.place(), reach = run.reach();
    const auto state = state_hash(run.lesson());
    const auto fields = fields_of(run.lesson());
    const std::size_t next = run.next_stage(), recorded = run.recording().events().size();
    for (const Parameter* p : looking(run.lesson())) {
        INFO(p->info.key);
        const Real before = p->value();
        for (int k = 0; k < 3; ++k) {
            run.assign(p->info.key, other_value(*p, k));
            CHECK(p->value() == other_value(*p, k));
            CHECK(run.wanted(*p) == p->value());
            CHECK(state_hash(run.lesson()) == state);
        }
        run.assign(p->info.key, before);
    }
    CHECK(run.place() == here);
    CHECK(run.reach() == reach);
    CHECK(run.next_stage() == next);
    CHECK(run.recording().events().size() == recorded);
    // Whatever was looked at meanwhile, the fields are what they were.
    CHECK(fields_of(run.lesson()) == fields);
}

void check_scene(const LessonEntry& entry, const SceneFile& scene) {
    Runner seen(entry, scene.parameters), unseen(entry, scene.parameters);
    if (looking(seen.lesson()).empty()) return;
    const auto both = [&](void (Runner::*move)()) { (seen.*move)(), (unseen.*move)(), look_around(seen); };
    look_around(seen);
    both(&Runner::step);
    for (std::size_t k = 0; k < seen.stages().size(); ++k) both(&Runner::step_stage);
    both(&Runner::step);
    CHECK(state_hash(seen.lesson()) == state_hash(unseen.lesson()));
    CHECK(fields_of(seen.lesson()) == fields_of(unseen.lesson()));
    // It is no part of the past: one goes back and looks at the same thing, and a scene opens with it.
    const Parameter& p = *looking(seen.lesson()).front();
    seen.assign(p.info.key, other_value(p, 2));
    REQUIRE(seen.step_back());
    CHECK(p.value() == other_value(p, 2));
    const SceneFile saved = scene_of(seen);
    const auto kept = std::ranges::find(saved.parameters, p.info.key, [](const auto& set) { return set.first; });
    CHECK((p.value() == p.info.initial || (kept != saved.parameters.end() && kept->second == p.text())));
    CHECK(saved.events.empty());
}

}  // namespace

TEST_CASE("every lesson: what only chooses what is shown leaves the run as it is", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        INFO(entry.info.id);
        check_scene(entry, {.lesson = std::string(entry.info.id), .parameters = {}});
        for (const std::string& name : preset_names(entry.info.id)) {
            INFO(name);
            check_scene(entry, preset(entry, name));
        }
    }
}

TEST_CASE("the cell, the cut and the direction that one looks at are chosen without a new run") {
    const std::pair<const char*, std::vector<const char*>> chosen[]{{"fluids/projection", {"cell_x", "cell_y"}},
                                                                    {"fluids/advection", {"cell_x", "cell_y"}},
                                                                    {"fluids/diffusion", {"cell_x", "cell_y"}},
                                                                    {"elasticity/stress_strain", {"angle"}},
                                                                    {"elasticity/strain_measures", {"v_angle", "v_elevation"}},
                                                                    {"elasticity/moduli", {"magnification"}}};
    for (const auto& [lesson, keys] : chosen) {
        const Runner run(find_lesson(lesson));
        for (const char* key : keys) {
            CAPTURE(lesson, key);
            CHECK(run.lesson().parameter(key).looks());
        }
    }
}

TEST_CASE("the force on a cut follows its angle when it has been cut, and not before") {
    Runner run(find_lesson("elasticity/stress_strain"), {{"scene", "cut"}, {"angle", "0"}});
    const Field& traction = run.lesson().field("traction");
    run.run_to_stage("stress");
    run.assign("angle", 90);
    CHECK(std::ranges::all_of(traction.view(), [](Real x) { return x == 0; }));
    run.step();
    run.assign("angle", 0);
    Runner fresh(find_lesson("elasticity/stress_strain"), {{"scene", "cut"}, {"angle", "0"}});
    fresh.step();
    CHECK(std::ranges::equal(traction.view(), fresh.lesson().field("traction").view()));
}

TEST_CASE("a script may look elsewhere, but going back does not") {
    Runner run(find_lesson("fluids/diffusion"));
    run.set_events({{.step = 2, .assign = {{"cell_x", "5"}}}});
    const Parameter& cell = run.lesson().parameter("cell_x");
    for (int i = 0; i < 4; ++i) run.step();
    CHECK(cell.value() == 5);
    run.assign("cell_x", 9);
    REQUIRE(run.go_to({1, 0}));
    CHECK(cell.value() == 9);
    REQUIRE(run.go_to({4, 0}));
    CHECK(cell.value() == 9);
}

TEST_CASE("numbers of the thing that one looks at are recorded anew when it is another; the others stay") {
    Runner run(find_lesson("fluids/diffusion"));
    Recorder recorder;
    recorder.record(run);
    for (int i = 0; i < 5; ++i) run.step(), recorder.record(run);
    const auto& probes = run.lesson().probes;
    const auto number = [&](std::string_view name) {
        return static_cast<std::size_t>(std::ranges::find(probes, name, &Probe::name) - probes.begin());
    };
    const auto before = Recorder::readings(run);
    run.assign("cell_x", 20);
    recorder.look_again(run, before);
    CHECK(recorder.series(number("u_selected")).size() == 1);
    CHECK(recorder.series(number("u_selected")).values().back() == run.value("u_selected"));
    for (std::size_t i = 0; i < probes.size(); ++i)
        if (i != number("u_selected")) CHECK(recorder.series(i).size() == 6);
}
