// Key numbers and lights as they were when the run moved last.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

// Measures them anew, if the run has moved.
void measure_held_numbers(PanelContext& lab);

}  // namespace pliant::viewer
