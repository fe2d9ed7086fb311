#include "plot/model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::viewer {
namespace {

bool valid_range(const std::optional<Range>& range, AxisScale scale) {
    return range && plottable(range->lo, scale) && plottable(range->hi, scale) && range->lo < range->hi;
}

struct DataRanges {
    std::optional<Range> x, y;
};

// Samples of which either number cannot be shown do not count, for they are not drawn.
DataRanges range_of_samples(const Series& series, AxisScale x_scale, AxisScale y_scale) {
    const std::span<const Real> xs = series.xs, ys = series.ys;
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    Range of_x{infinity, -infinity}, of_y = of_x;
    for (std::size_t i = 0; i < std::min(xs.size(), ys.size()); ++i) {
        const Real x = xs[i], y = ys[i];
        if (!plottable(x, x_scale) || !plottable(y, y_scale)) continue;
        of_x = {std::min(of_x.lo, x), std::max(of_x.hi, x)};
        of_y = {std::min(of_y.lo, y), std::max(of_y.hi, y)};
    }
    return of_x.lo <= of_x.hi ? DataRanges{of_x, of_y} : DataRanges{};
}

DataRanges shown_data(const PlotModel& model, const PlotMemory& memory, const PlotView& view) {
    DataRanges data;
    for (const Series& series : model.series) {
        if (memory.hidden.contains(series.name)) continue;
        const DataRanges of_series = range_of_samples(series, view.x_scale, view.y_scale);
        data = {united(data.x, of_series.x), united(data.y, of_series.y)};
    }
    if (model.heat && model.heat->values.size() > 0) {
        if (valid_range(model.heat->x, view.x_scale)) data.x = united(data.x, model.heat->x);
        if (valid_range(model.heat->y, view.y_scale)) data.y = united(data.y, model.heat->y);
    }
    return data;
}

Range shown_range(const Axis& axis, AxisMemory& memory, AxisScale scale, const std::optional<Range>& data, Margin margin) {
    if (data) memory.automatic.follow(*data, scale, margin);
    if (valid_range(memory.fixed, scale)) return *memory.fixed;
    if (valid_range(axis.range, scale)) return *axis.range;
    return valid_range(memory.automatic.shown, scale) ? *memory.automatic.shown
           : scale == AxisScale::log                  ? Range{1, 10}
                                                      : Range{0, 1};
}

Range colour_range(const HeatMap& heat, AxisMemory& memory) {
    if (auto data = data_range(heat.values, AxisScale::linear)) {
        if (heat.map == ColourMap::diverging) {
            const Real size = std::max(std::abs(data->lo), std::abs(data->hi));
            data = Range{-size, size};
        }
        memory.automatic.follow(*data, AxisScale::linear, Margin::none);
    }
    if (valid_range(memory.fixed, AxisScale::linear)) return *memory.fixed;
    if (valid_range(heat.range, AxisScale::linear)) return *heat.range;
    return memory.automatic.shown.value_or(Range{0, 1});
}

std::string why_empty(const PlotModel& model, const PlotMemory& memory, const PlotView& view) {
    const auto has_samples = [](const Series& s) { return s.xs.size() > 0 && s.ys.size() > 0; };
    const auto visible = [&](const Series& s) { return has_samples(s) && !memory.hidden.contains(s.name); };
    if (std::none_of(model.series.begin(), model.series.end(), has_samples)) return model.axes.empty_hint;
    if (std::none_of(model.series.begin(), model.series.end(), visible)) return "every curve is hidden";
    const bool log = view.x_scale == AxisScale::log || view.y_scale == AxisScale::log;
    return log ? "no positive values for the log axis" : "no finite values";
}

}  // namespace

PlotView current_view(const PlotModel& model, PlotMemory& memory) {
    PlotView view;
    view.x_scale = memory.x.scale.value_or(model.axes.x.scale);
    view.y_scale = memory.y.scale.value_or(model.axes.y.scale);
    const DataRanges data = shown_data(model, memory, view);
    view.has_data = data.x && data.y;

    // Data that fill only a corner are new data: both axes start over.
    if (data.x && memory.x.automatic.far_too_wide(*data.x, view.x_scale)) {
        memory.x.automatic.forget();
        memory.y.automatic.forget();
    }
    const Margin y_margin = model.heat ? Margin::none : Margin::some;
    view.x = shown_range(model.axes.x, memory.x, view.x_scale, data.x, Margin::none);
    view.y = shown_range(model.axes.y, memory.y, view.y_scale, data.y, y_margin);
    if (model.heat) view.colour = colour_range(*model.heat, memory.colour);
    if (!view.has_data) view.hint = why_empty(model, memory, view);
    return view;
}

void reset_axis(AxisMemory& axis) {
    axis.fixed.reset();
    axis.automatic.forget();
}

}  // namespace pliant::viewer
