// Where the parts of a plot lie. A plot that is too small for all of them first moves the units of its axes to the title and to
// the end of the numbers, then leaves out the legend, unless it is high enough, then everything but its title.
#pragma once
#include <string>
#include <vector>

#include "plot/axis_map.h"
#include "plot/canvas.h"
#include "plot/model.h"
#include "plot/ticks.h"

namespace pliant::viewer {

struct Words {
    std::string text;
    Point at;  // top left
};

struct LegendEntry {
    std::size_t series;  // index in the model
    Box box;
    Words name;
};

struct PlotLayout {
    Box whole, area;
    Box x_strip, y_strip;  // numbers of the axes
    Box menu;              // the switch that opens the menu
    Box colour_bar;        // of no width when there is none
    Words title, x_label, y_label, colour_label;
    Ticks x, y, colour;
    std::vector<LegendEntry> legend;
    bool usable = false;  // is there room for the area at all

    AxisMap x_map(const PlotView& view) const { return {view.x, view.x_scale, area.min.x, area.max.x}; }
    AxisMap y_map(const PlotView& view) const { return {view.y, view.y_scale, area.max.y, area.min.y}; }
};

PlotLayout lay_out(Box whole, const PlotModel& model, const PlotMemory& memory, const PlotView& view, const Canvas& canvas);

// From the picture down to the numbers of x, in heights of a line.
inline constexpr float below_area = 0.45f;
// From the picture to the right end of the plot.
inline constexpr float beside_area = 0.5f;

// The ticks of an axis `length` px long whose numbers do not touch one another.
Ticks ticks_that_fit(Range range, AxisScale scale, std::string_view unit, float length, bool vertical, const Canvas& canvas);

}  // namespace pliant::viewer
