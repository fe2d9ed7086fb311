// What a plot is drawn on. One implementation draws into ImGui's lists, another one writes SVG.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "plot/trace.h"
#include "render/colour_map.h"

namespace pliant::viewer {

// All lengths in px; y points down.
class Canvas {
public:
    virtual ~Canvas() = default;

    virtual void fill(Box box, Rgba8 colour) = 0;
    virtual void line(std::span<const Point> points, Rgba8 colour, float width) = 0;
    virtual void polygon(std::span<const Point> corners, Rgba8 colour) = 0;  // convex, corners in either order
    virtual void text(Point top_left, Rgba8 colour, std::string_view words) = 0;
    virtual Point text_size(std::string_view words) const = 0;
    // Nothing is drawn outside the box until the clip is popped; clips nest.
    virtual void push_clip(Box box) = 0;
    virtual void pop_clip() = 0;

    float line_height() const { return text_size("0").y; }
    void segment(Point a, Point b, Rgba8 colour, float width) {
        const Point ends[] = {a, b};
        line(ends, colour, width);
    }
};

// The words, or as many of their first letters as fit into `width`, with an ellipsis; no word is cut to fewer than three letters.
// "" where nothing fits.
std::string shortened(const Canvas& canvas, std::string_view words, float width);
// The same of the name of a curve; of "A  Δt = 1 ms", which names a run, at least the letter.
std::string shortened_name(const Canvas& canvas, std::string_view name, float width);

}  // namespace pliant::viewer
