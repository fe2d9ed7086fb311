// The card of a run that broke down: where, by how much, and the buttons that go on from there.

#include "panels/scene_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pliant::viewer {
namespace {

constexpr Rgba8 card_colour{142, 32, 26};  // white words and the ring of the focus stand out from it

// Once for each card the keys go to its first button, the last item, unless a hand is on something else.
void take_focus(PanelContext& lab, ScenePanelState& panel) {
    const int card = lab.session.run_count() * 1000003 + static_cast<int>(lab.session.runner().place().step % 1000003);
    if (panel.focused_card == card || ImGui::IsAnyItemActive() || ImGui::GetIO().WantTextInput) return;
    panel.focused_card = card;
    focus_last_item();
}

std::string fix_label(const Autopsy& a) { return fmt::format("Set {} and {}", a.fix->label, a.restarts ? "restart" : "go on"); }

// Each returns whether the card is gone.
bool fix_button(PanelContext& lab, ScenePanelState& panel, const Autopsy& a) {
    if (!a.fix) return false;
    const Parameter* locked = lab.session.locked_of_fix();
    std::string help;
    for (const auto& [key, value] : a.fix->assign) help += fmt::format("{} = {}\n", key, value);
    help += locked       ? fmt::format("{} is locked on this slide; L unlocks it", words(locked->info.key))
            : a.restarts ? "starts the scene again with it"
                         : "goes on from the last good state";
    ImGui::BeginDisabled(locked != nullptr);
    const bool pressed = flowing_button(lab, fix_label(a), "fix", help, true);
    if (!locked) take_focus(lab, panel);
    ImGui::EndDisabled();
    if (pressed) lab.session.mend();
    return pressed;
}

bool other_buttons(PanelContext& lab, ScenePanelState& panel, const Autopsy& a) {
    Session& s = lab.session;
    const bool back = flowing_button(lab, "Step back", "autopsy back", "The step before the last good state (,)", !a.fix);
    if (!a.fix || s.locked_of_fix()) take_focus(lab, panel);
    if (back) return s.step_back(), true;
    if (a.thing && flowing_button(lab, "Show it", "show it",
                                  fmt::format("Inspect {} {}: its numbers, and why", name_of(a.thing->on), a.thing->index))) {
        s.pick_failed();
        lab.wanted.push_back(Action::inspect);
        return false;
    }
    if (flowing_button(lab, "Reset", "autopsy reset", "Start again from the parameters (R)")) return s.reset(), true;
    if (flowing_button(lab, "Dismiss", "dismiss", "Close this (Escape)")) return s.dismiss(), true;
    return false;
}

int lines_of_buttons(const Autopsy& a, float width) {
    float x = 0;
    int lines = 1;
    const auto add = [&](const std::string& label) {
        const float w = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
        if (x > 0 && x + w > width) ++lines, x = 0;
        x += w + ImGui::GetStyle().ItemSpacing.x;
    };
    if (a.fix) add(fix_label(a));
    add("Step back");
    if (a.thing) add("Show it");
    add("Reset"), add("Dismiss");
    return lines;
}

struct Line {
    const std::string& text;
    ImFont* font;
};

std::array<Line, 3> lines_of(PanelContext& lab, const Autopsy& a, const std::string& facts) {
    return {{{a.headline, lab.fonts.medium}, {facts, lab.fonts.normal}, {a.limit, lab.fonts.small}}};
}

float height_of_words(const std::array<Line, 3>& lines, float width) {
    float height = 0;
    for (const Line& l : lines) {
        if (l.text.empty()) continue;
        ImGui::PushFont(l.font);
        height += ImGui::CalcTextSize(l.text.c_str(), nullptr, false, width).y + ImGui::GetStyle().ItemSpacing.y;
        ImGui::PopFont();
    }
    return height;
}

void draw_words(const std::array<Line, 3>& lines) {
    for (const Line& l : lines) {
        if (l.text.empty()) continue;
        ImGui::PushFont(l.font);
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(l.text.c_str());
        ImGui::PopTextWrapPos();
        ImGui::PopFont();
    }
}

}  // namespace

void draw_autopsy(PanelContext& lab, ScenePanelState& panel, const Rectangle& picture) {
    if (!lab.session.autopsy()) return panel.focused_card.reset();
    const Autopsy a = *lab.session.autopsy();
    const std::string facts = a.where.empty() ? a.against : fmt::format("{}: {}", words(a.where), a.against);
    const float gap = lab.px(10), pad = lab.px(9), width = std::max(picture.width - 2 * gap, lab.px(60)), inner = width - 2 * pad;
    const auto lines = lines_of(lab, a, facts);
    const float buttons = static_cast<float>(lines_of_buttons(a, inner)) * ImGui::GetFrameHeightWithSpacing();
    // A third of the picture at most: what is longer scrolls.
    const float most = picture.width * picture.height / 3 / width,
                height = std::min(height_of_words(lines, inner) + buttons + 2 * pad, std::max(most, buttons + 3 * pad));
    ImGui::SetCursorScreenPos({picture.x + gap, picture.y + gap});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, packed(card_colour, 0.96f));
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_WHITE);
    ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 100));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, IM_COL32(0, 0, 0, 160));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
    ImGui::BeginChild("autopsy", {width, height}, ImGuiChildFlags_AlwaysUseWindowPadding,
                      ImGuiWindowFlags_NavFlattened | ImGuiWindowFlags_NoScrollbar);
    ImGui::BeginChild("autopsy words", {0, height - buttons - 2 * pad}, ImGuiChildFlags_None, ImGuiWindowFlags_NoBackground);
    draw_words(lines);
    ImGui::EndChild();
    if (!fix_button(lab, panel, a)) other_buttons(lab, panel, a);
    ImGui::EndChild();
    lab.note_control("autopsy");
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(4);
}

}  // namespace pliant::viewer
