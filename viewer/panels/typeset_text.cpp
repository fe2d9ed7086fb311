#include "panels/typeset_text.h"

#include "platform/index_letters.h"
#include "typeset/phrases.h"

#include <algorithm>
#include <utility>

namespace pliant::viewer {
namespace {

// For a line that is cut: the letters alone.
std::string untypeset(std::string_view text) {
    std::string plain;
    for (const Phrase& phrase : phrases_of(text)) plain += phrase.text;
    return with_index_letters(plain);
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

void fitted_sentence(const PanelContext& lab, const std::string& text, float width) {
    const MathBox& box = sentence_box(lab, text);
    if (box.width <= width) return draw_item(lab.fonts.mathematics, box, ImGui::GetColorU32(ImGuiCol_Text));
    ImGui::TextUnformatted(with_ellipsis(untypeset(text), width).c_str());
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
    place_tip();
    ImGui::BeginTooltip();
    draw_item(lab.fonts.mathematics, sentence_box(lab, text, lab.px(320)), ImGui::GetColorU32(ImGuiCol_Text));
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
