// The tabs at the right: plots, inspector, claims, atlas.
#include "panels/lab_state.h"

#include <array>
#include <utility>

namespace pliant::viewer {
namespace {

struct Tab {
    const char* title;
    const char* name;  // of the control
    const char* help;
    bool* choose;  // brings it to the front; null when nothing asks for it
    bool* shown;
    void (*draw)(LabState&);
};

}  // namespace

void draw_side(LabState& lab) {
    if (!ImGui::BeginTabBar("side")) return;
    bool plots_shown = false;
    const std::array<Tab, 4> tabs{
        {{"Plots", "tab plots", "The numbers of the run over time, and its profiles", nullptr, &plots_shown, draw_plots},
         {"Inspect", "tab inspect", "All numbers of the picked thing, and why they are what they are (I)", &lab.choose_inspector,
          &lab.show_inspector, draw_inspector},
         {"Claims", "tab claims", "What the lectures say of this lesson: predict, then measure (K)", &lab.choose_claims,
          &lab.show_claims, draw_claims},
         {"Atlas", "tab atlas", "Where this lesson is stable, over two of its parameters (W)", &lab.choose_atlas, &lab.show_atlas,
          draw_atlas}}};
    for (const Tab& t : tabs) {
        const bool choose = t.choose && std::exchange(*t.choose, false);
        *t.shown = ImGui::BeginTabItem(t.title, nullptr, choose ? ImGuiTabItemFlags_SetSelected : 0);
        lab.note_control(t.name);
        tooltip(t.help, lab.scale);
        if (!*t.shown) continue;
        t.draw(lab);
        ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
}

}  // namespace pliant::viewer
