// The list of a choice, opened by the mouse: its words can be read, and one of them can be chosen.
#include "hand.h"
#include "parameters.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

// Everything is drawn with some texture: that of the type, or of a picture.
bool all_textured() {
    const ImDrawData* data = ImGui::GetDrawData();
    return std::ranges::all_of(data->CmdLists, [](const ImDrawList* list) {
        return std::ranges::all_of(list->CmdBuffer,
                                   [](const ImDrawCmd& c) { return c.ElemCount == 0 || c.TextureId != nullptr; });
    });
}

}  // namespace

TEST_CASE("the list of a choice is drawn in the type of the lab, and a click in it chooses", "[session]") {
    Hand hand("mesh/mass_spring", {1280, 900});
    hand.frames(3);
    const Session& session = hand.lab.session();
    open_heading(hand.lab.state(), hand.lab.state().parameters, Group::shape, true);
    open_heading(hand.lab.state(), hand.lab.state().parameters, Group::material, false);
    hand.frames(3);
    REQUIRE(hand.lab.state().controls.contains("lattice"));
    const Rectangle box = hand.lab.state().controls.at("lattice");
    const int before = ImGui::GetDrawData()->CmdListsCount;
    hand.click(box.x + box.width / 2, box.y + box.height / 2);
    CHECK(ImGui::GetDrawData()->CmdListsCount > before);
    CHECK(all_textured());
    const Real chosen = wanted(session, "lattice");
    hand.click(box.x + box.width / 3, box.y + 2.6f * box.height);
    CHECK(wanted(session, "lattice") != chosen);
    CHECK(all_textured());
}
