// Words with symbols among them, set as the formulas are: as items of ImGui, in its present font and colour.
#pragma once
#include "panels/panel_context.h"

#include <string>
#include <string_view>

namespace pliant::viewer {

// Laid out in lines of at most `width` px; 0: in one.
const MathBox& sentence_box(const PanelContext& lab, std::string_view text, float width = 0);
float sentence_width(const PanelContext& lab, std::string_view text);
// At the cursor, as wide as there is room.
void sentence_item(const PanelContext& lab, std::string_view text);
// As much of it as is no wider than this, with an ellipsis behind it: words by letters, a formula as a whole or not at all.
std::string cut_sentence(const PanelContext& lab, const std::string& text, float width);
// In one line. What is wider ends with an ellipsis, and the whole is its tooltip.
void fitted_sentence(const PanelContext& lab, const std::string& text, float width);
// With the top left corner at this place of the window.
void draw_sentence(const PanelContext& lab, ImVec2 at, unsigned colour, std::string_view text);
// The same, readable over any picture.
void haloed_sentence(const PanelContext& lab, ImVec2 at, unsigned colour, std::string_view text);
// A tooltip for the last item, in lines.
void sentence_tooltip(const PanelContext& lab, std::string_view text);

// A symbol as it stands in a sentence: a formula, whatever its letters, line by line. "" of none.
std::string as_formula(std::string_view symbol);
// The name in words with the symbol behind it, as a sentence; the symbol alone where it says the same.
std::string named_with_symbol(std::string_view key, std::string_view symbol, std::string_view gap = " ");

}  // namespace pliant::viewer
