// Plots of what a run measures: of a probe over time, of a curve now, and of a number that is followed.
#pragma once
#include "panels/plot_panel.h"

namespace pliant::viewer {

// Each between its own begin and end. i: of the lesson's probes.
void plot_probe(PanelContext& lab, Plot& plot, std::size_t i, Point size);
void plot_line(const Session& session, Plot& plot, const Line& line, Point size);
void plot_pin(PanelContext& lab, Plot& plot, Pin& pin, Point size);

}  // namespace pliant::viewer
