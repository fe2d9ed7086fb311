// The card of a run that broke down: where, by how much, and the buttons that go on from there.

#include "panels/scene_panel.h"

#include <pliant/lesson/setting_words.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

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

std::string fix_label(const Session& s, const Autopsy& a, std::size_t n) {
    const std::string act = s.locked_of_fix(n) ? "Unlock, set" : "Set";
    return fmt::format("{} {} and {}", act, a.fix_at(n).label, a.restarts ? "restart" : "go on");
}

std::string fix_help(const Session& s, const Autopsy& a, std::size_t n) {
    std::string help = fmt::format("Sets {}.\n", settings_words(s.lesson(), a.fix_at(n).assign, "to"));
    if (const Parameter* p = s.locked_of_fix(n))
        help += fmt::format("This slide locks {}; a press unlocks all parameters.\n", words(p->info.key));
    return help + (a.restarts ? "Starts the scene again with it" : "Goes on from the last good state");
}

// Each returns whether the card is gone.
bool fix_buttons(PanelContext& lab, ScenePanelState& panel, const Autopsy& a) {
    Session& s = lab.session;
    for (std::size_t n = 0; n < a.fixes(); ++n) {
        const std::string name = n == 0 ? "fix" : fmt::format("fix {}", n + 1);
        const bool pressed = flowing_button(lab, fix_label(s, a, n), name, fix_help(s, a, n), n == 0);
        if (n == 0) take_focus(lab, panel);
        if (!pressed) continue;
        if (s.locked_of_fix(n)) s.unlocked = true;
        s.mend(n);
        return true;
    }
    return false;
}

bool other_buttons(PanelContext& lab, ScenePanelState& panel, const Autopsy& a) {
    Session& s = lab.session;
    const bool back = flowing_button(lab, "Step back", "autopsy back", "The step before the last good state (<)", !a.fix);
    if (!a.fix) take_focus(lab, panel);
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

int lines_of_buttons(const Session& s, const Autopsy& a, float width) {
    float x = 0;
    int lines = 1;
    const auto add = [&](const std::string& label) {
        const float w = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
        if (x > 0 && x + w > width) ++lines, x = 0;
        x += w + ImGui::GetStyle().ItemSpacing.x;
    };
    for (std::size_t n = 0; n < a.fixes(); ++n) add(fix_label(s, a, n));
    add("Step back");
    if (a.thing) add("Show it");
    add("Reset"), add("Dismiss");
    return lines;
}

struct Line {
    const std::string& text;
    ImFont* font;
};

// The reason first, in the largest type.
std::vector<Line> lines_of(const Autopsy& a, const std::string& facts, ImFont* reason, ImFont* rest) {
    if (a.limit.empty()) return {{a.headline, reason}, {facts, rest}};
    return {{a.limit, reason}, {a.headline, rest}, {facts, rest}};
}

float height_of_words(const std::vector<Line>& lines, float width) {
    float height = 0;
    for (const Line& l : lines) {
        if (l.text.empty()) continue;
        ImGui::PushFont(l.font);
        height += ImGui::CalcTextSize(l.text.c_str(), nullptr, false, width).y + ImGui::GetStyle().ItemSpacing.y;
        ImGui::PopFont();
    }
    return height;
}

void draw_words(const std::vector<Line>& lines) {
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
    const float buttons = static_cast<float>(lines_of_buttons(lab.session, a, inner)) * ImGui::GetFrameHeightWithSpacing();
    // A third of the picture, or as much as the reason needs in a small one, in the largest type that it has room for: what is
    // longer still scrolls.
    const Fonts& f = lab.fonts;
    const float reason_needs = height_of_words({lines_of(a, facts, f.medium, f.normal).front()}, inner) + buttons + 2 * pad;
    const float most = std::max(picture.width * picture.height / 3 / width, std::min(reason_needs, 0.8f * picture.height));
    auto lines = lines_of(a, facts, f.large, f.normal);
    for (const auto& [reason, rest] : {std::pair{f.medium, f.normal}, {f.medium, f.small}, {f.normal, f.small}})
        if (height_of_words(lines, inner) + buttons + 2 * pad > most) lines = lines_of(a, facts, reason, rest);
    const float height = std::min(height_of_words(lines, inner) + buttons + 2 * pad, std::max(most, buttons + 3 * pad));
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
    if (!fix_buttons(lab, panel, a)) other_buttons(lab, panel, a);
    ImGui::EndChild();
    lab.note_control("autopsy");
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(4);
}

}  // namespace pliant::viewer
