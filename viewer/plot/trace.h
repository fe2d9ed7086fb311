// Curves as pixels: gaps where a sample cannot be shown, no more points than a screen can resolve.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "plot/axis_map.h"

namespace pliant::viewer {

struct Point {
    float x = 0, y = 0;  // px, y down
    bool operator==(const Point&) const = default;
};

struct Box {
    Point min, max;
    float width() const { return max.x - min.x; }
    float height() const { return max.y - min.y; }
    bool contains(Point p) const { return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y; }
    bool operator==(const Box&) const = default;
};

// Lines through consecutive points; one begins at every index in `starts`. A run of one point is a sample that stands alone.
struct Runs {
    std::vector<Point> points;
    std::vector<std::size_t> starts;

    void clear() { points.clear(), starts.clear(); }
    std::size_t count() const { return starts.size(); }
    std::span<const Point> run(std::size_t i) const {
        const std::size_t end = i + 1 < starts.size() ? starts[i + 1] : points.size();
        return std::span(points).subspan(starts[i], end - starts[i]);
    }
};

// The curve through the samples (xs[i], ys[i]), cut at the edges of the area of the two maps plus `around` px. A sample with a
// value that cannot be shown leaves a gap. Where x never falls and there are many samples, each pixel column keeps its lowest and
// highest sample, so that a million samples cost some thousand points; else points that fall on the previous one go. True when x
// never falls.
bool trace(std::span<const Real> xs, std::span<const Real> ys, const AxisMap& x, const AxisMap& y, float around, Runs& out);

// The places of samples inside the area, at most one per cell of `cell` px.
void scatter(std::span<const Real> xs, std::span<const Real> ys, const AxisMap& x, const AxisMap& y, float cell,
             std::vector<Point>& out);

// Cuts lines into strokes of the given lengths in px: pattern[0] drawn, pattern[1] left out, and so on; an even count.
void dash(const Runs& lines, std::span<const float> pattern, Runs& out);

// Points of the lines for a mark every `spacing` px, the first after `first` px; counted in x alone where x never falls, lest a
// noisy curve drown in marks.
void spaced(const Runs& lines, float spacing, float first, bool x_alone, std::vector<Point>& out);

// The sample closest to a place, in pixels; none when all are as far as `radius` or further.
std::optional<std::size_t> nearest_sample(std::span<const Real> xs, std::span<const Real> ys, const AxisMap& x, const AxisMap& y,
                                          Point at, float radius);

}  // namespace pliant::viewer
