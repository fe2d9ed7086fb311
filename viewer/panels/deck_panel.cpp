// What the deck shows beside picture, plots and numbers: a slide of the walkthrough in large type.
#include "panels/deck_panel.h"

#include "panels/prediction_panel.h"
#include "panels/typeset_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::viewer {
namespace {

struct Paragraph {
    MathBox words;
    unsigned colour;
};

bool words_alone(const PanelContext& lab) {
    const LectureSlide* s = lab.session.lecture_slide();
    return s && s->lesson().empty();
}

float gap(const PanelContext& lab) { return lab.px(words_alone(lab) ? 20 : 9); }

// In the largest type in which it needs no more lines than it has equations, larger than the words around it.
Paragraph formula(const PanelContext& lab, const std::string& line, const ImFont* words, float width) {
    const MathType& type = lab.fonts.mathematics;
    const float largest = std::min(lab.fonts.huge->FontSize, 1.45f * words->FontSize),
                smallest = std::min(lab.fonts.large->FontSize, 1.2f * words->FontSize);
    const float room = 1.2f * type.formula(line, largest).height();
    return {type.fitted(line, largest, smallest, width, room), lab.ink(Ink::velocity)};
}

// What of the slide is shown: the introduction, formulas, the question, and the answer.
struct Shown {
    bool introduction, answer;
};

std::vector<Paragraph> words_of(const PanelContext& lab, ImFont* font, Shown shown, float width) {
    const unsigned ink = ImGui::GetColorU32(ImGuiCol_Text), quiet = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    std::vector<Paragraph> result;
    const auto say = [&](const std::string& text, unsigned colour) {
        result.push_back({lab.fonts.mathematics.sentence(text, font->FontSize, width), colour});
    };
    const auto headed = [&](const char* heading, Ink role, const Block& block, unsigned colour) {
        say(heading, lab.ink(role));
        say(without_marks(block.paragraph()), colour);
    };
    for (const Block& b : lab.session.walkthrough->slide().blocks) {
        if (b.kind == BlockKind::text && shown.introduction) say(without_marks(b.paragraph()), ink);
        if (b.kind == BlockKind::formula)
            for (const std::string& line : b.lines) result.push_back(formula(lab, line, font, width));
        if (b.kind == BlockKind::ask) headed("Predict", Ink::accent, b, shown.answer ? quiet : ink);
        if (b.kind == BlockKind::answer && shown.answer) headed("What happened", Ink::velocity, b, ink);
    }
    return result;
}

float height_of(const PanelContext& lab, const std::vector<Paragraph>& words) {
    float height = 0;
    for (const Paragraph& p : words) height += p.words.height() + gap(lab);
    return height;
}

// In a hall a free answer is given aloud: its line is in the lab alone.
bool has_prediction(const PanelContext& lab) {
    const auto& p = lab.session.walkthrough->prediction();
    return p && p->kind != Prediction::Kind::words;
}

// How the words of a slide are set. Its answer may take the place of the introduction.
struct Setting {
    ImFont* font;
    bool introduction;  // beside the answer
};

std::vector<Setting> settings(const PanelContext& lab) {
    std::vector<Setting> all;
    if (words_alone(lab)) all.push_back({lab.fonts.huge, true});
    for (ImFont* font : {lab.fonts.larger, lab.fonts.large, lab.fonts.medium, lab.fonts.normal})
        for (const bool introduction : {true, false}) all.push_back({font, introduction});
    return all;
}

// The one with the largest type in which the slide fits both with and without its answer, so that the question stays as it is
// when the answer comes; their count when none does.
std::size_t fitting_setting(const PanelContext& lab, ImVec2 room) {
    const auto fits_in = [&](ImFont* font, Shown shown) {
        const float words = height_of(lab, words_of(lab, font, shown, room.x));
        return words + (has_prediction(lab) ? prediction_height(lab, font, room.x, shown.answer) : 0) <= room.y;
    };
    const std::vector<Setting> all = settings(lab);
    std::size_t n = 0;
    while (n < all.size() && !(fits_in(all[n].font, {true, false}) && fits_in(all[n].font, {all[n].introduction, true}))) ++n;
    return n;
}

struct FittingWords {
    std::vector<Paragraph> words;
    ImFont* font;
};

FittingWords fitting_words(const PanelContext& lab, ImVec2 room) {
    const bool revealed = lab.session.walkthrough->revealed();
    const std::vector<Setting> all = settings(lab);
    const std::size_t n = fitting_setting(lab, room);
    if (n == all.size()) return {words_of(lab, lab.fonts.normal, {!revealed, revealed}, room.x), lab.fonts.normal};
    return {words_of(lab, all[n].font, {all[n].introduction || !revealed, revealed}, room.x), all[n].font};
}

std::vector<const Parameter*> shown_parameters(const PanelContext& lab) {
    const Session& s = lab.session;
    if (s.lecture() && !s.walkthrough->slide().has(BlockKind::controls)) return {};  // a lecture names those that it wants
    const bool chosen = s.walkthrough->slide().has(BlockKind::controls) && !s.unlocked;
    std::vector<const Parameter*> shown;
    for (const Parameter* p : s.lesson().parameters)
        if (chosen ? s.walkthrough->allows(p->info.key) : p->used()) shown.push_back(p);
    return shown;
}

int columns(std::size_t count) { return count > 2 ? 2 : 1; }

}  // namespace

void draw_slide_title(PanelContext& lab) {
    const WalkthroughPlayer& player = *lab.session.walkthrough;
    const std::size_t number = lab.session.slide_number() + 1, count = lab.session.slide_count();
    const std::string progress = fmt::format("{}{} / {}", lab.session.unlocked ? "unlocked   " : "", number, count);
    ImGui::PushFont(lab.fonts.large);
    const float width = ImGui::CalcTextSize(progress.c_str()).x, right = ImGui::GetContentRegionMax().x - width;
    ImGui::PopFont();
    ImGui::PushFont(lab.fonts.huge);
    fitted_sentence(lab, player.slide().title, right - ImGui::GetCursorPosX() - lab.px(20));
    ImGui::PopFont();
    ImGui::SameLine(right);
    ImGui::PushFont(lab.fonts.large);
    ImGui::TextDisabled("%s", progress.c_str());
    ImGui::PopFont();

    // A rule whose bright part is what has been shown.
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const float y = at.y + size.y - lab.px(5), x = at.x + lab.px(20), length = size.x - lab.px(40);
    const float done = static_cast<float>(number) / static_cast<float>(count), line = std::max(2.f, lab.px(3));
    ImGui::GetWindowDrawList()->AddLine({x, y}, {x + length, y}, ImGui::GetColorU32(ImGuiCol_Separator), line);
    ImGui::GetWindowDrawList()->AddLine({x, y}, {x + done * length, y}, lab.ink(Ink::accent), line);
}

void draw_slide_words(PanelContext& lab) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const FittingWords fitting = fitting_words(lab, room);
    ImGui::BeginChild("words", {0, 0}, 0, ImGuiWindowFlags_NoBackground);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, gap(lab)});
    for (const Paragraph& p : fitting.words) draw_item(lab.fonts.mathematics, p.words, p.colour);
    ImGui::PopStyleVar();
    if (has_prediction(lab)) draw_prediction(lab, fitting.font);
    ImGui::EndChild();
}

std::optional<std::size_t> slide_words_type(const PanelContext& lab, ImVec2 room) {
    const std::size_t n = fitting_setting(lab, room);
    return n < settings(lab).size() ? std::optional(n) : std::nullopt;
}

float slide_parameters_height(const PanelContext& lab) {
    const auto count = shown_parameters(lab).size();
    if (count == 0) return 0;
    const auto rows =
        static_cast<float>((count + static_cast<std::size_t>(columns(count)) - 1) / static_cast<std::size_t>(columns(count)));
    const ImGuiStyle& style = ImGui::GetStyle();
    return rows * (2 * lab.fonts.large->FontSize + 2 * style.ItemSpacing.y + 2 * style.FramePadding.y + lab.px(2)) + lab.px(18);
}

bool slide_speaks_of_lights(const PanelContext& lab) {
    const WalkthroughPlayer& player = *lab.session.walkthrough;
    if (player.hides("lights")) return false;
    return std::ranges::any_of(player.slide().blocks, [&](const Block& b) {
        const bool shown =
            b.kind == BlockKind::text || b.kind == BlockKind::ask || (b.kind == BlockKind::answer && player.revealed());
        const std::string words = shown ? b.paragraph() : "";
        return words.find(" light \"") != words.npos || words.find(" light *") != words.npos ||
               words.find("The light ") != words.npos || words.find(" lights ") != words.npos;
    });
}

void draw_slide_parameters(PanelContext& lab, ParameterPanelState& panel) {
    const auto shown = shown_parameters(lab);
    if (!ImGui::BeginTable("parameters", columns(shown.size()))) return;
    for (const Parameter* p : shown) {
        ImGui::TableNextColumn();
        draw_parameter(lab, panel, *p, true);
    }
    ImGui::EndTable();
}

namespace {
std::string notes_of(const PanelContext& lab) {
    const std::string notes = lab.session.walkthrough->slide().notes();
    return notes.empty() ? "This slide has no notes." : without_marks(notes);
}
}  // namespace

float slide_notes_height(const PanelContext& lab, float width) {
    return lab.fonts.mathematics.sentence(notes_of(lab), lab.fonts.normal->FontSize, width - lab.px(40)).height() + lab.px(22);
}

void draw_slide_notes(PanelContext& lab) {
    sentence_item(lab, notes_of(lab));
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    lab.controls["notes"] = {at.x, at.y, size.x, size.y};
}

}  // namespace pliant::viewer
