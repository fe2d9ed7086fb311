// Why a number of the run is what it is.
#pragma once

namespace pliant::viewer {

struct LabState;

// The question that was asked last, and what goes into its number. A click asks on.
void draw_why(LabState& lab);

}  // namespace pliant::viewer
