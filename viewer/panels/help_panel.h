// The table of keys, by what they are for, with a search.
#pragma once
#include "panels/panel_context.h"

#include <array>

namespace pliant::viewer {

struct HelpPanelState {
    std::array<char, 64> search{};
    bool opened = false;  // in the frame before
};

void draw_help(PanelContext& lab, HelpPanelState& panel, bool& shown);

}  // namespace pliant::viewer
