#include "panels/lab_state.h"

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

void search_box(LabState& lab) {
    char buffer[64] = {};
    lab.search.copy(buffer, sizeof buffer - 1);
    if (std::exchange(lab.focus_search, false)) {
        ImGui::SetWindowFocus();  // ImGui gives the keys only to a control of the window that has them already
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    const bool entered =
        ImGui::InputTextWithHint("##search", "find a lesson (F)", buffer, sizeof buffer, ImGuiInputTextFlags_EnterReturnsTrue);
    lab.search = buffer;
    lab.note_control("search");
    if (!entered) return;
    const auto found = std::ranges::find_if(lessons(), [&](const LessonEntry& e) { return matches(e, lab.search); });
    if (found != lessons().end()) lab.session.open(*found);
    lab.search.clear();
}

void preset_menu(LabState& lab) {
    const auto names = preset_names(lab.session.entry().info.id);
    if (names.empty()) return;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##presets", "presets …")) {
        for (const std::string& name : names)
            if (ImGui::Selectable(words(name).c_str())) {
                lab.session.open_scene(preset(lab.session.entry(), name));
                break;
            }
        ImGui::EndCombo();
    }
    lab.note_control("presets");
}

}  // namespace

void draw_lesson_list(LabState& lab) {
    search_box(lab);
    std::string_view chapter;
    for (const LessonEntry& e : lessons()) {
        if (!lab.search.empty() && !matches(e, lab.search)) continue;
        if (e.chapter() != chapter) {
            chapter = e.chapter();
            ImGui::PushFont(lab.fonts.small);
            ImGui::TextDisabled("%s", words(chapter).c_str());
            ImGui::PopFont();
        }
        const bool selected = e.info.id == lab.session.entry().info.id;
        const std::string label = std::string(e.info.title) + "##" + std::string(e.info.id);
        ImGui::Indent(lab.px(6));
        if (ImGui::Selectable(label.c_str(), selected) && !selected) lab.session.open(e);
        lab.note_control("lesson " + std::string(e.info.id));
        tooltip(std::string(e.info.summary), lab.scale);
        ImGui::Unindent(lab.px(6));
    }
    preset_menu(lab);
    if (!find_text(std::string(lab.session.entry().info.id) + "/walkthrough.md").empty()) {
        const bool active = lab.session.walkthrough.has_value();
        if (ImGui::Button(active ? "Leave the walkthrough" : "Walkthrough", {-1, 0}))
            active ? lab.session.walkthrough.reset() : lab.session.start_walkthrough();
        lab.note_control("walkthrough");
    }
}

}  // namespace pliant::viewer
