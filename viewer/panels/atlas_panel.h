// The stability map of the open lesson.
#pragma once
#include "panels/panel_context.h"
#include "session/atlas.h"

#include <optional>
#include <utility>

namespace pliant::viewer {

struct AtlasPanelState {
    Atlas atlas{};
    bool focus = false;                             // its first control gets the keys
    std::optional<std::pair<Index, Index>> cell{};  // under the pointer
};

void draw_atlas(PanelContext& lab, AtlasPanelState& panel);
// Begins a map of the chosen knobs; a refusal becomes a message.
void start_atlas(PanelContext& lab, AtlasPanelState& panel);

}  // namespace pliant::viewer
