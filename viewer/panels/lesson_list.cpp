#include "panels/lesson_list.h"

#include "panels/flowing_text.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace pliant::viewer {
namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

bool matches(const LessonEntry& e, const std::string& search) {
    const std::string wanted = lower(search);
    for (const std::string_view text : {e.info.id, e.info.title, e.info.summary})
        if (lower(text).find(wanted) != std::string::npos) return true;
    return false;
}

void search_box(PanelContext& lab, LessonListState& panel) {
    char buffer[64] = {};
    panel.search.copy(buffer, sizeof buffer - 1);
    if (std::exchange(panel.focus, false)) {
        ImGui::SetWindowFocus();  // ImGui gives the keys only to a control of the window that has them already
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    const bool entered =
        ImGui::InputTextWithHint("##search", "find a lesson (F)", buffer, sizeof buffer, ImGuiInputTextFlags_EnterReturnsTrue);
    panel.search = buffer;
    lab.note_control("search");
    if (!entered) return;
    const auto found = std::ranges::find_if(lessons(), [&](const LessonEntry& e) { return matches(e, panel.search); });
    if (found != lessons().end()) lab.session.open(*found);
    panel.search.clear();
}

void preset_menu(PanelContext& lab) {
    const auto names = preset_names(lab.session.entry().info.id);
    if (names.empty()) return;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##presets", "presets …")) {
        for (const std::string& name : names)
            if (ImGui::Selectable(words(name).c_str())) {
                lab.wanted_scenes.push_back(preset(lab.session.entry(), name));
                break;
            }
        ImGui::EndCombo();
    }
    lab.note_control("presets");
}

bool has_walkthrough(const PanelContext& lab) {
    return !find_text(std::string(lab.session.entry().info.id) + "/walkthrough.md").empty();
}

// The chapters and their lessons. The open one is scrolled to when another was open before.
void names_of_lessons(PanelContext& lab, LessonListState& panel) {
    const bool opened = panel.listed != lab.session.entry().info.id;
    panel.listed = lab.session.entry().info.id;
    std::string_view chapter;
    for (const LessonEntry& e : lessons()) {
        if (!panel.search.empty() && !matches(e, panel.search)) continue;
        if (e.chapter() != chapter) {
            chapter = e.chapter();
            ImGui::PushFont(lab.fonts.small);
            ImGui::TextDisabled("%s", words(chapter).c_str());
            ImGui::PopFont();
        }
        const bool selected = e.info.id == lab.session.entry().info.id;
        ImGui::Indent(lab.px(6));
        // A long name takes a second line.
        const std::string title = flowing_text(std::string(e.info.title), ImGui::GetFont(), ImGui::GetContentRegionAvail().x);
        const std::string label = title + "##" + std::string(e.info.id);
        if (ImGui::Selectable(label.c_str(), selected) && !selected) lab.session.open(e);
        lab.note_control("lesson " + std::string(e.info.id));
        tooltip(std::string(e.info.summary), lab.scale);
        if (selected && opened) ImGui::SetScrollHereY();
        ImGui::Unindent(lab.px(6));
    }
}

}  // namespace

void draw_lesson_list(PanelContext& lab, LessonListState& panel) {
    search_box(lab, panel);
    // What belongs to the open lesson stays in sight below the names.
    const int rows = (preset_names(lab.session.entry().info.id).empty() ? 0 : 1) + (has_walkthrough(lab) ? 1 : 0);
    const float below = static_cast<float>(rows) * ImGui::GetFrameHeightWithSpacing();
    ImGui::BeginChild("names",
                      {0, std::max(ImGui::GetContentRegionAvail().y - below, 3 * ImGui::GetTextLineHeightWithSpacing())});
    names_of_lessons(lab, panel);
    ImGui::EndChild();
    lab.note_control("lessons");
    preset_menu(lab);
    if (has_walkthrough(lab)) {
        const bool active = lab.session.walkthrough.has_value();
        if (ImGui::Button(active ? "Leave the walkthrough" : "Walkthrough", {-1, 0}))
            active ? lab.session.end_walkthrough() : lab.session.start_walkthrough();
        lab.note_control("walkthrough");
    }
}

}  // namespace pliant::viewer
