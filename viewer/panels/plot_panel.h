// What is plotted, and how.
#pragma once
#include "panels/panel_context.h"
#include "plot/plot.h"
#include "render/palette.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::viewer {

PlotTheme plot_theme(Theme theme);
// As the lab draws plots now, with its typefaces.
PlotStyle style_of_plots(const PanelContext& lab);

struct PlotPanelState {
    PlotState memory{};
    PlotHooks hooks{};
    std::string lesson{};               // that the choice below belongs to
    std::vector<std::string> chosen{};  // names of probes and lines, "along" for the field along a line, "map" for the heat map
    bool picked = false;                // the person has chosen; until then they are those of the scene
    int run = 0;                        // that the ranges belong to
    int axis = 0;                       // of the field along a line
    std::array<Real, 2> across{0.5, 0.5};
    bool cost_shown = false;  // cost and error in the place of the plots
};

void draw_plots(PanelContext& lab, PlotPanelState& panel);  // below each other
void draw_plots_in_row(PanelContext& lab, PlotPanelState& panel);
// Does the slide that is shown have any?
bool slide_has_plots(const PanelContext& lab);
// The one that fills the screen, in type for a lecture hall.
void draw_filled_plot(PanelContext& lab, PlotPanelState& panel);
// The name of the plot that a scene is seen by first; "" of a lesson that measures nothing.
std::string first_plot_of_scene(const Lesson& lesson);
// Does the present scene have a plot of this name, or cost and error?
bool has_plot(const PanelContext& lab, std::string_view name);

// The part of its x axis that the person has zoomed to, between begin and end of the plot.
std::optional<Interval> zoomed_part(const Plot& plot);

// Notices changes of the run for its cost and error: in every frame.
void follow_live_error(PanelContext& lab);
// In the place of the plots.
void draw_cost_and_error(PanelContext& lab, Plot& plot);

}  // namespace pliant::viewer
