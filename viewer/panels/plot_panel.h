// What is plotted, and how.
#pragma once
#include <pliant/lesson/parameter.h>

#include "plot/plot.h"
#include "render/palette.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pliant::viewer {

struct LabState;

PlotTheme plot_theme(Theme theme);
// As the lab draws plots now, with its typefaces.
PlotStyle style_of_plots(const LabState& lab);

struct PlotPanelState {
    PlotState memory;
    PlotHooks hooks;
    std::string lesson;               // that the choice below belongs to
    std::vector<std::string> chosen;  // names of probes and lines, "along" for the field along a line, "map" for the heat map
    int run = 0;                      // that the ranges belong to
    int axis = 0;                     // of the field along a line
    std::array<Real, 2> across{0.5, 0.5};
};

// The part of its x axis that the person has zoomed to, between begin and end of the plot.
std::optional<Interval> zoomed_part(const Plot& plot);

struct LabState;
// Notices changes of the run for its cost and error: in every frame.
void follow_live_error(LabState& lab);
// In the place of the plots.
void draw_cost_and_error(LabState& lab, Plot& plot);

}  // namespace pliant::viewer
