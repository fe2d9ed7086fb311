// What is to be handed in: who, what was predicted and noted so far, and buttons to note more.
#pragma once
#include "panels/panel_context.h"

#include <array>
#include <string>

namespace pliant::viewer {

struct HandInPanelState {
    bool shown = false;
    bool has_keys = false;  // it is worked in
    std::array<char, 80> name{};
    std::array<char, 2000> answer{};
    // What the lab itself has to do, at the end of the frame. A picture is taken while the window stands aside.
    bool wants_picture = false, takes_picture = false, wants_save = false;
    std::string file{};  // that was handed in last, a path; "" before
};

void draw_hand_in(PanelContext& lab, HandInPanelState& panel);

}  // namespace pliant::viewer
