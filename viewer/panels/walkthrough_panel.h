// A slide of the walkthrough beside the lab.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

void draw_walkthrough(PanelContext& lab);

}  // namespace pliant::viewer
