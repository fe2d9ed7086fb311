// The claims of the lectures as cards: predict, measure, compare, and open as a scene.
#include "panels/claims_panel.h"

#include <pliant/lesson/registry.h>

#include "panels/flowing_text.h"
#include "session/worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <optional>
#include <utility>

namespace pliant::viewer {
namespace {

using Phase = ClaimBook::Phase;

constexpr Rgba8 qualified_colour{214, 150, 40};

// How a claim stands, by a shape and a word as well as by a colour.
struct Mark {
    const char* shape;
    std::string word;
    Rgba8 colour;
};

Mark mark_of(const ClaimBook& book, const Claim& c) {
    switch (book.phase(c)) {
        case Phase::asked:
            return {"○", "not measured", quiet_colour};
        case Phase::predicted:
            return {"◔", "predicted", quiet_colour};
        case Phase::waiting:
            return {"…", "waiting", quiet_colour};
        case Phase::measuring:
            return {"▷", "measuring", quiet_colour};
        case Phase::failed:
            return {"■", "failed", bad_colour};
        case Phase::measured:
            break;
    }
    const Verdict verdict = book.result(c)->finding->verdict;
    const std::string word(name_of(verdict));
    return verdict == Verdict::reproduced  ? Mark{"✓", word, good_colour}
           : verdict == Verdict::qualified ? Mark{"◐", word, qualified_colour}
                                           : Mark{"✗", word, bad_colour};
}

void words_here(const std::string& text) {
    ImGui::TextUnformatted(flowing_text(text, ImGui::GetFont(), ImGui::GetContentRegionAvail().x).c_str());
}

void quiet_words(PanelContext& lab, const std::string& text) {
    ImGui::PushFont(lab.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    words_here(text);
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void heading(PanelContext& lab, const char* text, Ink role) {
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, lab.ink(role));
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

void marked_word(const Mark& m) {
    ImGui::PushStyleColor(ImGuiCol_Text, packed(m.colour));
    ImGui::TextUnformatted(m.shape);
    ImGui::PopStyleColor();
    ImGui::SameLine();
    ImGui::TextUnformatted(m.word.c_str());
}

// A button as wide as the panel whose words flow into lines.
bool wide_button(const std::string& label, const char* id) {
    const float width = ImGui::GetContentRegionAvail().x, inner = width - 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0, 0.5f});
    const bool pressed =
        ImGui::Button(fmt::format("{}###{}", flowing_text(label, ImGui::GetFont(), inner), id).c_str(), {width, 0});
    ImGui::PopStyleVar();
    return pressed;
}

// --- the top: whose claims ---

void choice(PanelContext& lab, ClaimsPanelState& panel, const std::string& label, bool all, const char* name, const char* help) {
    if (ImGui::RadioButton(label.c_str(), panel.book.all == all)) panel.book.all = all;
    lab.note_control(name);
    tooltip(help, lab.scale);
}

void choose_claims(PanelContext& lab, ClaimsPanelState& panel) {
    const std::string here = fmt::format("this lesson ({})", claims_of(lab.session.entry().info.id).size()),
                      everywhere = fmt::format("all ({})", claims().size());
    choice(lab, panel, here, false, "claims of lesson", "What the lectures say of this lesson's methods");
    ImGui::SameLine();
    const float room = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(everywhere.c_str()).x;
    if (ImGui::GetContentRegionAvail().x < room) ImGui::NewLine();
    choice(lab, panel, everywhere, true, "claims of all", "The claims of every lesson");
}

// --- a card ---

// Its first line and the statement: one control, which unfolds the card.
void head(PanelContext& lab, ClaimsPanelState& panel, const Claim& c, bool open) {
    const Mark mark = mark_of(panel.book, c);
    const float width = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeightWithSpacing();
    const std::string statement = flowing_text(std::string(c.statement), ImGui::GetFont(), width);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = line + ImGui::CalcTextSize(statement.c_str()).y;
    if (ImGui::Selectable("##head", open, 0, {width, height})) panel.book.unfold(c);
    lab.note_control(fmt::format("claim {}", c.id));
    tooltip(fmt::format("{} of {}, {}. Click to unfold", c.id, c.lesson, mark.word), lab.scale);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const unsigned text = ImGui::GetColorU32(ImGuiCol_Text);
    draw->AddText(at, text, fmt::format("{} {}", open ? "▾" : "▸", c.id).c_str());
    const float word_width = ImGui::CalcTextSize(mark.word.c_str()).x, shape_width = ImGui::CalcTextSize(mark.shape).x;
    const float right = at.x + width - word_width;
    draw->AddText({right, at.y}, text, mark.word.c_str());
    draw->AddText({right - shape_width - lab.px(5), at.y}, packed(mark.colour), mark.shape);
    draw->AddText({at.x, at.y + line}, text, statement.c_str());
}

void question(PanelContext& lab, ClaimsPanelState& panel, const Claim& c) {
    ClaimBook& book = panel.book;
    const bool over = book.result(c) != nullptr;
    const auto predicted = book.prediction(c);
    heading(lab, "Predict", Ink::accent);
    words_here(std::string(c.question));
    ImGui::PushStyleVar(ImGuiStyleVar_DisabledAlpha, over ? 0.9f : ImGui::GetStyle().DisabledAlpha);  // still to be read
    ImGui::BeginDisabled(over || book.phase(c) == Phase::measuring || book.phase(c) == Phase::waiting);
    for (int k = 0; k < static_cast<int>(c.answers.size()); ++k) {
        const char* shape = over && k == c.right_answer ? "✓" : over && predicted == k ? "✗" : predicted == k ? "●" : "○";
        if (wide_button(fmt::format("{} {}", shape, c.answers[static_cast<std::size_t>(k)]), fmt::format("answer {}", k).c_str()))
            book.predict(c, k);
        lab.note_control(fmt::format("claim answer {}", k));
        tooltip(over ? "Ask again to choose anew" : "Choose this answer before the experiment is made", lab.scale);
    }
    ImGui::EndDisabled();
    ImGui::PopStyleVar();
}

void tell_progress_of(PanelContext& lab, ClaimsPanelState& panel, const Claim& c) {
    ClaimBook& book = panel.book;
    if (book.phase(c) == Phase::waiting) {
        quiet_words(lab, "It waits for the experiment that is under way.");
    } else if (book.watch().cancelling()) {
        quiet_words(lab, "Called off; it ends at the next place where it can.");
        return;
    } else {
        const BusyWords text = busy_words(book.watch().progress(), book.seconds());
        quiet_words(lab, fmt::format("{}: {}", text.title, text.line));
    }
    if (flowing_button(lab, "Cancel", "claim cancel", "Leaves the experiment, and asks as before", true)) book.cancel(c);
}

void buttons(PanelContext& lab, ClaimsPanelState& panel, const Claim& c) {
    ClaimBook& book = panel.book;
    ImGui::Spacing();
    const Phase phase = book.phase(c);
    const bool over = phase == Phase::measured || phase == Phase::failed,
               busy = phase == Phase::measuring || phase == Phase::waiting;
    if (busy) {
        tell_progress_of(lab, panel, c);
    } else if (over) {
        if (flowing_button(lab, "Ask again", "claim again", "Forgets the answer and the figure", true)) book.forget(c);
    } else if (flowing_button(lab, "Measure", "claim run", fmt::format("Makes the experiment now. {}", c.experiment), true)) {
        book.measure(c);
    }
    if (flowing_button(lab, "Open as scene", "claim scene",
                       fmt::format("Opens {} with the parameters that show this claim", c.lesson)))
        open_as_scene(lab.session, c);
}

void outcome(PanelContext& lab, ClaimsPanelState& panel, const Claim& c) {
    const ClaimResult& r = *panel.book.result(c);
    heading(lab, "Measured", Ink::velocity);
    if (const auto right = panel.book.was_right(c))
        marked_word({*right ? "✓" : "✗", *right ? "Your prediction was right." : "Your prediction was wrong.",
                     *right ? good_colour : bad_colour});
    if (!r.finding) return words_here(r.failure);
    ImGui::PushFont(lab.fonts.large);
    words_here(figure_text(r));
    ImGui::PopFont();
    quiet_words(lab, fmt::format("{}; criterion {}", c.figure, c.criterion));
    ImGui::PushFont(lab.fonts.medium);
    marked_word(mark_of(panel.book, c));
    ImGui::PopFont();
    words_here(r.finding->text);
    if (!r.finding->condition.empty()) {
        heading(lab, "Condition", Ink::force);
        words_here(r.finding->condition);
    }
}

// For the last row: the figure, the verdict and what was found.
void large_outcome(PanelContext& lab, ClaimsPanelState& panel, const Claim& c, ImFont* font) {
    const ClaimResult& r = *panel.book.result(c);
    ImGui::PushFont(font);
    if (const auto right = panel.book.was_right(c))
        marked_word({*right ? "✓" : "✗", *right ? "Your prediction was right." : "Your prediction was wrong.",
                     *right ? good_colour : bad_colour});
    if (r.finding) {
        marked_word(mark_of(panel.book, c));
        ImGui::SameLine(0, lab.px(24));
        ImGui::TextUnformatted(figure_text(r).c_str());
    }
    ImGui::PopFont();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    words_here(fmt::format("{}; criterion {}", c.figure, c.criterion));
    ImGui::PopStyleColor();
    ImGui::PushFont(font);
    words_here(r.finding ? r.finding->text : r.failure);
    if (r.finding && !r.finding->condition.empty()) words_here(r.finding->condition);
    ImGui::PopFont();
}

void body(PanelContext& lab, ClaimsPanelState& panel, const Claim& c) {
    quiet_words(lab, panel.book.all ? fmt::format("{} · {}", c.source, c.lesson) : std::string(c.source));
    question(lab, panel, c);
    buttons(lab, panel, c);
    if (panel.book.result(c)) outcome(lab, panel, c);
    heading(lab, "Experiment", Ink::velocity);
    words_here(std::string(c.experiment));
}

void card(PanelContext& lab, ClaimsPanelState& panel, const Claim& c, bool open) {
    ImGui::PushID(c.id.data(), c.id.data() + c.id.size());
    if (open && std::exchange(panel.reveal, false)) {
        ImGui::SetScrollFromPosY(ImGui::GetCursorPosY() - ImGui::GetScrollY() - lab.px(4), 0);
        head(lab, panel, c, open);
        if (std::exchange(panel.focus, false)) focus_last_item();
    } else {
        head(lab, panel, c, open);
    }
    if (open) body(lab, panel, c);
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::PopID();
}

}  // namespace

void draw_claims(PanelContext& lab, ClaimsPanelState& panel) {
    choose_claims(lab, panel);
    const std::string_view lesson = lab.session.entry().info.id;
    const auto list = panel.book.listed(lesson);
    if (list.empty()) {
        panel.reveal = panel.focus = false;
        return words_here("No claim stands beside this lesson; those of the others are under “all”.");
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {lab.px(4), lab.px(4)});
    ImGui::BeginChild("cards", {0, 0}, ImGuiChildFlags_AlwaysUseWindowPadding, ImGuiWindowFlags_NavFlattened);
    ImGui::PopStyleVar();
    const Claim* open = panel.book.unfolded(lesson);
    std::string_view chapter;
    for (const Claim* c : list) {
        if (panel.book.all && std::exchange(chapter, chapter_of(*c)) != chapter_of(*c))
            heading(lab, std::string(chapter).c_str(), Ink::accent);
        card(lab, panel, *c, c == open);
    }
    ImGui::EndChild();
}

namespace {

struct ClaimType {
    ImFont *statement, *rest, *notes;
};

float height_in(const ImFont* font, const std::string& text, float width) {
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, width, text.c_str()).y;
}

// With what the lectures say, which comes with what was found.
float height_of(const ClaimsPanelState& panel, const Claim& c, const ClaimType& type, float width) {
    const ClaimResult* r = panel.book.result(c);
    const float line = type.rest->FontSize + ImGui::GetStyle().ItemSpacing.y + 2 * ImGui::GetStyle().FramePadding.y;
    float height = height_in(type.statement, c.statement, width) + height_in(type.rest, c.question, width) +
                   height_in(type.notes, c.source + c.figure + c.criterion, width);
    for (const std::string& answer : c.answers)
        height += height_in(type.rest, answer, 0.95f * width) + line - type.rest->FontSize;
    if (r) height += height_in(type.rest, r->finding ? r->finding->text + r->finding->condition : r->failure, width);
    return height + 6 * line;
}

// The largest in which the card is in sight as a whole.
ClaimType claim_type(const PanelContext& lab, const ClaimsPanelState& panel, const Claim& c) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const Fonts& f = lab.fonts;
    for (const ClaimType& type :
         {ClaimType{f.huge, f.larger, f.large}, {f.larger, f.large, f.medium}, {f.large, f.medium, f.normal}})
        if (height_of(panel, c, type, room.x) <= room.y) return type;
    return {f.medium, f.normal, f.normal};
}

}  // namespace

void draw_claim_slide(PanelContext& lab, ClaimsPanelState& panel, const Claim& c) {
    ImGui::PushID(c.id.data(), c.id.data() + c.id.size());
    const ClaimType type = claim_type(lab, panel, c);
    ImGui::PushFont(type.rest);
    question(lab, panel, c);
    ImGui::PopFont();
    ImGui::Spacing();
    ImGui::PushFont(type.notes);
    // What the lectures say would answer the question, and so may what is said of its source.
    if (panel.book.result(c)) {
        ImGui::TextDisabled("What the lectures say (%s):", c.source.c_str());
        ImGui::PushFont(type.statement);
        words_here(c.statement);
        lab.note_control("claim statement");
        ImGui::PopFont();
        ImGui::Spacing();
    }
    const Phase phase = panel.book.phase(c);
    if (phase == Phase::measuring || phase == Phase::waiting) {
        tell_progress_of(lab, panel, c);
    } else if (panel.book.result(c)) {
        large_outcome(lab, panel, c, type.rest);
    } else {
        words_here("Next makes the experiment, and shows what the lectures say.");
    }
    ImGui::PopFont();
    ImGui::PopID();
}

}  // namespace pliant::viewer
