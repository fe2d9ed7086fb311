// Meshes of one's own on the command line: by path, by the name of a body that comes with Pliant, in scene files; and what is
// refused.
#include "pliant.h"

using namespace pliant::test;

namespace {

const Arguments own{"run", "mesh/fem", "--steps", "1", "--set", "scene=own"};

Arguments with_mesh(const std::string& mesh) { return with(own, {"mesh_file=" + mesh}); }

std::string body(const std::string& name) { return contents_of(fs::path(PLIANT_SOURCE_DIR "/assets/meshes") / name); }

}  // namespace

TEST_CASE("a body is the same by its path and by its name, wherever the program runs", "[process]") {
    const Scratch scratch;
    const std::string path = scratch.file("part.msh", body("plate_with_hole_coarse.msh"));
    const Json by_path = json_of(with_mesh(path)), by_name = json_of(with_mesh("plate_with_hole_coarse")),
               by_file_name = json_of(with_mesh("assets/meshes/plate_with_hole_coarse.msh"));
    CHECK(by_path["probes"] == by_name["probes"]);
    CHECK(by_path["probes"] == by_file_name["probes"]);
    CHECK(by_path["parameters"]["mesh_file"] == path);
    CHECK(by_name["parameters"]["mesh_file"] == "plate_with_hole_coarse");
    CHECK(json_of({"run", "mesh/fem", "--steps", "0"})["parameters"]["mesh_file"] == "none");
}

TEST_CASE("a scene file names its mesh from its own folder, tells of a changed one and refuses a missing one", "[process]") {
    const Scratch scratch;
    scratch.file("part.msh", body("gear_coarse.msh"));
    const auto scene = [&](const std::string& hash) {
        return scratch.file(
            "s.json", R"({"pliant": 1, "lesson": "mesh/fem", "parameters": {"scene": "own", "mesh_file": {"path": "part.msh")" +
                          (hash.empty() ? "" : R"(, "sha256": ")" + hash + '"') + "}}}");
    };
    const Json run = json_of({"run", "--scene", scene(""), "--steps", "1"});
    CHECK(run["probes"] == json_of(with_mesh("gear_coarse"))["probes"]);
    const Outcome changed = call({"run", "--scene", scene("00"), "--steps", "1"});
    CHECK(changed.exit_code == 0);
    CHECK(contains(changed.err, "part.msh has changed since the scene was saved"));
    const std::string shared = output_of({"share", "--scene", scene("")});
    CHECK(json_of({"run", "--scene", shared.substr(0, shared.find('\n')), "--steps", "1"})["probes"] == run["probes"]);
    fs::remove(scratch.path("part.msh"));
    refusal({"run", "--scene", scene("abc"), "--steps", "1"}, {"'part.msh' is not there", "SHA-256 abc"});
}

TEST_CASE("what is no mesh is refused before the first step", "[process]") {
    const Scratch scratch;
    refusal(with_mesh(scratch.path("none.msh")), {"is not there", "hook_coarse"});
    refusal(with_mesh("hook_corse"), {"did you mean 'hook_coarse'?"});
    refusal(with_mesh(scratch.folder().string()), {"is a folder"});
    refusal(with_mesh(scratch.file("a.step", "x")), {"ends in .step"});
    refusal(with_mesh(scratch.file("empty.msh", "")), {"empty.msh"});
    std::string without_groups = body("gear_coarse.msh");
    without_groups.replace(without_groups.find("\"fixed\""), 7, "\"other\"");
    refusal(with_mesh(scratch.file("groups.msh", without_groups)), {"the group 'fixed'", "other"});
    CHECK(contains(call({"run", "mesh/fem", "--steps", "0", "--set", "mesh_file=hook_coarse"}).err,
                   "mesh_file is used with scene=own"));
}
