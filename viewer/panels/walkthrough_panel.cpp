#include "panels/walkthrough_panel.h"

#include "panels/typeset_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::viewer {
namespace {

void paragraph(const PanelContext& lab, const std::string& text) {
    sentence_item(lab, without_marks(text));
    ImGui::Spacing();
}

void formula(PanelContext& lab, const Block& block) {
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

void draw_block(PanelContext& lab, const Block& block, const WalkthroughPlayer& player) {
    switch (block.kind) {
        case BlockKind::text:
            paragraph(lab, block.paragraph());
            break;
        case BlockKind::formula:
            formula(lab, block);
            break;
        case BlockKind::ask:
            heading(lab, "Predict", Ink::accent);
            paragraph(lab, block.paragraph());
            break;
        case BlockKind::actions:
            heading(lab, player.revealed() ? "Done" : "Next will", Ink::force);
            for (const std::string& line : block.lines) {
                ImGui::Bullet();
                ImGui::TextWrapped("%s", line.c_str());
            }
            ImGui::Spacing();
            break;
        case BlockKind::answer:
            if (!player.revealed()) break;
            heading(lab, "What happened", Ink::velocity);
            paragraph(lab, block.paragraph());
            break;
        case BlockKind::expect:
        case BlockKind::notes:
        case BlockKind::controls:
        case BlockKind::scene:
        case BlockKind::show:
            break;
    }
}

void expectations(PanelContext& lab, const WalkthroughPlayer& player) {
    for (const ExpectationResult& r : player.results()) {
        ImGui::PushStyleColor(ImGuiCol_Text, packed(r.met ? good_colour : bad_colour));
        ImGui::TextUnformatted(r.met ? "✓" : "✗");
        ImGui::PopStyleColor();
        ImGui::SameLine();
        ImGui::TextWrapped("%s", r.text.c_str());
        ImGui::PushFont(lab.fonts.small);
        ImGui::TextDisabled("    %s", r.measured.c_str());
        ImGui::PopFont();
    }
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

// Behind the last slide, and below an extension.
bool offers_extensions(const Session& s) {
    const WalkthroughPlayer& player = *s.walkthrough;
    return s.extension() || (player.revealed() && player.slide_number() + 1 == player.walkthrough().slides.size());
}

}  // namespace

void draw_walkthrough(PanelContext& lab) {
    const WalkthroughPlayer& player = *lab.session.walkthrough;
    const float buttons = ImGui::GetFrameHeightWithSpacing() + lab.px(6);
    ImGui::BeginChild("slide", {0, ImGui::GetContentRegionAvail().y - buttons});
    const auto extension = lab.session.extension();
    ImGui::TextDisabled("%s", extension ? "Go on from here" : player.walkthrough().title.c_str());
    ImGui::PushFont(lab.fonts.large);
    sentence_item(lab, player.slide().title);
    ImGui::PopFont();
    ImGui::Spacing();
    for (const Block& b : player.slide().blocks) draw_block(lab, b, player);
    expectations(lab, player);
    if (offers_extensions(lab.session)) ImGui::Spacing(), extensions(lab);
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
