// The parameters under the headings of their groups, which fold; what the scene does not use is folded away behind the rest.
#include "panels/companion_panel.h"
#include "panels/parameter_panel.h"
#include "panels/typeset_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::viewer {
namespace {

constexpr std::size_t few = 9;  // sliders that stand in sight on a small screen

const Lesson& lesson_of(const PanelContext& lab) { return lab.session.addressed().lesson(); }

std::string unused_key(Group group) { return std::string(key_of(group)) + " unused"; }

std::optional<bool> chosen(const PanelContext& lab, const ParameterPanelState& panel, const std::string& heading) {
    const auto of_lesson = panel.headings.find(std::string(lab.session.entry().info.id));
    if (of_lesson == panel.headings.end()) return std::nullopt;
    const auto found = of_lesson->second.find(heading);
    return found == of_lesson->second.end() ? std::nullopt : std::optional(found->second);
}

void choose(const PanelContext& lab, ParameterPanelState& panel, const std::string& heading, bool open) {
    panel.headings[std::string(lab.session.entry().info.id)][heading] = open;
}

// A slide that locks others names the parameters that a person is to change.
bool slide_names_one(const PanelContext& lab, Group group) {
    const Session& s = lab.session;
    if (!s.walkthrough || s.unlocked || !s.walkthrough->slide().has(BlockKind::controls)) return false;
    return std::ranges::any_of(lesson_of(lab).parameters_of(group),
                               [&](const Parameter* p) { return s.walkthrough->allows(p->info.key); });
}

bool open_at_first(const PanelContext& lab, Group group) {
    const Lesson& lesson = lesson_of(lab);
    const auto used = std::ranges::count_if(lesson.parameters, [](const Parameter* p) { return p->used(); });
    if (static_cast<std::size_t>(used) <= few) return true;
    const std::vector<Group> first = lesson.first_groups();
    return std::ranges::find(first, group) != first.end();
}

// A line with a triangle; true when the person opens or folds it.
bool heading(PanelContext& lab, const std::string& text, const std::string& control, bool open) {
    ImGui::SetNextItemOpen(open, ImGuiCond_Always);
    ImGui::TreeNodeEx((text + "##" + control).c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
    const bool toggled = ImGui::IsItemToggledOpen();
    lab.note_control(control);
    return toggled;
}

bool any_differs(const PanelContext& lab, const std::vector<const Parameter*>& members) {
    if (!lab.session.companion()) return false;
    const auto pairs = differing(lab.session.runner(), lab.session.companion()->runner());
    return std::ranges::any_of(pairs, [&](const Differing& d) {
        return std::ranges::any_of(members, [&](const Parameter* p) { return p->info.key == d.parameter->info.key; });
    });
}

// What the present scene does not use, greyed, each with what it would need.
void unused_part(PanelContext& lab, ParameterPanelState& panel, Group group, const std::vector<const Parameter*>& unused) {
    const bool shown = unused_shown(lab, panel, group);
    ImGui::PushFont(lab.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    const std::string title = fmt::format("{} that this scene does not use", unused.size());
    if (heading(lab, title, "unused " + std::string(key_of(group)), shown)) show_unused(lab, panel, group, !shown);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    if (!shown) return;
    for (const Parameter* p : unused) {
        draw_parameter(lab, panel, *p);
        // To find out takes trials of other parameters, too many for every frame of a drag.
        const std::string* reason = ImGui::IsMouseDown(ImGuiMouseButton_Left) ? panel.usage.known(p->info.key)
                                                                              : &panel.usage.reason(lab.session.addressed(), *p);
        if (!reason) continue;
        ImGui::PushFont(lab.fonts.small);
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
        sentence_item(lab, *reason);
        ImGui::PopStyleColor();
        ImGui::PopFont();
    }
}

void draw_group(PanelContext& lab, ParameterPanelState& panel, Group group, bool headed) {
    const auto members = lesson_of(lab).parameters_of(group);
    if (members.empty()) return;
    std::vector<const Parameter*> used, unused;
    for (const Parameter* p : members) (p->used() ? used : unused).push_back(p);
    const bool open = !headed || heading_open(lab, panel, group);
    if (headed) {
        std::string title(name_of(group));
        if (!open && any_differs(lab, members)) title = "≠ " + title;
        if (!open && !used.empty()) title += fmt::format("  ({})", used.size());
        if (used.empty()) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
        if (heading(lab, title, "group " + std::string(key_of(group)), open)) open_heading(lab, panel, group, !open);
        if (used.empty()) ImGui::PopStyleColor();
    }
    if (!open) return;
    for (const Parameter* p : used) draw_parameter(lab, panel, *p);
    if (!unused.empty()) unused_part(lab, panel, group, unused);
}

void extreme_switch(PanelContext& lab) {
    const bool on = lab.session.extreme;
    if (on) ImGui::PushStyleColor(ImGuiCol_Text, packed(bad_colour));
    ImGui::Checkbox("extreme ranges", &lab.session.extreme);
    if (on) ImGui::PopStyleColor();
    lab.note_control("extreme");
    tooltip("Sliders span all that the solver accepts, far beyond where it works well.", lab.scale);
}

}  // namespace

bool heading_open(const PanelContext& lab, const ParameterPanelState& panel, Group group) {
    if (slide_names_one(lab, group)) return true;
    return chosen(lab, panel, std::string(key_of(group))).value_or(open_at_first(lab, group));
}

bool unused_shown(const PanelContext& lab, const ParameterPanelState& panel, Group group) {
    return chosen(lab, panel, unused_key(group)).value_or(false);
}

void open_heading(const PanelContext& lab, ParameterPanelState& panel, Group group, bool open) {
    choose(lab, panel, std::string(key_of(group)), open);
}

void show_unused(const PanelContext& lab, ParameterPanelState& panel, Group group, bool show) {
    choose(lab, panel, unused_key(group), show);
}

void draw_parameters(PanelContext& lab, ParameterPanelState& panel) {
    ImGui::TextDisabled("Parameters");
    ImGui::SameLine();
    const float width = ImGui::CalcTextSize("extreme ranges").x + ImGui::GetFrameHeight() + lab.px(6);
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetContentRegionMax().x - width));
    extreme_switch(lab);
    draw_run_switch(lab);
    ImGui::BeginChild("parameters", {0, 0}, ImGuiChildFlags_None, ImGuiWindowFlags_NavFlattened);
    const auto with_some = std::ranges::count_if(all_groups, [&](Group g) { return !lesson_of(lab).parameters_of(g).empty(); });
    for (const Group group : all_groups) draw_group(lab, panel, group, with_some > 1);
    ImGui::EndChild();
}

}  // namespace pliant::viewer
