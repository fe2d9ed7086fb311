#include <algorithm>
#include <cmath>

#include "plot/draw.h"

namespace pliant::viewer {
namespace {

// Cells narrower than this many px are left out evenly: the eye could not tell them apart.
constexpr float narrowest = 1;

// Where cells begin and end along one axis, in whole px so that no seam shows, each with the cell that it shows.
struct Strip {
    float begin, end;
    Index cell;
};

std::vector<Strip> strips(Range extent, AxisScale declared, Index count, const AxisMap& map) {
    std::vector<Strip> result;
    const Real low = std::min(map.low(), map.high()), high = std::max(map.low(), map.high());
    for (Index i = 0; i < count; ++i) {
        const Real from = cell_edge(extent, declared, count, i), to = cell_edge(extent, declared, count, i + 1);
        if (!map.plots(from) || !map.plots(to)) continue;
        Real a = map.pixel(from), b = map.pixel(to);
        if (a > b) std::swap(a, b);
        const auto begin = static_cast<float>(std::round(std::max(a, low))),
                   end = static_cast<float>(std::round(std::min(b, high)));
        if (end - begin >= narrowest) result.push_back({begin, end, i});
    }
    return result;
}

void hatch(const Drawing& d, Box box) {
    d.canvas.fill(box, d.style.background);
    d.canvas.push_clip(box);
    const float apart = d.style.px(6), height = box.height();
    // Lines of all cells belong to one pattern, fixed to the plot.
    const float origin = d.layout.area.min.x + d.layout.area.min.y;
    const float first = origin + std::floor((box.min.x + box.min.y - origin) / apart) * apart;
    for (float sum = first; sum < box.max.x + box.max.y + apart; sum += apart) {
        d.canvas.segment({sum - box.min.y, box.min.y}, {sum - box.min.y - height, box.max.y}, d.style.frame, d.style.width(1));
    }
    d.canvas.pop_clip();
}

}  // namespace

Real cell_edge(Range extent, AxisScale declared, Index count, Index i) {
    if (i == 0) return extent.lo;
    if (i == count) return extent.hi;
    return value_at(extent, declared, static_cast<Real>(i) / static_cast<Real>(count));
}

void draw_heat(const Drawing& d) {
    if (!d.model.heat || !d.view.has_data) return;
    const HeatMap& heat = *d.model.heat;
    const std::vector<Strip> columns = strips(heat.x, d.model.axes.x.scale, heat.nx, d.x);
    const std::vector<Strip> rows = strips(heat.y, d.model.axes.y.scale, heat.ny, d.y);
    const auto colour_index = [&](Index i, Index j) {
        const Real value = heat.at(i, j);
        return std::isfinite(value) ? static_cast<int>(std::lround(
                                          255 * std::clamp(position_on(d.view.colour, AxisScale::linear, value), 0.0, 1.0)))
                                    : -1;
    };
    const ColourTable& table = colour_table(heat.map);
    for (const Strip& row : rows) {
        // Neighbours of one colour are drawn together.
        for (std::size_t first = 0; first < columns.size();) {
            const int index = colour_index(columns[first].cell, row.cell);
            std::size_t end = first + 1;
            while (end < columns.size() && columns[end].begin == columns[end - 1].end &&
                   colour_index(columns[end].cell, row.cell) == index)
                ++end;
            const Box box{{columns[first].begin, row.begin}, {columns[end - 1].end, row.end}};
            if (index < 0)
                hatch(d, box);
            else
                d.canvas.fill(box, table[static_cast<std::size_t>(index)]);
            first = end;
        }
    }
}

}  // namespace pliant::viewer
