// The stored past, where the run is to stop, and what is shown of a stage.
#pragma once
#include "panels/panel_context.h"

#include <string>

namespace pliant::viewer {

struct TimelineState {
    bool open_breaks = false;
    std::string condition{};  // that is being typed
    std::string refused{};    // why it is none
};

void draw_timeline(PanelContext& lab, TimelineState& panel);

}  // namespace pliant::viewer
