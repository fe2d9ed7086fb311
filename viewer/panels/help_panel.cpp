#include "panels/help_panel.h"

#include "panels/flowing_text.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pliant::viewer {
namespace {

struct GroupOfKeys {
    std::string_view heading;
    std::vector<KeyRow> rows;
};

std::vector<GroupOfKeys> groups_of_keys(std::string_view search) {
    std::vector<GroupOfKeys> groups;
    for (const KeyRow& row : key_rows(search)) {
        if (groups.empty() || groups.back().heading != heading_of(row.group)) groups.push_back({heading_of(row.group), {}});
        groups.back().rows.push_back(row);
    }
    return groups;
}

// Keys, and beside them what they do, in as many lines as that takes.
void draw_group(PanelContext& lab, const GroupOfKeys& group, float keys_width, float width) {
    ImGui::PushStyleColor(ImGuiCol_Text, lab.ink(Ink::accent));
    ImGui::TextUnformatted(group.heading.data(), group.heading.data() + group.heading.size());
    ImGui::PopStyleColor();
    for (const KeyRow& row : group.rows) {
        const float left = ImGui::GetCursorPosX();
        ImGui::TextUnformatted(row.text().c_str());
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + keys_width);
        ImGui::TextUnformatted(flowing_text(std::string(row.meaning), ImGui::GetFont(), width - keys_width).c_str());
    }
    ImGui::Spacing();
}

// In two columns where there is room; a group stays together.
void draw_table_of_keys(PanelContext& lab, const std::vector<GroupOfKeys>& groups) {
    float keys_width = 0;
    std::size_t lines = 0;
    for (const GroupOfKeys& g : groups) {
        lines += g.rows.size() + 2;
        for (const KeyRow& row : g.rows) keys_width = std::max(keys_width, ImGui::CalcTextSize(row.text().c_str()).x);
    }
    keys_width += lab.px(14);
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns = room > lab.px(760) ? 2 : 1;
    if (!ImGui::BeginTable("keys", columns)) return;
    ImGui::TableNextColumn();
    std::size_t done = 0;
    bool second = false;
    for (const GroupOfKeys& g : groups) {
        if (columns == 2 && !second && 2 * done + g.rows.size() > lines) second = true, ImGui::TableNextColumn();
        draw_group(lab, g, keys_width, ImGui::GetContentRegionAvail().x);
        done += g.rows.size() + 2;
    }
    ImGui::EndTable();
}

}  // namespace

void draw_help(PanelContext& lab, HelpPanelState& panel, bool& shown) {
    if (!shown) return void(panel.opened = false);
    const bool opens = !std::exchange(panel.opened, true);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(0.96f * display.x, lab.px(1080)), std::min(0.94f * display.y, lab.px(780))});
    if (opens) ImGui::SetNextWindowFocus(), panel.search = {};
    ImGui::Begin(
        "Keys and mouse", &shown,
        ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse);
    // While the search has the keys, those that close the table are seen here alone.
    if (ImGui::GetIO().WantTextInput && (ImGui::IsKeyPressed(ImGuiKey_Escape, false) || ImGui::IsKeyPressed(ImGuiKey_F1, false)))
        shown = false;
    if (opens) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(std::min(lab.px(300), 0.6f * ImGui::GetContentRegionAvail().x));
    ImGui::InputTextWithHint("##search", "search: a key, or what it does", panel.search.data(), panel.search.size());
    lab.note_control("help search");
    ImGui::SameLine();
    ImGui::TextDisabled("F1 or Escape closes this.");
    ImGui::BeginChild("table of keys", {0, 0}, ImGuiChildFlags_None, ImGuiWindowFlags_NavFlattened);
    const std::vector<GroupOfKeys> groups = groups_of_keys(panel.search.data());
    if (groups.empty()) ImGui::TextDisabled("No key does that. F lists the lessons; the menus have what has no key.");
    draw_table_of_keys(lab, groups);
    ImGui::EndChild();
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    lab.controls["help"] = {at.x, at.y, size.x, size.y};
    ImGui::End();
}

}  // namespace pliant::viewer
