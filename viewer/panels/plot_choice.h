// Which plots there are, and which of them are shown.
#pragma once
#include "panels/plot_panel.h"

namespace pliant::viewer {

// Names among plots: the field along a line, as a heat map, and cost and error.
namespace plot_names {
inline constexpr std::string_view along = "along", heat_map = "map", cost = "cost";
}

// The plots are those of the scene until a person chooses.
void choose_first_plots(PanelContext& lab, PlotPanelState& panel);
void plot_menu(PanelContext& lab, PlotPanelState& panel);
// What was chosen; in the deck the first two that suit its scene.
std::vector<std::string> shown_plots(const PanelContext& lab, const PlotPanelState& panel);

}  // namespace pliant::viewer
