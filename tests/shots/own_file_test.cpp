// A body of one's own in the lab: dropped on the window, chosen in the dialog or in the list, read again; what is refused leaves
// the old one.
#include "../process/process.h"
#include "lab_hand.h"
#include "parameters.h"

#include <pliant/text/file.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string bodies_folder = PLIANT_SOURCE_DIR "/assets/meshes/";

std::string text_of(LabHand& hand, std::string_view key) {
    const Parameter& p = hand.session().lesson().parameter(key);
    return p.text(hand.session().runner().wanted(p));
}

}  // namespace

TEST_CASE("a mesh that is dropped on the window is the body; undo brings the former one back", "[lab]") {
    const Scratch scratch;
    const std::string part = scratch.file("part.msh", read_file(bodies_folder + "plate_with_hole_coarse.msh"));
    LabHand hand("mesh/fem");
    const std::string scene = text_of(hand, "scene"), before = text_of(hand, "mesh_file");
    hand.lab().drop_file(part);
    hand.frames(3);
    CHECK(text_of(hand, "mesh_file") == part);
    CHECK(text_of(hand, "scene") == "own");
    CHECK(hand.told().empty());

    // Broken ones are told, and the body stays.
    const std::string broken = scratch.file("broken.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
    for (const std::string& other : {broken, scratch.path("none.msh"), scratch.file("empty.msh", "")}) {
        hand.lab().drop_file(other);
        hand.frames(3);
        CHECK_THAT(hand.told(), ContainsSubstring(fs::path(other).filename().string()));
        CHECK(hand.session().message()->kind == Session::Message::Kind::refused);
        CHECK(text_of(hand, "mesh_file") == part);
        CHECK(text_of(hand, "scene") == "own");
    }
    hand.session().undo();
    CHECK(text_of(hand, "mesh_file") == before);
    CHECK(text_of(hand, "scene") == scene);
}

TEST_CASE("a mesh that is dropped on a lesson without bodies is told where it belongs", "[lab]") {
    LabHand hand("mesh/rod");
    hand.lab().drop_file(bodies_folder + "hook_coarse.msh");
    hand.frames(2);
    CHECK_THAT(hand.told(), ContainsSubstring("the lesson that is open reads no such file"));
}

TEST_CASE("a mesh is chosen in a scene that has no use for one, and is used then", "[lab]") {
    LabHand hand("mesh/fem", {1280, 1100});
    const Parameter& p = hand.session().lesson().parameter("mesh_file");
    REQUIRE_FALSE(p.used());
    hand.session().choose_file(p, "gear_coarse");
    CHECK(text_of(hand, "mesh_file") == "gear_coarse");
    CHECK(text_of(hand, "scene") == "own");
}

TEST_CASE("a mesh is chosen in the dialog and in the list, and read again when it has changed", "[lab]") {
    const Scratch scratch;
    const std::string part = scratch.file("part.msh", read_file(bodies_folder + "plate_with_hole_coarse.msh"));
    LabHand hand("mesh/fem", {1280, 1100});
    hand.lab().drop_file(part);
    for (const Group group : all_groups) open_heading(hand.state(), hand.state().parameters, group, false);
    open_heading(hand.state(), hand.state().parameters, hand.session().lesson().parameter("mesh_file").info.group, true);
    hand.frames(4);

    write_file(part, read_file(bodies_folder + "gear_coarse.msh"));
    const Real plate = hand.value("mesh_file");
    hand.click("again mesh_file");
    hand.frames(3);
    CHECK(text_of(hand, "mesh_file") == part);
    CHECK(hand.value("mesh_file") != plate);
    hand.click("again mesh_file");
    hand.frames(3);
    CHECK_THAT(hand.told(), ContainsSubstring("part.msh is the same as before"));

    hand.click("open mesh_file");
    hand.frames(3);
    REQUIRE(hand.state().files.asking());
    hand.state().files.name = scratch.path("none.msh");
    hand.state().files.accept();
    hand.frames(3);
    CHECK(hand.state().files.asking());
    CHECK_FALSE(hand.state().files.complaint().empty());
    hand.state().files.name = bodies_folder + "hook_coarse.msh";
    hand.state().files.accept();
    hand.frames(4);
    CHECK_FALSE(hand.state().files.asking());
    CHECK(text_of(hand, "mesh_file") == bodies_folder + "hook_coarse.msh");

    hand.click("mesh_file");
    hand.frames(2);
    hand.click("mesh_file beam_coarse");
    hand.frames(3);
    CHECK(text_of(hand, "mesh_file") == "beam_coarse");
    CHECK(text_of(hand, "scene") == "own");
}
