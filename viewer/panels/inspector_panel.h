// All numbers of the thing that is picked, and why they are what they are.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

struct InspectorPanelState {
    bool focus = false;  // its number gets the keys
};

void draw_inspector(PanelContext& lab, InspectorPanelState& panel);

}  // namespace pliant::viewer
