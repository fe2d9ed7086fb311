// Where the keys go.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

// A thick ring around the control that the keys act on.
void draw_focus(PanelContext& lab);
// The keys go to the next panel, or the one before.
void focus_panel(int direction);

}  // namespace pliant::viewer
