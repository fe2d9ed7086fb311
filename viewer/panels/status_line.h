// What holds and what does not, below all panels.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

void draw_status_line(PanelContext& lab);

}  // namespace pliant::viewer
