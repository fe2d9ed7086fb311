// What the slide layout shows besides picture and plots.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

void draw_headline(PanelContext& lab);
void draw_key_numbers(PanelContext& lab);

}  // namespace pliant::viewer
