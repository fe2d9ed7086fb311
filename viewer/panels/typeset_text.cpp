#include "panels/typeset_text.h"

#include "typeset/phrases.h"

#include <algorithm>
#include <utility>

namespace pliant::viewer {
namespace {

// Whole letters of UTF-8 alone.
std::string_view first_letters(std::string_view text, std::size_t bytes) {
    while (bytes > 0 && bytes < text.size() && (static_cast<unsigned char>(text[bytes]) & 0xc0) == 0x80) --bytes;
    return text.substr(0, bytes);
}

}  // namespace

const MathBox& sentence_box(const PanelContext& lab, std::string_view text, float width) {
    return lab.fonts.mathematics.sentence(text, ImGui::GetFontSize(), width);
}

float sentence_width(const PanelContext& lab, std::string_view text) { return sentence_box(lab, text).width; }

void sentence_item(const PanelContext& lab, std::string_view text) {
    const float width = std::max(ImGui::GetContentRegionAvail().x, 1.f);
    draw_item(lab.fonts.mathematics, sentence_box(lab, text, width), ImGui::GetColorU32(ImGuiCol_Text));
}

std::string cut_sentence(const PanelContext& lab, const std::string& text, float width) {
    if (sentence_width(lab, text) <= width) return text;
    const auto fits = [&](const std::string& words) { return sentence_width(lab, words + "…") <= width; };
    std::string kept;
    for (const Phrase& phrase : phrases_of(text)) {
        const std::string whole = kept + (phrase.formula ? as_formula(phrase.text) : phrase.text);
        if (fits(whole)) {
            kept = whole;
            continue;
        }
        // A formula is there as a whole or not at all; of words as many letters as fit.
        std::size_t least = 0, most = phrase.formula ? 0 : phrase.text.size();
        while (least < most) {
            const std::size_t middle = (least + most + 1) / 2;
            fits(kept + std::string(first_letters(phrase.text, middle))) ? least = middle : most = middle - 1;
        }
        kept += first_letters(phrase.text, least);
        break;
    }
    while (!kept.empty() && (kept.back() == ' ' || kept.back() == ',')) kept.pop_back();
    return kept + "…";
}

void fitted_sentence(const PanelContext& lab, const std::string& text, float width) {
    const MathBox& box = sentence_box(lab, text);
    if (box.width <= width) return draw_item(lab.fonts.mathematics, box, ImGui::GetColorU32(ImGuiCol_Text));
    draw_item(lab.fonts.mathematics, sentence_box(lab, cut_sentence(lab, text, width)), ImGui::GetColorU32(ImGuiCol_Text));
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_DelayShort)) return;
    place_tip();
    ImGui::BeginTooltip();
    draw_item(lab.fonts.mathematics, box, ImGui::GetColorU32(ImGuiCol_Text));
    ImGui::EndTooltip();
}

void draw_sentence(const PanelContext& lab, ImVec2 at, unsigned colour, std::string_view text) {
    const MathBox& box = sentence_box(lab, text);
    lab.fonts.mathematics.draw(*ImGui::GetWindowDrawList(), box, {at.x, at.y + box.above}, colour);
}

void haloed_sentence(const PanelContext& lab, ImVec2 at, unsigned colour, std::string_view text) {
    const MathBox& box = sentence_box(lab, text);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const unsigned halo = packed(palette(lab.theme).background, 0.75f);
    const float d = std::max(1.f, lab.px(1)), base = at.y + box.above;
    for (const auto& [x, y] : {std::pair{-d, 0.f}, {d, 0.f}, {0.f, -d}, {0.f, d}, {-d, -d}, {d, d}, {-d, d}, {d, -d}})
        lab.fonts.mathematics.draw(draw, box, {at.x + x, base + y}, halo);
    lab.fonts.mathematics.draw(draw, box, {at.x, base}, colour);
}

void sentence_tooltip(const PanelContext& lab, std::string_view text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_DelayShort | ImGuiHoveredFlags_AllowWhenDisabled)) return;
    const MathBox& words = sentence_box(lab, text, lab.px(320));
    const ImVec2 pad = ImGui::GetStyle().WindowPadding;
    place_tip_beside({0, 0, words.width + 2 * pad.x, words.height() + 2 * pad.y});
    ImGui::BeginTooltip();
    draw_item(lab.fonts.mathematics, words, ImGui::GetColorU32(ImGuiCol_Text));
    ImGui::EndTooltip();
}

std::string as_formula(std::string_view symbol) {
    if (symbol.empty()) return "";
    const std::size_t end = symbol.find('\n');
    std::string line = std::string("$").append(symbol.substr(0, end)).append("$");
    return end == std::string_view::npos ? line : line + "\n" + as_formula(symbol.substr(end + 1));
}

std::string named_with_symbol(std::string_view key, std::string_view symbol, std::string_view gap) {
    if (symbol.empty()) return words(key);
    return says_the_same(key, symbol) ? as_formula(symbol) : words(key).append(gap).append(as_formula(symbol));
}

}  // namespace pliant::viewer
