#include "panels/help_panel.h"

#include <imgui.h>

#include "panels/keys.h"

#include <string_view>
#include <vector>

namespace pliant::viewer {

void draw_help(bool& shown) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::Begin("Keys and mouse", &shown,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse);
    const std::vector<KeyRow> rows = key_rows();
    const std::size_t half = (rows.size() + 1) / 2;
    if (ImGui::BeginTable("keys", 4)) {
        const auto cell = [](std::string_view text) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(text.data(), text.data() + text.size());
        };
        for (std::size_t i = 0; i < half; ++i)
            for (const std::size_t row : {i, i + half})
                if (row < rows.size()) cell(rows[row].text()), cell(rows[row].meaning);
        ImGui::EndTable();
    }
    ImGui::TextDisabled("F1 closes this.");
    ImGui::End();
}

}  // namespace pliant::viewer
