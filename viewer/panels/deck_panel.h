// The parts of a slide in the deck. The heights are those that suit, px.
#pragma once
#include "panels/parameter_panel.h"

#include <cstddef>
#include <optional>

namespace pliant::viewer {

// The title with the number of the slide; its words; the parameters that it allows; the lecturer's notes.
void draw_slide_title(PanelContext& lab);
void draw_slide_words(PanelContext& lab);
void draw_slide_parameters(PanelContext& lab, ParameterPanelState& panel);
void draw_slide_notes(PanelContext& lab);
// Do its words that are shown speak of the lights of the lab? Then the picture has them.
bool slide_speaks_of_lights(const PanelContext& lab);
float slide_parameters_height(const PanelContext& lab);  // 0 when the slide allows none
// In which size of type the words fit into a room, 0 for the largest; empty when they fit in none.
std::optional<std::size_t> slide_words_type(const PanelContext& lab, ImVec2 room);
float slide_notes_height(const PanelContext& lab, float width);

}  // namespace pliant::viewer
