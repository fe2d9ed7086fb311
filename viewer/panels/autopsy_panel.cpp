// The card of a run that broke down: where, by how much, and the buttons that go on from there.

#include "panels/scene_panel.h"

#include <pliant/lesson/setting_words.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
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
    std::string text;
    ImFont* font;
};

// Without what stands in brackets: a blank, a bracket, and a word of small letters.
std::string without_asides(std::string text) {
    for (auto from = text.find(" ("); from != std::string::npos; from = text.find(" (", from + 1)) {
        if (from + 2 >= text.size() || text[from + 2] < 'a' || text[from + 2] > 'z') continue;
        int depth = 0;
        for (auto k = from + 1; k < text.size(); ++k) {
            depth += (text[k] == '(') - (text[k] == ')');
            if (depth > 0) continue;
            const std::string_view aside = std::string_view(text).substr(from + 2, k - from - 2);
            if (aside.find(' ') != aside.npos) text.erase(from, k + 1 - from);
            break;
        }
    }
    return text;
}

// How a card is set. Where there is no room it leaves out what the reason says in brackets, and in which step and stage the run
// stopped, which the status line and the stages tell as well.
struct CardType {
    ImFont *reason, *rest, *buttons;
    bool whole = true;
};

// The reason first, in the largest type.
std::vector<Line> lines_of(const Autopsy& a, const std::string& facts, const CardType& type) {
    if (a.limit.empty()) return {{a.headline, type.reason}, {facts, type.rest}};
    if (!type.whole) return {{without_asides(a.limit), type.reason}, {facts, type.rest}};
    return {{a.limit, type.reason}, {a.headline, type.rest}, {facts, type.rest}};
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

struct Card {
    CardType type{};
    float buttons = 0, height = 0;  // px
};

Card card_in(const Session& s, const Autopsy& a, const std::string& facts, const CardType& type, float inner, float pad) {
    ImGui::PushFont(type.buttons);
    const float buttons = static_cast<float>(lines_of_buttons(s, a, inner)) * ImGui::GetFrameHeightWithSpacing();
    ImGui::PopFont();
    return {type, buttons, height_of_words(lines_of(a, facts, type), inner) + buttons + 2 * pad};
}

// A third of the picture, in the largest type that it has room for; else more of it, with smaller type and fewer words.
Card fitting_card(const PanelContext& lab, const Autopsy& a, const std::string& facts, float room, float inner, float pad) {
    const Fonts& f = lab.fonts;
    const std::array types{CardType{f.large, f.normal, f.normal},     CardType{f.medium, f.normal, f.normal},
                           CardType{f.medium, f.small, f.normal},     CardType{f.normal, f.small, f.normal},
                           CardType{f.normal, f.small, f.small},      CardType{f.normal, f.small, f.small, false},
                           CardType{f.small, f.small, f.small, false}};
    Card card;
    for (const auto& [part, kinds] : {std::pair{1 / 3.f, 4}, {0.5f, 6}, {0.65f, 7}, {0.8f, 7}, {1.f, 7}})
        for (int k = 0; k < kinds; ++k) {
            card = card_in(lab.session, a, facts, types[static_cast<std::size_t>(k)], inner, pad);
            if (card.height <= part * room) return card;
        }
    card.height = std::max(room, card.buttons + 3 * pad);
    return card;
}

}  // namespace

void draw_autopsy(PanelContext& lab, ScenePanelState& panel, const Rectangle& picture) {
    if (!lab.session.autopsy()) return panel.focused_card.reset();
    const Autopsy a = *lab.session.autopsy();
    const std::string facts = a.where.empty() ? a.against : fmt::format("{}: {}", words(a.where), a.against);
    const float gap = lab.px(10), pad = lab.px(9), width = std::max(picture.width - 2 * gap, lab.px(60)), inner = width - 2 * pad;
    const Card card = fitting_card(lab, a, facts, picture.height - 2 * gap, inner, pad);
    ImGui::SetCursorScreenPos({picture.x + gap, picture.y + gap});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, packed(card_colour, 0.96f));
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_WHITE);
    ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 100));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, IM_COL32(0, 0, 0, 160));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
    ImGui::BeginChild("autopsy", {width, card.height}, ImGuiChildFlags_AlwaysUseWindowPadding,
                      ImGuiWindowFlags_NavFlattened | ImGuiWindowFlags_NoScrollbar);
    ImGui::BeginChild("autopsy words", {0, card.height - card.buttons - 2 * pad}, ImGuiChildFlags_None,
                      ImGuiWindowFlags_NoBackground);
    draw_words(lines_of(a, facts, card.type));
    ImGui::EndChild();
    ImGui::PushFont(card.type.buttons);
    if (!fix_buttons(lab, panel, a)) other_buttons(lab, panel, a);
    ImGui::PopFont();
    ImGui::EndChild();
    lab.note_control("autopsy");
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(4);
}

}  // namespace pliant::viewer
