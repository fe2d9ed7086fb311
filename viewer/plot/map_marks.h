// The marks of the classes, so that they can be told apart without their colours.
#pragma once
#include "plot/map_plot.h"

namespace pliant::viewer {

// About the middle, within `size` px.
void draw_class_mark(Canvas& canvas, Point middle, float size, Stability kind, const PlotStyle& style);
// A ring: the present scene.
void draw_present(Canvas& canvas, Point at, const PlotStyle& style);
// A thick line with an edge of the other lightness, to be seen on every colour.
void draw_bound_line(Canvas& canvas, std::span<const Point> line, const PlotStyle& style);

}  // namespace pliant::viewer
