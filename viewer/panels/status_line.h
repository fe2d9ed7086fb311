// What holds and what does not, below all panels.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

void draw_status_line(PanelContext& lab);
// The lights by name in rows, at the lower end of this part of the window: over the picture of a slide. Gives the height of the
// rows, px.
float draw_lights_at(PanelContext& lab, const Rectangle& room);

}  // namespace pliant::viewer
