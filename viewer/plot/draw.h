// Draws a plot that is laid out. Knows neither ImGui nor a person's pointer.
#pragma once
#include <vector>

#include "plot/layout.h"

namespace pliant::viewer {

// Buffers that drawing uses again from frame to frame.
struct DrawBuffers {
    Runs lines, strokes;
    std::vector<std::vector<Point>> marks;  // of each series
};

struct Drawing {
    Canvas& canvas;
    const PlotModel& model;
    const PlotMemory& memory;
    const PlotView& view;
    const PlotLayout& layout;
    const PlotStyle& style;
    DrawBuffers& buffers;
    AxisMap x, y;

    bool hidden(const Series& series) const { return memory.hidden.contains(series.name); }
};

// Everything but what follows the pointer.
void draw_plot(const Drawing& drawing);

// The parts, from back to front.
void draw_grid(const Drawing& drawing);
void draw_heat(const Drawing& drawing);
void draw_curves(const Drawing& drawing);  // also finds where their marks are to be
void draw_marks(const Drawing& drawing);   // whole also on the edge of the picture
void draw_guides(const Drawing& drawing);
void draw_frame(const Drawing& drawing);
void draw_legend(const Drawing& drawing);

// How one series of the plot looks.
struct SeriesLook {
    Rgba8 colour;
    Dash dash;
    Marker marker;
    float width, radius;  // px, of lines and of marks
};
SeriesLook look_of(const PlotModel& model, std::size_t series, const PlotStyle& style);

void draw_marker(Canvas& canvas, const SeriesLook& look, Point at);
// Lines with the strokes of their dash; a sample that stands alone becomes a dot.
void draw_lines(Canvas& canvas, const Runs& lines, const SeriesLook& look, Runs& strokes);

// The edges of the cells of a heat map along one axis, in values: count + 1 of them.
Real cell_edge(Range extent, AxisScale declared, Index count, Index i);

}  // namespace pliant::viewer
