// The colours of the picture and what they stand for.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

// What the bar takes of the picture, px: a strip at the right, which stays free of the framed scene, or in the deck one below it.
struct ColourBarPlace {
    float right = 0, below = 0;
};
ColourBarPlace colour_bar_place(const PanelContext& lab, float width);

// Draws the bar of the field that colours the picture, if one does, at the lower right or, in the deck, along the lower edge.
void draw_colour_bar(PanelContext& lab, const Rectangle& picture);

}  // namespace pliant::viewer
