// Where a person enters what they predict of a slide, and what came of it once the answer is shown.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

// At the cursor, as wide as there is room; nothing where the slide asks for none. Answers are set in this type.
void draw_prediction(PanelContext& lab, ImFont* type);
// Of an answer in words, beside that of the slide: the buttons by which the person who gave it judges it.
void draw_own_verdict(PanelContext& lab);
// As draw_prediction draws it at this width, with or without its answer, px.
float prediction_height(const PanelContext& lab, ImFont* type, float width, bool revealed);

}  // namespace pliant::viewer
