
#include "panels/summary_panel.h"

namespace pliant::viewer {

void draw_summary(PanelContext& lab, SummaryPanelState& panel) {
    if (panel.text.empty()) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(lab.px(620), display.x * 0.8f);
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, display.y * 0.85f});
    bool open = true;
    ImGui::Begin("Summary", &open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse);
    ImGui::PushTextWrapPos(width - lab.px(16));
    ImGui::TextUnformatted(panel.text.c_str());
    ImGui::PopTextWrapPos();
    if (ImGui::Button("Copy")) ImGui::SetClipboardText(panel.text.c_str());
    lab.note_control("copy summary");
    tooltip("Copy these sentences", lab.scale);
    ImGui::SameLine();
    if (ImGui::Button("Close")) open = false;
    lab.note_control("close summary");
    tooltip("Close this (S or Escape)", lab.scale);
    ImGui::End();
    if (!open) panel.text.clear();
}

}  // namespace pliant::viewer
