// Why a number is what it is: its formula, the numbers put in, and how much each of them matters.
#include "panels/why_panel.h"

#include <pliant/run/why.h>
#include <pliant/text/format.h>
#include <pliant/text/spoken.h>

#include "panels/panel_context.h"
#include "panels/typeset_text.h"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace pliant::viewer {
namespace {

constexpr int digits = 6;

std::string origin_of(const Answer& a) {
    switch (a.kind) {
        case Answer::Kind::parameter:
            return "a parameter";
        case Answer::Kind::constant:
            return a.field;
        case Answer::Kind::state:
            return a.when.step == 0 ? "the initial state" : fmt::format("left by step {}", a.when.step);
        default:
            return "";
    }
}

void formula_block(PanelContext& lab, const Answer& a) {
    if (a.formula.empty()) return;
    const float size = lab.fonts.medium->FontSize, width = ImGui::GetContentRegionAvail().x;
    formula_item(lab.fonts.mathematics, a.formula, size, width);
    if (!a.trouble.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, packed(bad_colour));
        sentence_item(lab, "This formula cannot be evaluated. " + a.trouble.substr(0, a.trouble.find('\n')));
        ImGui::PopStyleColor();
        return;
    }
    ImGui::PushStyleColor(ImGuiCol_Text, lab.ink(Ink::accent));
    formula_item(lab.fonts.mathematics, a.substituted, size, width, Numbers::with_units);
    ImGui::PopStyleColor();
    if (const std::string words = unit_words(a); !words.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, packed(bad_colour));
        sentence_item(lab, words);
        ImGui::PopStyleColor();
    }
}

// How much an input matters beside the others; a bullet where there is nothing to compare.
void share_bar(PanelContext& lab, const Answer& a, const Answer& in) {
    Real whole = 0;
    for (const Answer& other : a.inputs) whole += other.sensitivity;
    if (a.inputs.size() < 2 || !(whole > 0)) {
        if (in.kind != Answer::Kind::part) ImGui::Bullet(), ImGui::SameLine();
        return;
    }
    const float width = lab.px(34), line = ImGui::GetTextLineHeight(), height = 0.4f * line;
    const ImVec2 at = ImGui::GetCursorScreenPos(), from{at.x, at.y + (line - height) / 2};
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(from, {from.x + width, from.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    draw->AddRectFilled(from, {from.x + width * static_cast<float>(in.sensitivity / whole), from.y + height},
                        lab.ink(Ink::accent));
    ImGui::Dummy({width, line});
    sentence_tooltip(lab, fmt::format("1 % of {} makes {} of this number; the bars compare the inputs", as_formula(in.symbol),
                                      format_quantity(in.sensitivity / 100, a.unit, 3)));
    ImGui::SameLine();
}

// A sentence over the last item, so far from its left edge, px.
void over_item(const PanelContext& lab, const std::string& text, float indent) {
    const ImVec2 at = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    const float down = (size.y - sentence_box(lab, text).height()) / 2;
    draw_sentence(lab, {at.x + indent, at.y + down}, ImGui::GetColorU32(ImGuiCol_Text), text);
}

// The inputs of an answer; a click asks the same of one of them. Intermediate results unfold.
void inputs_of(PanelContext& lab, const Answer& a, std::optional<Inspector::Asked>& next) {
    for (const Answer* input : inputs_to_read(a)) {
        const Answer& in = *input;
        ImGui::PushID(static_cast<int>(input - a.inputs.data()));
        share_bar(lab, a, in);
        const std::string text = as_formula(fmt::format("{} = {}", in.symbol, format_quantity(in.value, in.unit, digits)));
        if (in.kind == Answer::Kind::part) {
            const bool open = ImGui::TreeNodeEx("part", ImGuiTreeNodeFlags_SpanAvailWidth, "%s", "");
            lab.note_control(fmt::format("part {}", in.symbol));
            over_item(lab, text, ImGui::GetTreeNodeToLabelSpacing());
            if (open) {
                formula_block(lab, in);
                inputs_of(lab, in, next);
                ImGui::TreePop();
            }
        } else if (!in.together && (in.can_ask || in.kind == Answer::Kind::state || in.kind == Answer::Kind::computed)) {
            if (ImGui::Selectable("##ask", false, 0, {0, sentence_box(lab, text).height()}))
                next = {.field = in.field, .index = in.index, .component = in.component, .when = in.when};
            lab.note_control(fmt::format("ask {}", in.symbol));
            over_item(lab, text, 0.5f * ImGui::GetStyle().ItemSpacing.x);
            const std::string origin = origin_of(in);
            tooltip(fmt::format("{}{}. Click: why this number?", capitalised(title_of(in, lab.session.lesson())),
                                origin.empty() ? "" : ", " + origin),
                    lab.scale);
        } else {
            ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
            sentence_item(lab, fmt::format("{}   {}", text, in.together ? "solved together" : origin_of(in)));
            ImGui::PopStyleColor();
        }
        ImGui::PopID();
    }
}

}  // namespace

void draw_why(PanelContext& lab) {
    Session& s = lab.session;
    Inspector& in = s.inspector;
    if (!in.answer) {
        sentence_item(lab, "Click a number to see why it is what it is.");
        return;
    }
    if (in.asked.size() > 1) {
        if (ImGui::SmallButton("◂ back")) s.ask_back();
        lab.note_control("why back");
        tooltip("To the number that this one went into", lab.scale);
        ImGui::SameLine();
        ImGui::TextDisabled("%s deep", counted(static_cast<long long>(in.asked.size()), "question").c_str());
    }
    if (!in.answer) return;
    const Answer a = *in.answer;
    sentence_item(lab, fmt::format("Why is {} = {}?", title_of(a, s.lesson()), format_quantity(a.value, a.unit, digits)));
    const bool end_of_step = a.kind == Answer::Kind::state;
    if (!a.stage.empty()) {
        ImGui::TextDisabled("step %lld, stage %s", static_cast<long long>(step_number(a.when)), words(a.stage).c_str());
        if (!a.source.empty()) tooltip(a.source, lab.scale);
    } else if (end_of_step) {
        ImGui::TextDisabled("%s", origin_of(a).c_str());
    }
    formula_block(lab, a);
    if (const std::string solve = words_of_solve(a, s.lesson()); !solve.empty()) sentence_item(lab, solve);
    std::optional<Inspector::Asked> next;
    inputs_of(lab, a, next);
    if (next) s.ask(*next);
}

}  // namespace pliant::viewer
