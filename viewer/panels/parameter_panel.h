// The sliders of the lesson.
#pragma once
#include "panels/panel_context.h"
#include "session/usage.h"

namespace pliant::viewer {

struct ParameterPanelState {
    UsageReasons usage{};
    bool value_changed = false;  // in the present drag of a slider: one step of undo
};

void draw_parameters(PanelContext& lab, ParameterPanelState& panel);
// One control. Large ones are for the deck.
void draw_parameter(PanelContext& lab, ParameterPanelState& panel, const Parameter& parameter, bool large = false);

}  // namespace pliant::viewer
