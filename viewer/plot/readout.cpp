// What follows the pointer over a plot.
#include <imgui.h>
#include <pliant/text/format.h>

#include <algorithm>
#include <cmath>

#include "plot/free_place.h"
#include "plot/interaction.h"

namespace pliant::viewer {
namespace {

// Digits that tell apart values which lie a five-hundredth of the axis apart.
int digits_for(Real value, Range range) {
    const Real size = std::max({std::abs(value), std::abs(range.lo), std::abs(range.hi)});
    if (!(range.span() > 0) || !(size > 0)) return 4;
    return std::clamp(static_cast<int>(std::ceil(std::log10(size / range.span()))) + 4, 4, 15);
}

struct Row {
    std::string label, value;
};

Row row(const std::string& label, const char* otherwise, Real value, const std::string& unit, Range range) {
    return {label.empty() ? otherwise : label, format_quantity(value, unit, digits_for(value, range))};
}

struct Sample {
    std::size_t series, index;
};

// The sample closest to the pointer, of all series that are shown.
std::optional<Sample> sample_under(const Hand& h, Point at) {
    const AxisMap x = h.layout.x_map(h.view), y = h.layout.y_map(h.view);
    std::optional<Sample> best;
    float radius = h.style.px(24);
    for (std::size_t s = 0; s < h.model.series.size(); ++s) {
        const Series& series = h.model.series[s];
        if (h.record.memory.hidden.contains(series.name)) continue;
        const auto index = nearest_sample(series.xs, series.ys, x, y, at, radius);
        if (!index) continue;
        radius =
            static_cast<float>(std::hypot(x.pixel(series.xs.view()[*index]) - at.x, y.pixel(series.ys.view()[*index]) - at.y));
        best = Sample{s, *index};
    }
    return best;
}

// The cell of a heat map along one axis that holds a value; -1 for none.
Index cell_of(Range extent, AxisScale declared, Index count, Real value) {
    if (!extent.contains(value) || !plottable(value, declared)) return -1;
    return std::clamp(static_cast<Index>(position_on(extent, declared, value) * static_cast<Real>(count)), Index{0}, count - 1);
}

std::vector<Row> rows_at(const Hand& h, Real x, Real y) {
    const Axes& axes = h.model.axes;
    std::vector<Row> rows{row(axes.x.label, "x", x, axes.x.unit, h.view.x), row(axes.y.label, "y", y, axes.y.unit, h.view.y)};
    if (!h.model.heat) return rows;
    const HeatMap& heat = *h.model.heat;
    const Index i = cell_of(heat.x, axes.x.scale, heat.nx, x), j = cell_of(heat.y, axes.y.scale, heat.ny, y);
    if (i >= 0 && j >= 0) rows.push_back(row(heat.name, "value", heat.at(i, j), heat.unit, h.view.colour));
    return rows;
}

// Where the curves are, thinned out; a heat map is everywhere.
std::vector<Point> seen_samples(const Hand& h) {
    constexpr std::size_t most = 200;  // of a curve
    const AxisMap x = h.layout.x_map(h.view), y = h.layout.y_map(h.view);
    std::vector<Point> seen;
    for (const Series& s : h.model.series) {
        if (h.record.memory.hidden.contains(s.name)) continue;
        for (std::size_t i = 0; i < s.xs.size(); i += 1 + s.xs.size() / most) {
            const Point at{static_cast<float>(x.pixel(s.xs.view()[i])), static_cast<float>(y.pixel(s.ys.view()[i]))};
            if (h.layout.area.contains(at)) seen.push_back(at);
        }
    }
    return seen;
}

// Beside the place that it tells of, where it covers least of the curves.
void tooltip(const Hand& h, const std::optional<Sample>& sample, Real x, Real y) {
    const std::string name = sample ? h.model.series[sample->series].name : "";
    const std::vector<Row> rows = rows_at(h, x, y);
    const ImVec2 padding = ImGui::GetStyle().WindowPadding, screen = ImGui::GetIO().DisplaySize;
    float widest = 0, widest_value = 0;
    for (const Row& r : rows) {
        widest = std::max(widest, ImGui::CalcTextSize(r.label.c_str()).x);
        widest_value = std::max(widest_value, ImGui::CalcTextSize(r.value.c_str()).x);
    }
    const float width = std::max(widest + ImGui::GetFontSize() + widest_value, ImGui::CalcTextSize(name.c_str()).x);
    const auto lines = static_cast<float>(rows.size() + (sample ? 1 : 0));
    const Point size{width + 2 * padding.x, lines * ImGui::GetTextLineHeightWithSpacing() + 2 * padding.y};
    const Point there{static_cast<float>(h.layout.x_map(h.view).pixel(x)), static_cast<float>(h.layout.y_map(h.view).pixel(y))};
    const Point at = free_place(there, size, h.style.px(14), {{0, 0}, {screen.x, screen.y}}, seen_samples(h));
    ImGui::SetNextWindowPos({at.x, at.y});
    if (!ImGui::BeginTooltip()) return;
    if (sample) ImGui::TextUnformatted(name.c_str());
    for (const Row& r : rows) {
        ImGui::TextUnformatted(r.label.c_str());
        ImGui::SameLine(padding.x + widest + ImGui::GetFontSize());
        ImGui::TextUnformatted(r.value.c_str());
    }
    ImGui::EndTooltip();
}

void cross_hairs(const Hand& h, Canvas& canvas, Point at) {
    const Box area = h.layout.area;
    const float width = h.style.width(1);
    canvas.segment({area.min.x, at.y}, {area.max.x, at.y}, h.style.faint_text, width);
    canvas.segment({at.x, area.min.y}, {at.x, area.max.y}, h.style.faint_text, width);
}

void zoom_box(const Hand& h, Canvas& canvas) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Point a = h.record.pressed, b{mouse.x, mouse.y};
    const Box box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
    Rgba8 tint = h.style.faint_text;
    tint.a = 60;
    canvas.fill(box, tint);
    const Point corners[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}, box.min};
    canvas.line(corners, h.style.text, h.style.width(1));
}

}  // namespace

void draw_pointer(const Hand& h, Canvas& canvas) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Point at{mouse.x, mouse.y};
    canvas.push_clip(h.layout.area);
    if (h.record.drag == PlotDrag::box) {
        zoom_box(h, canvas);
    } else if (h.view.has_data && h.record.drag == PlotDrag::none && h.layout.area.contains(at)) {
        const AxisMap x = h.layout.x_map(h.view), y = h.layout.y_map(h.view);
        const auto sample = sample_under(h, at);
        if (sample) {
            const Series& series = h.model.series[sample->series];
            const Real sx = series.xs.view()[sample->index], sy = series.ys.view()[sample->index];
            const Point there{static_cast<float>(x.pixel(sx)), static_cast<float>(y.pixel(sy))};
            cross_hairs(h, canvas, there);
            SeriesLook look = look_of(h.model, sample->series, h.style), ring = look;
            look.marker = ring.marker = Marker::circle;
            ring.colour = h.style.text;
            ring.radius += h.style.px(2);
            draw_marker(canvas, ring, there);
            draw_marker(canvas, look, there);
            tooltip(h, sample, sx, sy);
        } else {
            cross_hairs(h, canvas, at);
            tooltip(h, sample, x.value(at.x), y.value(at.y));
        }
    }
    canvas.pop_clip();
}

}  // namespace pliant::viewer
