#include "plot/map_marks.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pliant::viewer {
namespace {

constexpr Rgba8 mark_colour{14, 16, 20, 200};

std::array<Point, 16> circle(Point middle, float radius) {
    std::array<Point, 16> points;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(points.size());
        points[k] = {middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)};
    }
    return points;
}

void ring(Canvas& canvas, Point at, float radius, Rgba8 colour, float width) {
    const auto points = circle(at, radius);
    std::vector<Point> closed(points.begin(), points.end());
    closed.push_back(points[0]);
    canvas.line(closed, colour, width);
}

bool dark(const PlotStyle& style) { return contrast(style.background, {255, 255, 255}) > 5; }

}  // namespace

// M. Okabe and K. Ito, "Color Universal Design" (2008).
Rgba8 colour_of(Stability kind) {
    constexpr std::array<Rgba8, stability_kinds> colours{Rgba8{0x00, 0x9E, 0x73}, Rgba8{0x56, 0xB4, 0xE9},
                                                         Rgba8{0xD5, 0x5E, 0x00}, Rgba8{0xCC, 0x79, 0xA7},
                                                         Rgba8{0x8A, 0x90, 0x98}};
    return colours[static_cast<std::size_t>(kind)];
}

void draw_class_mark(Canvas& canvas, Point m, float size, Stability kind, const PlotStyle& style) {
    const float r = 0.27f * size, width = std::max(style.least_width, 0.1f * size);
    switch (kind) {
        case Stability::stable:
            return;
        case Stability::dissipative:
            return canvas.polygon(circle(m, 0.6f * r), mark_colour);
        case Stability::diverged:
            canvas.segment({m.x - r, m.y - r}, {m.x + r, m.y + r}, mark_colour, width);
            return canvas.segment({m.x - r, m.y + r}, {m.x + r, m.y - r}, mark_colour, width);
        case Stability::not_converged:
            return canvas.segment({m.x - 1.3f * r, m.y}, {m.x + 1.3f * r, m.y}, mark_colour, 1.4f * width);
        case Stability::refused:
            return canvas.segment({m.x - 0.5f * size, m.y + 0.5f * size}, {m.x + 0.5f * size, m.y - 0.5f * size}, mark_colour,
                                  width);
    }
}

void draw_class(Canvas& canvas, Box box, Stability kind, const PlotStyle& style) {
    canvas.fill(box, colour_of(kind));
    draw_class_mark(canvas, {(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2}, std::min(box.width(), box.height()), kind,
                    style);
}

void draw_present(Canvas& canvas, Point at, const PlotStyle& style) {
    const float radius = style.px(7);
    ring(canvas, at, radius, {0, 0, 0}, style.px(5));
    ring(canvas, at, radius, {255, 255, 255}, style.px(2.25f));
    canvas.polygon(circle(at, style.px(2.5f)), {0, 0, 0});
    canvas.polygon(circle(at, style.px(1.5f)), {255, 255, 255});
}

void draw_bound_line(Canvas& canvas, std::span<const Point> line, const PlotStyle& style) {
    const Rgba8 light{255, 255, 255}, black{0, 0, 0};
    canvas.line(line, dark(style) ? black : light, style.px(6.5f));
    canvas.line(line, dark(style) ? light : black, style.px(3.25f));
}

}  // namespace pliant::viewer
