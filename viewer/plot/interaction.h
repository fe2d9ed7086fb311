// A person's hand on a plot: zoom, pan, legend, read-out and menu.
#pragma once
#include "plot/plot.h"

namespace pliant::viewer {

struct Hand {
    PlotRecord& record;
    const PlotModel& model;
    const PlotView& view;
    const PlotLayout& layout;
    const PlotStyle& style;
    const PlotHooks& hooks;
};

// Moves, zooms and toggles as the pointer says. The plot must be ImGui's last item. True when what is seen has changed.
bool follow_pointer(const Hand& hand);

// Draws what follows the pointer: cross hairs, the sample under it with its values, the box of a zoom.
void draw_pointer(const Hand& hand, Canvas& canvas);

// The menu of the plot, while it is open. `open`: it is to open now.
void plot_menu(const Hand& hand, const Canvas& measure, bool open);

// The text for the clipboard.
std::string plot_csv(const PlotModel& model, const PlotMemory& memory);

// The plot as a picture for slides and papers.
std::string plot_svg(const Hand& hand, const Canvas& measure);

// Sets what an axis shows from now on; the values belong to the part from a to b of it, 0 to 1.
void zoom_to(AxisMemory& axis, Range shown, AxisScale scale, Real a, Real b);

}  // namespace pliant::viewer
