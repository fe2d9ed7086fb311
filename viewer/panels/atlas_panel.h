// The stability map of the open lesson.
#pragma once
#include "panels/panel_context.h"
#include "session/atlas.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace pliant::viewer {

struct AtlasPanelState {
    Atlas atlas{};
    bool focus = false;                             // its first control gets the keys
    std::optional<std::pair<Index, Index>> cell{};  // under the pointer

    // --- on a slide ---
    std::unique_ptr<StabilityMap> unmade{};      // what Next would make: axes without cells
    std::map<std::string, StabilityMap> kept{};  // whole maps of slides, by lecture and number
    long kept_made = 0;                          // of the atlas, when they were looked at last
};

void draw_atlas(PanelContext& lab, AtlasPanelState& panel);
// For a lecture hall: the map on its slide, or the field that it will fill. made: is the map that there is that of the slide?
void draw_atlas_of_slide(PanelContext& lab, AtlasPanelState& panel, bool made);
// Begins a map of the chosen knobs; a refusal becomes a message.
void start_atlas(PanelContext& lab, AtlasPanelState& panel);

}  // namespace pliant::viewer
