// What is to be handed in: who, what was predicted and noted so far, and buttons to note more.
#pragma once
#include "panels/panel_context.h"

#include <array>

namespace pliant::viewer {

struct HandInPanelState {
    bool shown = false;
    std::array<char, 80> name{};
    std::array<char, 2000> answer{};
    // What the lab itself has to do, at the end of the frame.
    bool wants_picture = false, wants_save = false;
};

void draw_hand_in(PanelContext& lab, HandInPanelState& panel);

}  // namespace pliant::viewer
