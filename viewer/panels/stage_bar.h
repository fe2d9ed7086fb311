// The buttons of time, and the stages of a step.
#pragma once
#include "panels/panel_context.h"

#include <cstddef>
#include <optional>

namespace pliant::viewer {

struct StageBarState {
    int transport_rows = 1;                 // of the last frame
    bool scrolls = false;                   // likewise
    std::optional<std::size_t> in_sight{};  // the stage to which they have scrolled
};

inline constexpr float stage_height = 74, least_stage_width = 104, most_stage_width = 320, stage_scrollbar = 9;  // px at scale 1

void draw_transport(PanelContext& lab, StageBarState& panel);
void draw_stage_bar(PanelContext& lab, StageBarState& panel);

}  // namespace pliant::viewer
