// How things stand, in sentences.
#pragma once
#include "panels/panel_context.h"

#include <string>

namespace pliant::viewer {

struct SummaryPanelState {
    std::string text{};  // while it is shown
};

void draw_summary(PanelContext& lab, SummaryPanelState& panel);

}  // namespace pliant::viewer
