// What one plot shows, as data.
#pragma once
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plot/range.h"
#include "plot/style.h"

namespace pliant::viewer {

struct Axis {
    std::string label{};                  // "time t"
    std::string unit{};                   // "s"; empty: dimensionless
    AxisScale scale = AxisScale::linear;  // at first: the person may change it
    std::optional<Range> range{};         // shown instead of the range of the data, until the person zooms
};

struct Axes {
    Axis x{}, y{};
    std::string empty_hint = "no data yet: press Space";
};

// Numbers of a plot: those of the caller, which must stay in place until the plot is drawn, or, of a temporary, its own.
class Samples {
public:
    Samples(std::span<const Real> numbers) : view_(numbers) {}
    Samples(const std::vector<Real>& numbers) : view_(numbers) {}
    Samples(const VecX& numbers) : view_(numbers.data(), static_cast<std::size_t>(numbers.size())) {}
    Samples(std::vector<Real>&& numbers) : owned_(std::move(numbers)), view_(owned_) {}
    Samples(VecX&& numbers) : owned_(numbers.begin(), numbers.end()), view_(owned_) {}
    // Moving a vector leaves its numbers where they are.
    Samples(Samples&&) = default;
    Samples& operator=(Samples&&) = default;
    Samples(const Samples&) = delete;
    Samples& operator=(const Samples&) = delete;

    operator std::span<const Real>() const { return view_; }
    std::span<const Real> view() const { return view_; }
    std::size_t size() const { return view_.size(); }

private:
    std::vector<Real> owned_;
    std::span<const Real> view_;
};

enum class SeriesKind { line, points, reference };

struct Series {
    std::string name;
    SeriesKind kind = SeriesKind::line;
    Samples xs, ys;  // of equal size; a pair that is not finite is a gap
    SeriesStyle style{};
};

// A line across the plot at one value: a limit, an event.
struct Guide {
    bool vertical = false;
    Real value = 0;
    std::string label;
    Dash dash = Dash::dashed;
};

// Numbers on a grid of cells, that of column i and row j at i + nx * j, row 0 at the low end of y. Cells are equally wide on the
// scale that the axis was declared with. A cell that is not finite is hatched.
struct HeatMap {
    std::string name, unit;
    Samples values;
    Index nx = 0, ny = 0;
    Range x, y;  // outer edges of the grid
    ColourMap map = ColourMap::viridis;
    std::optional<Range> range{};  // of the colours; else that of the values so far, about 0 for the diverging map

    Real at(Index i, Index j) const { return values.view()[static_cast<std::size_t>(i + nx * j)]; }
};

struct PlotModel {
    std::string title;
    Axes axes;
    std::vector<Series> series;
    std::vector<Guide> guides;
    std::optional<HeatMap> heat;
};

// What a person has set, kept from frame to frame.
struct AxisMemory {
    AutoRange automatic;
    std::optional<Range> fixed;      // set by zoom, pan or the switch
    std::optional<AxisScale> scale;  // set by the switch
};

struct PlotMemory {
    AxisMemory x, y, colour;
    std::set<std::string, std::less<>> hidden;  // names of series
};

// What is to be seen of a plot now.
struct PlotView {
    AxisScale x_scale = AxisScale::linear, y_scale = AxisScale::linear;
    Range x, y, colour;
    bool has_data = false;
    std::string hint;  // why nothing is to be seen; empty otherwise
};

// Brings the automatic ranges up to date with the data and applies what the person has set.
PlotView current_view(const PlotModel& model, PlotMemory& memory);

// The fixed ranges and the scales go back to those declared; the automatic ones are made anew from the data.
void reset_axis(AxisMemory& axis);

}  // namespace pliant::viewer
