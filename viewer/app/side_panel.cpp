// The tabs at the right: plots, inspector, claims, atlas.
#include "app/lab_state.h"

#include <array>
#include <functional>
#include <utility>

namespace pliant::viewer {
namespace {

struct Tab {
    SideTab tab;
    const char* title;
    const char* name;  // of the control
    const char* help;
    std::function<void()> draw;
};

}  // namespace

void draw_side(LabState& lab) {
    if (!ImGui::BeginTabBar("side")) return;
    const std::array<Tab, 5> tabs{
        {{SideTab::plots, "Plots", "tab plots", "The numbers of the run over time, and its profiles",
          [&] { draw_plots(lab, lab.plots); }},
         {SideTab::inspect, "Inspect", "tab inspect", "All numbers of the picked thing, and why they are what they are (I)",
          [&] { draw_inspector(lab, lab.inspector); }},
         {SideTab::claims, "Claims", "tab claims", "What the lectures say of this lesson: predict, then measure (K)",
          [&] { draw_claims(lab, lab.claims); }},
         {SideTab::atlas, "Atlas", "tab atlas", "Where this lesson is stable, over two of its parameters (W)",
          [&] { draw_atlas(lab, lab.atlas); }},
         {SideTab::methods, "Methods", "tab methods",
          "All methods of the lesson in this scene: what lasts, its error and cost (Y)",
          [&] { draw_methods(lab, lab.methods); }}}};
    const auto wanted = std::exchange(lab.side_wanted, std::nullopt);
    for (const Tab& t : tabs) {
        const bool shown = ImGui::BeginTabItem(t.title, nullptr, wanted == t.tab ? ImGuiTabItemFlags_SetSelected : 0);
        lab.note_control(t.name);
        tooltip(t.help, lab.scale);
        if (!shown) continue;
        lab.side = t.tab;
        const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
        t.draw();
        if (t.tab == SideTab::atlas) lab.note_fillable({at.x, at.y, room.x, room.y}, {Filled::atlas, ""});
        ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
}

}  // namespace pliant::viewer
