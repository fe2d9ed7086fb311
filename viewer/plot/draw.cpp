#include "plot/draw.h"

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

// A line one px wide is sharp in the middle of a pixel.
float crisp(Real pixel) { return static_cast<float>(std::floor(pixel)) + 0.5f; }

void draw_ticks(const Drawing& d, const Ticks& ticks, const AxisMap& map, bool vertical) {
    const Box area = d.layout.area;
    for (const Tick& tick : ticks.ticks) {
        const bool minor = tick.text.empty();
        const float at = crisp(map.pixel(tick.value));
        const Point a = vertical ? Point{area.min.x, at} : Point{at, area.min.y},
                    b = vertical ? Point{area.max.x, at} : Point{at, area.max.y};
        d.canvas.segment(a, b, minor ? d.style.minor_grid : d.style.grid, d.style.width(d.style.grid_width));
    }
}

void draw_zero(const Drawing& d, const AxisMap& map, bool vertical) {
    if (map.scale() == AxisScale::log || !(map.range().lo < 0 && map.range().hi > 0)) return;
    const float at = crisp(map.pixel(0));
    const Box area = d.layout.area;
    const Point a = vertical ? Point{area.min.x, at} : Point{at, area.min.y},
                b = vertical ? Point{area.max.x, at} : Point{at, area.max.y};
    d.canvas.segment(a, b, d.style.frame, d.style.width(d.style.grid_width));
}

void draw_numbers(const Drawing& d) {
    const float em = d.canvas.line_height();
    const Box area = d.layout.area, whole = d.layout.whole;
    for (const Tick& tick : d.layout.x.ticks) {
        if (tick.text.empty()) continue;
        const float width = d.canvas.text_size(tick.text).x;
        const float x = std::clamp(static_cast<float>(d.x.pixel(tick.value)) - width / 2, whole.min.x,
                                   std::max(whole.min.x, whole.max.x - width));
        d.canvas.text({x, area.max.y + below_area * em}, d.style.faint_text, tick.text);
    }
    for (const Tick& tick : d.layout.y.ticks) {
        if (tick.text.empty()) continue;
        const Point size = d.canvas.text_size(tick.text);
        d.canvas.text({area.min.x - 0.3f * em - size.x, static_cast<float>(d.y.pixel(tick.value)) - 0.55f * size.y},
                      d.style.faint_text, tick.text);
    }
}

void draw_outline(Canvas& canvas, Box box, Rgba8 colour, float width) {
    const float h = 0.5f * width;
    canvas.fill({{box.min.x - h, box.min.y - h}, {box.max.x + h, box.min.y + h}}, colour);
    canvas.fill({{box.min.x - h, box.max.y - h}, {box.max.x + h, box.max.y + h}}, colour);
    canvas.fill({{box.min.x - h, box.min.y - h}, {box.min.x + h, box.max.y + h}}, colour);
    canvas.fill({{box.max.x - h, box.min.y - h}, {box.max.x + h, box.max.y + h}}, colour);
}

void draw_colour_bar(const Drawing& d) {
    if (!d.model.heat || !d.view.has_data) return;
    const Box bar = d.layout.colour_bar;
    const float em = d.canvas.line_height();
    const auto rows = static_cast<int>(bar.height());
    for (int row = 0; row < rows; ++row) {
        const float y = bar.min.y + static_cast<float>(row);
        const Real t = 1 - (row + 0.5) / rows;
        d.canvas.fill({{bar.min.x, y}, {bar.max.x, std::min(y + 1, bar.max.y)}}, colour_at(d.model.heat->map, t));
    }
    draw_outline(d.canvas, bar, d.style.frame, std::round(d.style.width(d.style.frame_width)));
    const AxisMap map(d.view.colour, AxisScale::linear, bar.max.y, bar.min.y);
    for (const Tick& tick : d.layout.colour.ticks) {
        const float y = static_cast<float>(map.pixel(tick.value));
        d.canvas.segment({bar.max.x, crisp(y)}, {bar.max.x + 0.2f * em, crisp(y)}, d.style.frame,
                         d.style.width(d.style.grid_width));
        d.canvas.text({bar.max.x + 0.35f * em, y - 0.52f * em}, d.style.faint_text, tick.text);
    }
}

void draw_hint(const Drawing& d) {
    if (d.view.hint.empty()) return;
    const Box area = d.layout.area;
    const std::string hint = shortened(d.canvas, d.view.hint, area.width() - d.canvas.line_height());
    const Point size = d.canvas.text_size(hint);
    d.canvas.text({(area.min.x + area.max.x - size.x) / 2, (area.min.y + area.max.y - size.y) / 2}, d.style.faint_text, hint);
}

}  // namespace

void draw_grid(const Drawing& d) {
    draw_ticks(d, d.layout.x, d.x, false);
    draw_ticks(d, d.layout.y, d.y, true);
    if (!d.view.has_data) return;
    draw_zero(d, d.x, false);
    draw_zero(d, d.y, true);
}

void draw_frame(const Drawing& d) {
    draw_outline(d.canvas, d.layout.area, d.style.frame, std::round(d.style.width(d.style.frame_width)));
    draw_numbers(d);
    draw_colour_bar(d);
    draw_hint(d);
    for (const Words* words : {&d.layout.x_label, &d.layout.y_label, &d.layout.colour_label})
        d.canvas.text(words->at, d.style.text, words->text);
}

void draw_plot(const Drawing& d) {
    const Box area = d.layout.area;
    d.canvas.push_clip(d.layout.whole);
    d.canvas.fill(d.layout.whole, d.style.background);
    // Twice, a pixel apart: bold.
    for (const float shift : {0.0f, 1.0f})
        d.canvas.text({d.layout.title.at.x + shift, d.layout.title.at.y}, d.style.text, d.layout.title.text);
    if (d.layout.usable) {
        d.canvas.push_clip(area);
        draw_grid(d);
        draw_heat(d);
        draw_curves(d);
        d.canvas.pop_clip();
        draw_marks(d);
        d.canvas.push_clip(area);
        draw_guides(d);
        d.canvas.pop_clip();
        draw_frame(d);
        draw_legend(d);
    }
    d.canvas.pop_clip();
}

}  // namespace pliant::viewer
