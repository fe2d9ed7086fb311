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

constexpr int no_rank = 4;

// Of a hit, the best being 0. In an id the name behind the chapter counts, and words in place of underscores are as good.
int rank_of_hit(const LessonEntry& e, const std::string& wanted) {
    const std::string title = lower(e.info.title), id = lower(e.info.id), name = id.substr(id.find('/') + 1);
    int best = no_rank;
    for (const std::string& text : {title, id, name, lower(words(name))}) {
        const auto at = text.find(wanted);
        if (at != std::string::npos) best = std::min(best, at > 0 ? 2 : text.size() > wanted.size() ? 1 : 0);
    }
    if (best == no_rank && lower(e.info.summary).find(wanted) != std::string::npos) return no_rank - 1;
    return best;
}

int move_mark(ImGuiInputTextCallbackData* data) {
    *static_cast<int*>(data->UserData) += data->EventKey == ImGuiKey_DownArrow ? 1 : -1;
    return 0;
}

void search_box(PanelContext& lab, LessonListState& panel) {
    char buffer[64] = {};
    panel.search.copy(buffer, sizeof buffer - 1);
    if (std::exchange(panel.focus, false)) {
        ImGui::SetWindowFocus();  // ImGui gives the keys only to a control of the window that has them already
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    const bool entered = ImGui::InputTextWithHint("##search", "find a lesson (F)", buffer, sizeof buffer,
                                                  ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory,
                                                  move_mark, &panel.marked);
    if (std::exchange(panel.search, buffer) != buffer) panel.marked = 0;
    lab.note_control("search");
    const auto found = found_lessons(panel.search);
    panel.marked = std::clamp(panel.marked, 0, std::max(0, static_cast<int>(found.size()) - 1));
    if (!entered) return;
    if (!found.empty() && !panel.search.empty()) lab.session.open(*found[static_cast<std::size_t>(panel.marked)]);
    panel.search.clear();
    panel.marked = 0;
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
    const bool searched = !panel.search.empty();
    const auto found = found_lessons(panel.search);
    std::string_view chapter;
    for (std::size_t k = 0; k < found.size(); ++k) {
        const LessonEntry& e = *found[k];
        if (e.chapter() != chapter) {
            chapter = e.chapter();
            ImGui::PushFont(lab.fonts.small);
            ImGui::TextDisabled("%s", words(chapter).c_str());
            ImGui::PopFont();
        }
        const bool is_open = e.info.id == lab.session.entry().info.id,
                   selected = searched ? static_cast<int>(k) == panel.marked : is_open;
        ImGui::Indent(lab.px(6));
        // A long name takes a second line.
        const std::string title = flowing_text(std::string(e.info.title), ImGui::GetFont(), ImGui::GetContentRegionAvail().x);
        const std::string label = title + "##" + std::string(e.info.id);
        if (ImGui::Selectable(label.c_str(), selected) && !is_open) lab.session.open(e);
        lab.note_control("lesson " + std::string(e.info.id));
        tooltip(std::string(e.info.summary), lab.scale);
        if (selected && (opened || searched)) ImGui::SetScrollHereY();
        ImGui::Unindent(lab.px(6));
    }
}

}  // namespace

std::vector<const LessonEntry*> found_lessons(std::string_view search) {
    std::vector<const LessonEntry*> found;
    const std::string wanted = lower(search);
    for (const LessonEntry& e : lessons())
        if (rank_of_hit(e, wanted) < no_rank) found.push_back(&e);
    if (!wanted.empty()) std::ranges::stable_sort(found, {}, [&](const LessonEntry* e) { return rank_of_hit(*e, wanted); });
    return found;
}

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
