#include "panels/walkthrough_panel.h"

#include <pliant/document/walkthrough_sentences.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/lesson/registry.h>

#include "panels/prediction_panel.h"
#include "panels/typeset_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace pliant::viewer {
namespace {

void paragraph(const PanelContext& lab, const std::string& text) {
    sentence_item(lab, without_marks(text));
    ImGui::Spacing();
}

void formula(PanelContext& lab, const pliant::Block& block) {
    ImGui::PushStyleColor(ImGuiCol_Text, lab.ink(Ink::velocity));
    ImGui::Indent(lab.px(12));
    for (const std::string& line : block.lines)
        formula_item(lab.fonts.mathematics, line, lab.fonts.medium->FontSize, ImGui::GetContentRegionAvail().x);
    ImGui::Unindent(lab.px(12));
    ImGui::PopStyleColor();
    ImGui::Spacing();
}

void heading(PanelContext& lab, const char* text, Ink role) {
    ImGui::PushStyleColor(ImGuiCol_Text, lab.ink(role));
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

bool is_reading(BlockKind kind) { return kind == BlockKind::text || kind == BlockKind::formula; }

// Texts and formulas, one behind the other.
void reading(PanelContext& lab, const Slide& slide) {
    for (const pliant::Block& b : slide.blocks) {
        if (b.kind == BlockKind::text) paragraph(lab, b.paragraph());
        if (b.kind == BlockKind::formula) formula(lab, b);
    }
}

// Where question, answer and checks would not fit below them, the texts are folded; a press unfolds them.
void folded_reading(PanelContext& lab, const Slide& slide) {
    if (std::ranges::none_of(slide.blocks, [](const pliant::Block& b) { return is_reading(b.kind); })) return;
    WalkthroughFold& fold = lab.fold;
    if (!fold.closed) {
        reading(lab, slide);
    } else {
        if (ImGui::Selectable("▸ the text of the slide")) fold.closed = false, fold.chosen = true;
        lab.note_control("unfold slide");
        tooltip("Shows the words and formulas of this slide", lab.scale);
    }
}

void next_actions(PanelContext& lab, const Slide& slide) {
    const std::string all = next_sentence(lab.session.lesson(), slide);
    if (all.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    sentence_item(lab, all);
    ImGui::PopStyleColor();
}

void question(PanelContext& lab, const Slide& slide, bool revealed) {
    for (const pliant::Block& b : slide.blocks)
        if (b.kind == BlockKind::ask) heading(lab, "Predict", Ink::accent), paragraph(lab, b.paragraph());
    draw_prediction(lab, lab.fonts.normal);
    if (!revealed) next_actions(lab, slide);
}

void expectations(PanelContext& lab, const WalkthroughPlayer& player) {
    for (const ExpectationResult& r : player.results()) {
        ImGui::PushStyleColor(ImGuiCol_Text, packed(r.met ? good_colour : bad_colour));
        ImGui::TextUnformatted(r.met ? "✓" : "✗");
        ImGui::PopStyleColor();
        ImGui::SameLine();
        sentence_item(lab, capitalised(r.sentence));
        tooltip(r.measured, lab.scale);
    }
}

void answer(PanelContext& lab, const WalkthroughPlayer& player) {
    for (const pliant::Block& b : player.slide().blocks)
        if (b.kind == BlockKind::answer) heading(lab, "What happened", Ink::velocity), paragraph(lab, b.paragraph());
    draw_own_verdict(lab);
    expectations(lab, player);
}

// What to go on with: a press opens the scene, with its question.
void extensions(PanelContext& lab) {
    Session& s = lab.session;
    if (s.extensions().empty()) return;
    heading(lab, "Go on from here", Ink::accent);
    for (std::size_t k = 0; k < s.extensions().size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        const std::string& title = s.extensions()[k].slide().title;
        const MathBox& words = sentence_box(lab, title, std::max(ImGui::GetContentRegionAvail().x - lab.px(16), 1.f));
        if (ImGui::Selectable("##extension", s.extension() == k, 0, {0, words.height()})) s.open_extension(k);
        const ImVec2 at = ImGui::GetItemRectMin();
        lab.fonts.mathematics.draw(*ImGui::GetWindowDrawList(), words, {at.x + lab.px(12), at.y + words.above},
                                   ImGui::GetColorU32(ImGuiCol_Text));
        lab.note_control(fmt::format("extension {}", k + 1));
        tooltip("Opens its scene, with a question; the answer comes when you ask for it.", lab.scale);
        ImGui::PopID();
    }
}

// And the lesson after this one.
void next_lesson(PanelContext& lab) {
    const auto& all = lessons();
    const auto here = std::ranges::find(all, lab.session.entry().info.id, [](const LessonEntry& e) { return e.info.id; });
    if (here == all.end() || here + 1 == all.end()) return;
    const std::string title = fmt::format("Next lesson: {}", (here + 1)->info.title);
    if (ImGui::Selectable(title.c_str())) lab.wanted.push_back(Action::next_lesson);
    lab.note_control("lead to next lesson");
}

// Another slide, or its answer, begins unfolded and at its top.
void begin_slide(PanelContext& lab, const WalkthroughPlayer& player) {
    WalkthroughFold& fold = lab.fold;
    const std::pair now{lab.session.slide_number(), player.revealed()};
    if (fold.of == now) return;
    fold = {.of = now, .fresh = 2};
    ImGui::SetScrollY(0);
}

// What does not fit is folded, and what is new comes into sight.
void end_slide(PanelContext& lab, float new_words) {
    WalkthroughFold& fold = lab.fold;
    const bool fits = ImGui::GetScrollMaxY() <= 0;
    if (!fits && !fold.closed && !fold.chosen && fold.fresh < 2)
        fold.closed = true, fold.fresh = 2;
    else if (!fits && fold.closed && fold.fresh == 1 && fold.of.second)
        ImGui::SetScrollY(std::min(new_words, ImGui::GetScrollMaxY()));
    fold.fresh = std::max(0, fold.fresh - 1);
}

// Behind the last slide, and below an extension.
bool offers_extensions(const Session& s) {
    const WalkthroughPlayer& player = *s.walkthrough;
    return !s.lecture() &&
           (s.extension() || (player.revealed() && player.slide_number() + 1 == player.walkthrough().slides.size()));
}

}  // namespace

void draw_walkthrough(PanelContext& lab) {
    const WalkthroughPlayer& player = *lab.session.walkthrough;
    const float buttons = ImGui::GetFrameHeightWithSpacing() + lab.px(6);
    ImGui::BeginChild("slide", {0, ImGui::GetContentRegionAvail().y - buttons});
    const auto extension = lab.session.extension();
    if (!lab.fold.closed) ImGui::TextDisabled("%s", extension ? "Go on from here" : player.walkthrough().title.c_str());
    ImGui::PushFont(lab.fonts.large);
    sentence_item(lab, player.slide().title);
    ImGui::PopFont();
    ImGui::Spacing();
    begin_slide(lab, player);
    folded_reading(lab, player.slide());
    const float new_words = ImGui::GetCursorPosY();
    question(lab, player.slide(), player.revealed());
    if (player.revealed()) answer(lab, player);
    const bool leads_on = offers_extensions(lab.session);
    if (leads_on) ImGui::Spacing(), extensions(lab), next_lesson(lab);
    end_slide(lab, new_words);
    ImGui::EndChild();

    if (ImGui::Button(extension ? "Again##walkthrough" : "Back##walkthrough")) lab.session.walkthrough_back();
    lab.note_control("walkthrough back");
    ImGui::SameLine();
    ImGui::BeginDisabled(extension && player.revealed());
    if (ImGui::Button(extension ? "Answer##walkthrough" : "Next##walkthrough", {lab.px(80), 0})) lab.session.walkthrough_next();
    ImGui::EndDisabled();
    lab.note_control("walkthrough next");
    ImGui::SameLine();
    const bool end = ImGui::Button("End##walkthrough");
    lab.note_control("walkthrough end");
    tooltip("Ends the walkthrough and unlocks the parameters; the run stays.", lab.scale);
    ImGui::SameLine();
    if (ImGui::Button("Deck##walkthrough")) lab.wanted.push_back(Action::deck);
    lab.note_control("walkthrough deck");
    tooltip("Shows the slide in large type beside the picture, for a lecture (D).", lab.scale);
    ImGui::SameLine();
    if (extension)
        ImGui::TextDisabled("%zu of %zu", *extension + 1, lab.session.extensions().size());
    else
        ImGui::TextDisabled("%zu of %zu", lab.session.slide_number() + 1, lab.session.slide_count());
    if (end) lab.session.end_walkthrough();
}

}  // namespace pliant::viewer
