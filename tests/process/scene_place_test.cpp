// `pliant run` and `pliant shot` go as far as the scene says, with what stands beside it.
#include "pliant.h"

using namespace pliant::test;

namespace {

const std::string rod_scene = R"({"pliant": 2, "lesson": "mesh/rod", "parameters": {"scene": "released"},
 "place": {"step": 5, "passes": 1}, "beside": {"set": {"segments": 20}}})";

Json placed_run(const Scratch& scratch, std::vector<std::string> more) {
    std::vector<std::string> arguments{"run", "--scene", scratch.file("a.scene.json", rod_scene), "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Json::parse(output_of(arguments));
}

}  // namespace

TEST_CASE("a run goes to the place of its scene, inside a step, and B with it", "[process]") {
    const Scratch scratch;
    const Json there = placed_run(scratch, {});
    CHECK(there["steps"] == 5);
    CHECK(there["passes"] == 1);
    CHECK(there["parameters"]["segments"] == 10);
    CHECK(there["beside"]["parameters"]["segments"] == 20);
    CHECK(there["beside"]["time"].get<double>() <= there["time"].get<double>());
    // What is asked for wins.
    const Json further = placed_run(scratch, {"--steps", "8"});
    CHECK(further["steps"] == 8);
    CHECK_FALSE(further.contains("passes"));
    CHECK(further["beside"]["time"].get<double>() > there["beside"]["time"].get<double>());
}

TEST_CASE("a picture of a scene shows its place and both runs", "[process]") {
    const Scratch scratch;
    const std::string path = scratch.file("a.scene.json", rod_scene);
    const auto picture = [&](const std::string& name, std::vector<std::string> more) {
        std::vector<std::string> arguments{"shot", "--scene", path, "--size", "640x360", "--out", scratch.path(name)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        output_of(arguments);
        return contents_of(scratch.path(name));
    };
    // The layout is that of the scene, and what is asked for wins.
    const std::string there = picture("a.png", {});
    CHECK(picture("b.png", {"--steps", "60"}) != there);
    CHECK(picture("c.png", {"--layout", "slide"}) != there);
}
