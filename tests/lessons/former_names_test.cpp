// Keys and names that scenes of before use: they are read as if nothing had changed.
#include <pliant/document/scene_file.h>
#include <pliant/run/breakpoints.h>
#include <pliant/run/runner.h>

#include "../every_lesson.h"

#include <catch2/catch_test_macros.hpp>

#include <set>
#include <string>

using namespace pliant;
using namespace pliant::test;

TEST_CASE("a scene with the keys of before opens and sets the parameters of today", "[lesson]") {
    const SceneFile scene = parse_scene(
        R"({"pliant": 1, "lesson": "mesh/cloth", "parameters": {"scheme": "explicit_euler", "newton_cap": 7, "nodes": 5},
            "events": [{"step": 2, "set": {"scheme": "implicit_euler"}}]})",
        "before.json");
    Runner runner(find_lesson(scene.lesson), scene.parameters);
    runner.set_events(scene.events);
    CHECK(runner.lesson().parameter("integrator").option_key() == "explicit_euler");
    CHECK(runner.lesson().parameter("newton_iterations").value() == 7);
    for (int k = 0; k < 3; ++k) runner.step();
    CHECK(runner.lesson().parameter("integrator").option_key() == "implicit_euler");
}

TEST_CASE("a condition on a probe holds under the name of before", "[lesson]") {
    Runner runner(find_lesson("elasticity/poisson"));
    runner.step();
    CHECK(runner.value("transverse_fem") == runner.value("narrowing"));
    CHECK_NOTHROW(parse_condition("transverse_fem > 0.1", runner.lesson()));
}

TEST_CASE("no name of before is a name of today in the same lesson", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        const auto lesson = entry.make();
        std::set<std::string_view> keys, names;
        for (const Parameter* p : lesson->parameters) keys.insert(p->info.key);
        for (const Probe& p : lesson->probes) names.insert(p.name);
        CAPTURE(entry.info.id);
        for (const Parameter* p : lesson->parameters) CHECK_FALSE(keys.contains(p->info.formerly));
        for (const Probe& p : lesson->probes) CHECK_FALSE(names.contains(p.formerly));
    }
}
