#include "app/keys.h"
#include "panels/lab_state.h"

#include <string_view>
#include <utility>
#include <vector>

namespace pliant::viewer {

void draw_help(LabState& lab) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::Begin("Keys and mouse", &lab.help_shown,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse);
    std::vector<std::pair<std::string_view, std::string_view>> rows;
    for (const KeyBinding& b : key_bindings()) rows.emplace_back(b.keys, b.meaning);
    rows.emplace_back("left drag", "pull the body; beside it, turn (3D) or move (2D)");
    rows.emplace_back("right drag", "move the picture");
    rows.emplace_back("wheel", "zoom");
    rows.emplace_back("Ctrl+click", "type a slider's number");
    rows.emplace_back("double click", "a slider's default");
    // In two halves side by side.
    const std::size_t half = (rows.size() + 1) / 2;
    if (ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) {
        const auto cell = [](std::string_view text) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(text.data(), text.data() + text.size());
        };
        for (std::size_t i = 0; i < half; ++i) {
            ImGui::TableNextRow();
            cell(rows[i].first), cell(rows[i].second);
            if (i + half < rows.size()) cell(rows[i + half].first), cell(rows[i + half].second);
        }
        ImGui::EndTable();
    }
    ImGui::TextDisabled("F1 closes this.");
    ImGui::End();
}

}  // namespace pliant::viewer
