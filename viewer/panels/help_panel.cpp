#include "app/keys.h"
#include "panels/lab_state.h"

namespace pliant::viewer {

void draw_help(LabState& lab) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::Begin("Keys and mouse", &lab.help_shown,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse);
    if (ImGui::BeginTable("keys", 2)) {
        const auto row = [](std::string_view keys, std::string_view meaning) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(keys.data(), keys.data() + keys.size());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(meaning.data(), meaning.data() + meaning.size());
        };
        for (const KeyBinding& b : key_bindings())
            if (!b.keys.empty()) row(b.keys, b.meaning);
        row("left drag", "pull the body; beside it, turn (3D) or move (2D) the picture");
        row("right drag", "move the picture");
        row("wheel", "zoom");
        row("Ctrl+click", "type a slider's number");
        row("double click", "a slider's default");
        ImGui::EndTable();
    }
    ImGui::TextDisabled("F1 closes this.");
    ImGui::End();
}

}  // namespace pliant::viewer
