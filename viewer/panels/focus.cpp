// Where the keys act: the panel that they go to, and a ring that shows the control.
#include "panels/focus.h"

#include <imgui_internal.h>

#include <algorithm>
#include <vector>

namespace pliant::viewer {
namespace {

// The panels of the present layout, in the order in which they are drawn.
std::vector<ImGuiWindow*> panels() {
    std::vector<ImGuiWindow*> found;
    constexpr int passed_over = ImGuiWindowFlags_ChildWindow | ImGuiWindowFlags_Popup | ImGuiWindowFlags_Tooltip |
                                ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoNavFocus | ImGuiWindowFlags_MenuBar;
    for (ImGuiWindow* w : ImGui::GetCurrentContext()->Windows)
        if (w->WasActive && !w->Hidden && !(w->Flags & passed_over) && w->DC.NavLayersActiveMask != 0) found.push_back(w);
    std::ranges::sort(found, {}, &ImGuiWindow::BeginOrderWithinContext);
    return found;
}

}  // namespace

void focus_panel(int direction) {
    const auto all = panels();
    if (all.empty()) return;
    ImGuiContext& g = *ImGui::GetCurrentContext();
    const int count = static_cast<int>(all.size());
    const ImGuiWindow* here = g.NavWindow ? g.NavWindow->RootWindow : nullptr;
    const int at = static_cast<int>(std::ranges::find(all, here) - all.begin());
    const int next = at == count ? (direction > 0 ? 0 : count - 1) : (at + direction + count) % count;
    ImGuiWindow* panel = all[static_cast<std::size_t>(next)];
    ImGui::ClearActiveID();
    ImGui::FocusWindow(panel);
    g.NavLayer = ImGuiNavLayer_Main;
    ImGui::NavInitWindow(panel, false);
    g.NavDisableHighlight = false;
    g.NavDisableMouseHover = true;
}

void focus_last_item() {
    ImGui::SetFocusID(ImGui::GetItemID(), ImGui::GetCurrentWindow());
    ImGui::GetCurrentContext()->NavDisableHighlight = false;
}

namespace {

// In a deck, where most keys are those of the slides: what the control that has them takes.
void say_keys(PanelContext& lab, const ImRect& ring) {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    lab.focus_words = g.IO.WantTextInput ? "Enter takes it, Escape leaves it; then the keys are the deck's again"
                                         : "Enter acts on this; Space and the arrows are the deck's, Escape lets go";
    ImGui::PushFont(lab.fonts.small);
    const ImVec2 size = ImGui::CalcTextSize(lab.focus_words.c_str()), room = g.IO.DisplaySize;
    const float pad = lab.px(5), height = size.y + 2 * pad, width = size.x + 2 * pad;
    ImVec2 at{std::clamp(ring.Min.x, 0.f, std::max(0.f, room.x - width)), ring.Min.y - height - lab.px(3)};
    if (at.y < 0) at.y = ring.Max.y + lab.px(3);
    ImDrawList* draw = ImGui::GetForegroundDrawList();
    draw->AddRectFilled(at, {at.x + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_NavHighlight), lab.px(4));
    draw->AddText({at.x + pad, at.y + pad}, packed(palette(lab.theme).background), lab.focus_words.c_str());
    ImGui::PopFont();
}

}  // namespace

void draw_focus(PanelContext& lab) {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    lab.focus.reset();
    lab.focus_words.clear();
    if (!g.NavWindow || g.NavId == 0 || g.NavDisableHighlight || g.NavWindow->Hidden) return;
    ImRect r = ImGui::WindowRectRelToAbs(g.NavWindow, g.NavWindow->NavRectRel[g.NavLayer]);
    if (g.NavLayer == ImGuiNavLayer_Main) r.ClipWith(g.NavWindow->InnerRect);
    if (r.GetWidth() <= 0 || r.GetHeight() <= 0) return;
    lab.focus = Rectangle{r.Min.x, r.Min.y, r.GetWidth(), r.GetHeight()};
    r.Expand(lab.px(2));
    const float line = std::max(3.f, lab.px(3));
    ImGui::GetForegroundDrawList()->AddRect(r.Min, r.Max, packed(palette(lab.theme).background), lab.px(4), 0, 2 * line);
    ImGui::GetForegroundDrawList()->AddRect(r.Min, r.Max, ImGui::GetColorU32(ImGuiCol_NavHighlight), lab.px(4), 0, line);
    if (lab.layout == Layout::deck && !lab.session.autopsy()) say_keys(lab, r);
}

}  // namespace pliant::viewer
