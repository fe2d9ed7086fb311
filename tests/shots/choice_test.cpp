// The list of a choice, opened by the mouse: its words can be read, and one of them can be chosen.
#include "app/lab.h"
#include "parameters.h"
#include "platform/headless_context.h"

#include <imgui.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <memory>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

struct Hand {
    std::unique_ptr<Context> context = open_headless({1280, 900});
    Lab lab{*context, "mesh/mass_spring"};

    void frames(int count) {
        for (int i = 0; i < count; ++i) lab.frame(0), context->present();
    }
    void click(float x, float y) {
        ImGuiIO& io = ImGui::GetIO();
        io.AddMousePosEvent(x, y);
        frames(1);
        io.AddMouseButtonEvent(0, true);
        frames(1);
        io.AddMouseButtonEvent(0, false);
        frames(3);
    }
};

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
    Hand hand;
    hand.frames(3);
    const Session& session = hand.lab.session();
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
