#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "plot/draw.h"

namespace pliant::viewer {
namespace {

// Between marks along a curve, and least between those of single samples; px at UI scale 1.
constexpr float mark_spacing = 70, sample_spacing = 16;

Box shape(Point centre, float radius) { return {{centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}}; }

std::size_t samples_in_view(const Series& series, Range x) {
    const std::span<const Real> xs = series.xs;
    return static_cast<std::size_t>(std::count_if(xs.begin(), xs.end(), [x](Real value) { return x.contains(value); }));
}

// Sets a curve off from the colours of a heat map.
void draw_halo(const Drawing& d, SeriesLook look) {
    look.colour = d.style.background;
    look.dash = Dash::solid;
    look.width += d.style.px(3);
    draw_lines(d.canvas, d.buffers.lines, look, d.buffers.strokes);
}

void find_marks(const Drawing& d, std::size_t index, bool x_never_falls, std::vector<Point>& marks) {
    const Series& series = d.model.series[index];
    // Few samples are marked each, so that one sees how few they are; many get a mark now and then.
    const auto room = static_cast<std::size_t>(d.layout.area.width() / d.style.px(sample_spacing));
    if (series.kind == SeriesKind::points) {
        scatter(series.xs, series.ys, d.x, d.y, std::max(1.0f, d.style.px(0.5f * d.style.marker_radius)), marks);
    } else if (series.xs.size() <= 4096 && samples_in_view(series, d.x.range()) <= room) {
        scatter(series.xs, series.ys, d.x, d.y, 1, marks);
    } else {
        const float spacing = d.style.px(mark_spacing);
        spaced(d.buffers.lines, spacing, spacing * (0.25f + 0.31f * static_cast<float>(index % 3)), x_never_falls, marks);
        std::erase_if(marks, [&d](Point at) { return !d.layout.area.contains(at); });
    }
}

}  // namespace

SeriesLook look_of(const PlotModel& model, std::size_t index, const PlotStyle& style) {
    const Series& series = model.series[index];
    const auto references_in_first = [&model](std::size_t count) {
        const auto begin = model.series.begin(), end = begin + static_cast<std::ptrdiff_t>(count);
        return static_cast<std::size_t>(
            std::count_if(begin, end, [](const Series& s) { return s.kind == SeriesKind::reference; }));
    };
    const std::size_t references_before = references_in_first(index);
    const std::size_t measured = model.series.size() - references_in_first(model.series.size());
    const std::size_t place = index - references_before;

    SeriesLook look{palette_colour(style, series.style.colour.value_or(place)), series.style.dash, Marker::none,
                    style.width(series.style.width.value_or(style.line_width)), style.px(style.marker_radius)};
    if (series.kind == SeriesKind::points) look.marker = marker_by_place(place);
    if (series.kind == SeriesKind::line && measured > 1) look.marker = marker_by_place(place);
    if (series.kind == SeriesKind::reference) {
        if (!series.style.colour) look.colour = style.reference;
        if (look.dash == Dash::solid) look.dash = references_before % 2 == 0 ? Dash::dashed : Dash::dotted;
    }
    if (series.style.marker) look.marker = *series.style.marker;
    return look;
}

void draw_marker(Canvas& canvas, const SeriesLook& look, Point at) {
    const float r = look.radius, diagonal = 0.8f * r;
    const auto at_angles = [&](std::span<Point> corners, float size, Real first) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Real angle = 2 * std::numbers::pi * static_cast<Real>(i) / static_cast<Real>(corners.size()) + first;
            corners[i] = {at.x + size * static_cast<float>(std::cos(angle)), at.y + size * static_cast<float>(std::sin(angle))};
        }
        canvas.polygon(corners, look.colour);
    };
    const Real up = -std::numbers::pi / 2;
    std::array<Point, 12> corners;
    switch (look.marker) {
        case Marker::none:
            return;
        case Marker::circle:
            return at_angles(corners, r, 0);
        case Marker::square:
            return canvas.fill(shape(at, 0.9f * r), look.colour);
        case Marker::triangle:
            return at_angles(std::span(corners).first(3), 1.35f * r, up);
        case Marker::diamond:
            return at_angles(std::span(corners).first(4), 1.35f * r, up);
        case Marker::cross:
            canvas.segment({at.x - diagonal, at.y - diagonal}, {at.x + diagonal, at.y + diagonal}, look.colour, look.width);
            return canvas.segment({at.x - diagonal, at.y + diagonal}, {at.x + diagonal, at.y - diagonal}, look.colour,
                                  look.width);
        case Marker::plus:
            canvas.segment({at.x - 1.2f * r, at.y}, {at.x + 1.2f * r, at.y}, look.colour, look.width);
            return canvas.segment({at.x, at.y - 1.2f * r}, {at.x, at.y + 1.2f * r}, look.colour, look.width);
    }
}

void draw_lines(Canvas& canvas, const Runs& lines, const SeriesLook& look, Runs& strokes) {
    SeriesLook dot = look;
    dot.marker = Marker::circle;
    for (std::size_t i = 0; i < lines.count(); ++i) {
        const auto run = lines.run(i);
        if (run.size() == 1)
            draw_marker(canvas, dot, run.front());
        else if (look.dash == Dash::solid)
            canvas.line(run, look.colour, look.width);
    }
    if (look.dash == Dash::solid) return;
    dash(lines, dash_pattern(look.dash, look.width), strokes);
    for (std::size_t i = 0; i < strokes.count(); ++i) canvas.line(strokes.run(i), look.colour, look.width);
}

void draw_curves(const Drawing& d) {
    d.buffers.marks.resize(d.model.series.size());
    // References last: they lie over what was measured.
    for (const bool references : {false, true}) {
        for (std::size_t i = 0; i < d.model.series.size(); ++i) {
            const Series& series = d.model.series[i];
            if ((series.kind == SeriesKind::reference) != references) continue;
            d.buffers.marks[i].clear();
            if (d.hidden(series)) continue;
            const SeriesLook look = look_of(d.model, i, d.style);
            bool x_never_falls = true;
            if (series.kind != SeriesKind::points) {
                x_never_falls = trace(series.xs, series.ys, d.x, d.y, 2 * look.width, d.buffers.lines);
                if (d.model.heat) draw_halo(d, look);
                draw_lines(d.canvas, d.buffers.lines, look, d.buffers.strokes);
            }
            if (look.marker != Marker::none) find_marks(d, i, x_never_falls, d.buffers.marks[i]);
        }
    }
}

void draw_marks(const Drawing& d) {
    for (std::size_t i = 0; i < d.model.series.size(); ++i) {
        const SeriesLook look = look_of(d.model, i, d.style);
        for (const Point at : d.buffers.marks[i]) draw_marker(d.canvas, look, at);
    }
}

void draw_legend(const Drawing& d) {
    for (const LegendEntry& entry : d.layout.legend) {
        const Series& series = d.model.series[entry.series];
        SeriesLook look = look_of(d.model, entry.series, d.style);
        const bool hidden = d.hidden(series);
        if (hidden) look.colour = d.style.grid;
        const float em = d.canvas.line_height(), y = entry.box.min.y + 0.52f * em, x = entry.box.min.x;
        const Point middle{x + 0.85f * em, y};
        if (series.kind != SeriesKind::points) {
            d.buffers.lines = {{{x, y}, {x + 1.7f * em, y}}, {0}};
            draw_lines(d.canvas, d.buffers.lines, look, d.buffers.strokes);
        }
        draw_marker(d.canvas, look, middle);
        d.canvas.text(entry.name.at, hidden ? d.style.frame : d.style.text, entry.name.text);
        if (hidden) d.canvas.segment({entry.name.at.x, y}, {entry.box.max.x, y}, d.style.frame, d.style.width(1));
    }
}

}  // namespace pliant::viewer
