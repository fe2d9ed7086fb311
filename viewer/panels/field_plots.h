// Plots of the field that colours the picture: along a line, and as a heat map.
#pragma once
#include "panels/plot_panel.h"

namespace pliant::viewer {

// Between its own begin and end. The line of the profile is the panel's.
void plot_along(PanelContext& lab, PlotPanelState& panel, Plot& plot, Point size);
void plot_map(PanelContext& lab, Plot& plot, Point size);

}  // namespace pliant::viewer
