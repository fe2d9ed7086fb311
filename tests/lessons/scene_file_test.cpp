#include <pliant/document/scene_file.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

TEST_CASE("scene file: everything is read back as it was written") {
    SceneFile scene{.lesson = "time/bead_chain", .parameters = {{"stiffness", "123.456789012345678"}, {"mass", "0.1"}}};
    scene.camera = Camera{{0.1, -2, 3e-7}, 4.5, 0.6, -0.25};
    scene.view = SceneView{"force", -1, "kick"};
    scene.events = {{.step = 3, .assign = {{"stiffness", "7"}}},
                    {.step = 9, .pull = Pull{2, {0, 0, 0}, {0, 1, 0.5}}},
                    {.step = 12, .release = true}};
    const SceneFile again = parse_scene(scene_text(scene), "s.json");
    CHECK(again.lesson == scene.lesson);
    CHECK(again.camera == scene.camera);
    CHECK(again.view == scene.view);
    CHECK(scene_text(again) == scene_text(scene));
    REQUIRE(again.events.size() == 3);
    CHECK(again.events[1].pull->to == Vec<3>(0, 1, 0.5));
    CHECK(again.events[2].release);
}

TEST_CASE("scene file: what does not belong is refused with file, line and column") {
    struct Case {
        const char *text, *place, *words;
    };
    const auto [text, place, words] = GENERATE(values<Case>({
        {"", "s.json:1:", "JSON"},
        {"{\"pliant\": 1,\n \"lesson\": \"time/bead_chain\"", "s.json:2:", "JSON"},
        {"[1]", "s.json:1:1", "object"},
        {"{\"lesson\": \"time/bead_chain\"}", "s.json:1:1", "\"pliant\" is missing"},
        {"{\"pliant\": 3, \"lesson\": \"time/bead_chain\"}", "s.json:1:2", "newer"},
        {"{\"pliant\": \"1\", \"lesson\": \"time/bead_chain\"}", "s.json:1:2", "give 1"},
        {"{\"pliant\": 1}", "s.json:1:1", "\"lesson\" is missing"},
        {"{\"pliant\": 1,\n\"lesson\": \"time/bead_chian\"}", "s.json:2:1", "did you mean 'time/bead_chain'"},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\",\n  \"paramters\": {}}", "s.json:2:3", "did you mean 'parameters'"},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\",\n \"parameters\": {\n  \"stifness\": 3}}", "s.json:3:3",
         "did you mean 'stiffness'"},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\",\n \"parameters\": {\n  \"mass\": 1,\n   \"stiffness\": \"3\"}}",
         "s.json:4:4", "number"},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\", \"parameters\": {\"mass\": -3}}", "s.json:1:59",
         "outside the accepted range"},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\", \"parameters\": {\"mass\": 1, \"mass\": 2}}", "s.json:1:70", "twice"},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\", \"view\": {\"field\": \"forse\"}}",
         "s.json:1:", "did you mean 'force'"},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\", \"view\": {\"field\": \"u\", \"component\": 4}}",
         "s.json:1:", "component"},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\", \"camera\": {\"distance\": 0}}", "s.json:1:", "above 0"},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\", \"events\": [{\"set\": {}}]}", "s.json:1:", "step"},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\", \"events\": [{\"step\": 1, \"pull\": {\"to\": [1, 2]}}]}",
         "s.json:1:", "three numbers"},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\", \"parameters\": {\"mass\": 1e999}}", "s.json:1:", ""},
        {"{\"pliant\": 1, \"lesson\": \"time/bead_chain\", \"parameters\": {\"mass\": NaN}}", "s.json:1:", "JSON"},
    }));
    INFO(text);
    try {
        parse_scene(text, "s.json");
        FAIL("it was accepted");
    } catch (const Refused& e) {
        CHECK_THAT(e.what(), StartsWith(place));
        CHECK_THAT(e.what(), ContainsSubstring(words));
    }
}

TEST_CASE("scene file: deep nesting and bytes that are no text are refused, not followed") {
    CHECK_THROWS_AS(parse_scene(std::string(100000, '['), "s.json"), Refused);
    CHECK_THROWS_AS(parse_scene(std::string("{\"pliant\": 1, \"lesson\": \"\xff\xfe\"}"), "s.json"), Refused);
    CHECK_THROWS_AS(parse_scene(std::string("\0\0\0", 3), "s.json"), Refused);
}
