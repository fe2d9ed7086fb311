// What version 2 of a scene holds: it is read back as it was written, and refused with its place where it does not belong.
#include <pliant/document/share.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

namespace {

SceneFile whole_scene() {
    SceneFile scene{.lesson = "time/bead_chain", .parameters = {{"stiffness", "123.456789012345678"}}};
    scene.view = SceneView{.field = "force", .range = Interval{-1e-9, 3}, .diverging = true, .fixed = true, .arrows = false};
    scene.view->compare = "swipe", scene.view->of_stage = "kick", scene.view->swipe = 1.0 / 3;
    scene.place = ScenePlace{.step = 12, .passes = 2, .changes = {.set = {{"mass", "0.1"}}}};
    scene.beside = SceneBeside{.set = {{"mass", "0.25"}}, .events = std::vector<Event>{{.step = 3, .release = true}}};
    scene.beside->addressed = scene.beside->difference = true;
    scene.pinned = ScenePinned{.run = {.parameters = {{"mass", "0.75"}}, .place = {.step = 7}}, .field = "v"};
    scene.stops = {.stages = {"kick"}, .passes = {"drift"}, .conditions = {"energy > 0.5"}, .assumptions = true};
    scene.inspector = {.on = "node", .index = 4};
    scene.inspector.asked = {{.field = "u", .index = 4}, {.field = "energy", .when = Place{11, 3}}};
    scene.inspector.pinned = {{.field = "v", .index = 2, .from = 5}};
    scene.layout = SceneLayout{.layout = "slide", .tab = "inspect"};
    scene.plots.shown = std::vector<std::string>{"energy", "along"};
    scene.plots.plots = {{.name = "energy", .x = Interval{0, 0.1}, .y_log = true, .hidden = {"exact"}},
                         {.name = "pin 1", .y = Interval{-1, 1}}};
    scene.atlas =
        SceneAtlas{.across = {.key = "time_step", .range = Interval{1e-3, 0.1}, .log = true}, .up = {.key = "mass"}, .cells = 12};
    return scene;
}

}  // namespace

TEST_CASE("scene: all that version 2 has is read back as it was written, from a file and from a share string") {
    const SceneFile scene = whole_scene();
    CHECK(scene.version() == 2);
    CHECK_THAT(scene_text(scene), ContainsSubstring("\"pliant\": 2"));
    for (const SceneFile& again : {parse_scene(scene_text(scene), "s.json"), read_share(share_text(scene))}) {
        CHECK(again.view == scene.view);
        CHECK(again.place == scene.place);
        CHECK(again.beside == scene.beside);
        CHECK(again.pinned == scene.pinned);
        CHECK(again.stops == scene.stops);
        CHECK(again.inspector == scene.inspector);
        CHECK(again.layout == scene.layout);
        CHECK(again.plots == scene.plots);
        CHECK(again.atlas == scene.atlas);
        CHECK(scene_text(again) == scene_text(scene));
    }
    SceneFile turned{
        .lesson = "time/bead_chain", .parameters = {}, .camera = Camera{{1, 2, 3}, 4, 0.5, 0.25}, .camera_follows = true};
    const SceneFile again = parse_scene(scene_text(turned), "s.json");
    CHECK(again.camera_follows);
    CHECK(again.camera->yaw == 0.5);
    CHECK(again.camera->pitch == 0.25);
    SceneFile own{.lesson = "time/bead_chain", .parameters = {}, .camera = Camera{{1, 2, 3}, 4, 0.5, 0.25}, .camera_aspect = 1.5};
    CHECK(parse_scene(scene_text(own), "s.json").camera == own.camera);
    CHECK(parse_scene(scene_text(own), "s.json").camera_aspect == 1.5);
}

TEST_CASE("scene: the first version is written where it says all, and begins every part at its default") {
    SceneFile scene{
        .lesson = "time/bead_chain", .parameters = {{"mass", "2"}}, .camera = Camera{}, .view = SceneView{.field = "u"}};
    scene.events = {{.step = 3, .release = true}};
    CHECK(scene.version() == 1);
    CHECK_THAT(scene_text(scene), ContainsSubstring("\"pliant\": 1"));
    const SceneFile again = parse_scene(scene_text(scene), "s.json");
    CHECK(again.view == scene.view);
    CHECK_FALSE((again.place || again.beside || again.pinned || again.slide || again.layout || again.atlas));
    // A scene of the second version may be as plain as one of the first.
    CHECK(parse_scene(R"({"pliant": 2, "lesson": "time/bead_chain"})", "s.json").version() == 1);
}

TEST_CASE("scene: a share string is short, however much of the lab it holds") {
    CHECK(share_text({.lesson = "time/bead_chain", .parameters = {}, .place = ScenePlace{.step = 40}}).size() < 140);
    CHECK(share_text(whole_scene()).size() < 800);
}

TEST_CASE("scene: what does not belong in version 2 is refused with file, line and column") {
    struct Case {
        const char *text, *place, *words;
    };
    const auto [text, place, words] = GENERATE(values<Case>({
        {"\"palce\": {}", "s.json:2:1", "did you mean 'place'"},
        {"\"place\": {\"step\": -1}", "s.json:2:11", "from 0 to 10000000"},
        {"\"place\": {\"step\": 1.5}", "s.json:2:11", "whole number"},
        {"\"place\": {\"step\": 10000001}", "s.json:2:11", "from 0 to 10000000"},
        {"\"place\": {\"passes\": 1e7}", "s.json:2:11", "from 0 to 1000000"},
        {"\"place\": {\"set\": {\"mas\": 1}}", "s.json:2:19", "did you mean 'mass'"},
        {"\"place\": {\"set\": {\"amplitude\": 1}}", "s.json:2:19", "begins the run anew"},
        {"\"beside\": {\"set\": {\"mass\": -1}}", "s.json:2:20", "outside the accepted range"},
        {"\"beside\": {\"now\": {\"step\": 1}}", "s.json:2:20", "unknown key 'step'"},
        {"\"beside\": {\"addressed\": 1}", "s.json:2:12", "true or false"},
        {"\"pinned\": {\"field\": \"forse\"}", "s.json:2:12", "did you mean 'force'"},
        {"\"view\": {\"range\": [2, 1]}", "s.json:2:10", "the lower one"},
        {"\"view\": {\"range\": [2]}", "s.json:2:10", "two numbers"},
        {"\"view\": {\"compare\": \"swip\"}", "s.json:2:10", "did you mean 'swipe'"},
        {"\"view\": {\"of_stage\": \"kck\"}", "s.json:2:10", "did you mean 'kick'"},
        {"\"view\": {\"swipe\": 2}", "s.json:2:10", "from 0 to 1"},
        {"\"stops\": {\"stages\": [\"kick\", \"kik\"]}", "s.json:2:", "did you mean 'kick'"},
        {"\"stops\": {\"conditions\": [\"enrgy > 1\"]}", "s.json:2:", "energy"},
        {"\"stops\": {\"conditions\": [\"energy\"]}", "s.json:2:", "not understood"},
        {"\"stops\": {\"conditions\": \"energy > 1\"}", "s.json:2:11", "a list"},
        {"\"inspector\": {\"on\": \"nod\"}", "s.json:2:15", "did you mean 'node'"},
        {"\"inspector\": {\"asked\": [{\"index\": 1}]}", "s.json:2:", "needs a 'field'"},
        {"\"inspector\": {\"asked\": [{\"field\": \"forse\"}]}", "s.json:2:", "did you mean 'force'"},
        {"\"inspector\": {\"pinned\": [{\"field\": \"energy\"}]}", "s.json:2:", "energy"},
        {"\"slide\": {\"number\": 0}", "s.json:2:11", "from 1"},
        {"\"slide\": {}, \"beside\": {}", "s.json:2:14", "one run"},
        {"\"layout\": {\"layout\": \"deckk\"}", "s.json:2:12", "did you mean 'deck'"},
        {"\"layout\": {\"tab\": \"plot\"}", "s.json:2:12", "did you mean 'plots'"},
        {"\"plots\": {\"shown\": [\"enrgy\"]}", "s.json:2:", "did you mean 'energy'"},
        {"\"plots\": {\"plots\": {\"pin 1\": {}}}", "s.json:2:21", "no plot is called 'pin 1'"},
        {"\"plots\": {\"plots\": {\"energy\": {\"x\": [1, 0]}}}", "s.json:2:32", "the lower one"},
        {"\"plots\": {\"across\": [0, 2]}", "s.json:2:11", "from 0 to 1"},
        {"\"atlas\": {\"across\": {\"key\": \"mass\"}}", "s.json:2:1", "'across' and 'up'"},
        {"\"atlas\": {\"across\": {\"key\": \"mas\"}, \"up\": {\"key\": \"mass\"}}", "s.json:2:", "did you mean 'mass'"},
        {"\"atlas\": {\"across\": {\"key\": \"mass\"}, \"up\": {\"key\": \"mass\"}}", "s.json:2:", "the same parameter"},
        {"\"atlas\": {\"across\": {\"key\": \"mass\", \"range\": [-1, 1]}, \"up\": {\"key\": \"time_step\"}}",
         "s.json:2:", "mass"},
    }));
    const std::string scene = std::string("{\"pliant\": 2, \"lesson\": \"time/bead_chain\",\n") + text + "}";
    INFO(scene);
    try {
        parse_scene(scene, "s.json");
        FAIL("it was accepted");
    } catch (const Refused& e) {
        CHECK_THAT(e.what(), StartsWith(place));
        CHECK_THAT(e.what(), ContainsSubstring(words));
    }
}

TEST_CASE("scene: a key of version 2 in a file of version 1 says which version it needs") {
    for (const char* part : {"\"place\": {}", "\"view\": {\"arrows\": false}", "\"camera\": {\"follows\": true}"})
        CHECK_THAT(([&] {
                       try {
                           parse_scene(std::string("{\"pliant\": 1, \"lesson\": \"time/bead_chain\", ") + part + "}", "s.json");
                       } catch (const Refused& e) {
                           return std::string(e.what());
                       }
                       return std::string("accepted");
                   }()),
                   ContainsSubstring("is of version 2"));
}

TEST_CASE("scene: what was done to a run where it stands is kept apart from what its steps have seen") {
    Runner run(find_lesson("time/bead_chain"));
    run.assign("mass", 0.5);
    run.pull(Pull{1, {0, 0, 0}, {0, 1, 0}});
    // Before the first step both belong to the start.
    CHECK(run_of(run).place == ScenePlace{});
    CHECK(run_of(run).events.size() == 1);
    for (int i = 0; i < 3; ++i) run.step();
    CHECK(run_of(run).place.changes.empty());
    run.assign("mass", 0.25);
    CHECK(run_of(run).place.changes.set == Runner::Assignments{{"mass", "0.25"}});
    CHECK(run_of(run).events.size() == 1);
    run.step_pass();
    CHECK(run_of(run).place.changes.empty());
    CHECK(run_of(run).events.size() == 2);
    run.assign("mass", 0.125);  // from the next step on
    CHECK(run_of(run).place.changes.set == Runner::Assignments{{"mass", "0.125"}});
    CHECK(run_of(run).place.place() == Place{3, 1});
}
