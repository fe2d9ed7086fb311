// What holds and what does not, below all panels.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

void draw_status_line(PanelContext& lab);
// The lights in a row from this place of the window on, by name: over the picture of a slide.
void draw_lights_at(PanelContext& lab, const Rectangle& room);

}  // namespace pliant::viewer
