// Asks how an animation is to be made.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

void draw_animation_panel(PanelContext& lab);

}  // namespace pliant::viewer
