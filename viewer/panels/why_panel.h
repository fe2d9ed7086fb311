// Why a number of the run is what it is.
#pragma once

namespace pliant::viewer {

struct PanelContext;

// The question that was asked last, and what goes into its number. A click asks on.
void draw_why(PanelContext& lab);

}  // namespace pliant::viewer
