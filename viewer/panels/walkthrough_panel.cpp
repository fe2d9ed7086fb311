#include "panels/walkthrough_panel.h"

#include "platform/index_letters.h"

#include <fmt/format.h>

namespace pliant::viewer {
namespace {

void paragraph(const std::string& text) {
    ImGui::TextWrapped("%s", with_index_letters(without_marks(text)).c_str());
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
            paragraph(block.paragraph());
            break;
        case BlockKind::formula:
            formula(lab, block);
            break;
        case BlockKind::ask:
            heading(lab, "Predict", Ink::accent);
            paragraph(block.paragraph());
            break;
        case BlockKind::actions:
            heading(lab, player.revealed() ? "Done" : "Next will", Ink::force);
            for (const std::string& line : block.lines) ImGui::BulletText("%s", line.c_str());
            ImGui::Spacing();
            break;
        case BlockKind::answer:
            if (!player.revealed()) break;
            heading(lab, "What happened", Ink::velocity);
            paragraph(block.paragraph());
            break;
        case BlockKind::expect:
        case BlockKind::notes:
        case BlockKind::controls:
        case BlockKind::scene:
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

}  // namespace

void draw_walkthrough(PanelContext& lab) {
    const WalkthroughPlayer& player = *lab.session.walkthrough;
    const float buttons = ImGui::GetFrameHeightWithSpacing() + lab.px(6);
    ImGui::BeginChild("slide", {0, ImGui::GetContentRegionAvail().y - buttons});
    ImGui::TextDisabled("%s", player.walkthrough().title.c_str());
    ImGui::PushFont(lab.fonts.large);
    ImGui::TextWrapped("%s", player.slide().title.c_str());
    ImGui::PopFont();
    ImGui::Spacing();
    for (const Block& b : player.slide().blocks) draw_block(lab, b, player);
    expectations(lab, player);
    ImGui::EndChild();

    if (ImGui::Button("Back##walkthrough")) lab.session.walkthrough_back();
    lab.note_control("walkthrough back");
    ImGui::SameLine();
    if (ImGui::Button("Next##walkthrough", {lab.px(80), 0})) lab.session.walkthrough_next();
    lab.note_control("walkthrough next");
    ImGui::SameLine();
    const bool end = ImGui::Button("End##walkthrough");
    lab.note_control("walkthrough end");
    tooltip("Ends the walkthrough and unlocks the parameters; the run stays.", lab.scale);
    ImGui::SameLine();
    if (ImGui::Button("Deck##walkthrough")) lab.layout = Layout::deck, lab.session.camera.reset();
    lab.note_control("walkthrough deck");
    tooltip("Shows the slide in large type beside the picture, for a lecture (D).", lab.scale);
    ImGui::SameLine();
    ImGui::TextDisabled("%zu of %zu", player.slide_number() + 1, player.walkthrough().slides.size());
    if (end) lab.session.end_walkthrough();
}

}  // namespace pliant::viewer
