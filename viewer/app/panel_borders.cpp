#include "app/panel_borders.h"

#include "app/lab_state.h"

#include <imgui_internal.h>

#include <algorithm>

namespace pliant::viewer {
namespace {

constexpr float thickness = 6;  // px at scale 1, of what takes the mouse
constexpr const char* all_names[]{"border left", "border right", "border plots", "border lessons", "border walkthrough"};

// A window of its own, which holds nothing but the border.
bool begin(const char* name, ImVec2 at, ImVec2 size) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize(size);
    const bool open = ImGui::Begin(name, nullptr,
                                   ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav |
                                       ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar(3);
    return open;
}

}  // namespace

void make_borders() {
    for (const char* name : all_names) begin(name, {-10, -10}, {1, 1}), ImGui::End();
}

float size_at_border(LabState& lab, const PanelBorder& b, const PanelReach& reach, std::optional<float>& kept) {
    const float most = std::max(reach.least, reach.most), wide = lab.px(thickness);
    const auto clamped = [&](float size) { return std::clamp(size, reach.least, most); };
    float size = clamped(kept ? *kept * b.unit : reach.usual);
    const auto place = [&] {
        const float middle = b.edge + b.direction * size - wide / 2;
        return b.sideways ? Rectangle{middle, b.from, wide, b.length} : Rectangle{b.from, middle, b.length, wide};
    };
    const Rectangle before = place();
    begin(b.name, {before.x, before.y}, {before.width, before.height});
    ImGui::InvisibleButton("border", {std::max(before.width, 1.f), std::max(before.height, 1.f)});
    lab.note_control(b.name);
    const bool active = ImGui::IsItemActive(), shown = active || ImGui::IsItemHovered();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float pointer = (b.direction * ((b.sideways ? mouse.x : mouse.y) - b.edge));
    if (ImGui::IsItemActivated()) lab.border_grip = pointer - size;
    if (active && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        kept.reset();
        size = clamped(reach.usual);
        ImGui::ClearActiveID();  // else the button that is still down would drag it again
    } else if (active && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
        size = clamped(pointer - lab.border_grip);
        kept = size / b.unit;
    }
    ImGui::End();
    if (!shown) return size;
    ImGui::SetMouseCursor(b.sideways ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const Rectangle now = place();
    const float line = std::max(1.f, lab.px(2)), x = now.x + now.width / 2, y = now.y + now.height / 2;
    ImGui::GetForegroundDrawList()->AddLine(b.sideways ? ImVec2{x, now.y} : ImVec2{now.x, y},
                                            b.sideways ? ImVec2{x, now.y + now.height} : ImVec2{now.x + now.width, y},
                                            lab.ink(Ink::accent, active ? 0.9f : 0.5f), line);
    return size;
}

}  // namespace pliant::viewer
