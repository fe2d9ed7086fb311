#include <algorithm>
#include <array>
#include <cmath>

#include "plot/draw.h"

namespace pliant::viewer {
namespace {

bool overlap(Box a, Box b) { return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y; }

// Writes labels where they cover neither each other nor the edge.
class Labels {
public:
    explicit Labels(const Drawing& drawing) : d_(drawing), em_(drawing.canvas.line_height()) {}

    // Beside a line at x, near the top.
    void beside(float x, const std::string& label) {
        const Point size = d_.canvas.text_size(label);
        const Box area = d_.layout.area;
        const float gap = 0.3f * em_;
        const bool right = x + gap + size.x <= area.max.x;
        for (int row = 0; row < 6; ++row) {
            const float y = area.min.y + gap + static_cast<float>(row) * 1.1f * em_;
            if (y + size.y > area.max.y) return;
            if (write({right ? x + gap : x - gap - size.x, y}, size, label)) return;
        }
    }
    // Above or below a line at y, at its end.
    void along(float y, const std::string& label) {
        const Point size = d_.canvas.text_size(label);
        const Box area = d_.layout.area;
        const float gap = 0.3f * em_, right = area.max.x - gap - size.x, left = area.min.x + gap;
        const float above = y - 0.15f * em_ - size.y, below = y + 0.15f * em_;
        for (const Point at : std::array<Point, 4>{{{right, above}, {right, below}, {left, above}, {left, below}}}) {
            if (at.y >= area.min.y && at.y + size.y <= area.max.y && write(at, size, label)) return;
        }
    }

private:
    bool write(Point at, Point size, const std::string& label) {
        at.x = std::clamp(at.x, d_.layout.area.min.x, std::max(d_.layout.area.min.x, d_.layout.area.max.x - size.x));
        const Box plate{{at.x - 0.15f * em_, at.y}, {at.x + size.x + 0.15f * em_, at.y + size.y}};
        if (std::any_of(taken_.begin(), taken_.end(), [&](Box box) { return overlap(box, plate); })) return false;
        taken_.push_back(plate);
        d_.canvas.fill(plate, d_.style.plate);
        d_.canvas.text(at, d_.style.text, label);
        return true;
    }

    const Drawing& d_;
    float em_;
    std::vector<Box> taken_;
};

void draw_guide(const Drawing& d, const Guide& guide, Labels& labels) {
    const AxisMap& map = guide.vertical ? d.x : d.y;
    if (!map.plots(guide.value)) return;
    const Box area = d.layout.area;
    const Range range = map.range();
    // A guide beyond the edge is not lost: its label says where it lies.
    const bool above = guide.value > range.hi, below = guide.value < range.lo;
    const float at = static_cast<float>(std::floor(map.pixel(std::clamp(guide.value, range.lo, range.hi)))) + 0.5f;
    const char* arrow = guide.vertical ? (above ? " →" : "← ") : (above ? " ↑" : " ↓");
    std::string label = guide.label;
    if (above || below) {
        if (label.empty()) return;
        label = guide.vertical && below ? arrow + label : label + arrow;
    } else {
        const Point a = guide.vertical ? Point{at, area.min.y} : Point{area.min.x, at};
        const Point b = guide.vertical ? Point{at, area.max.y} : Point{area.max.x, at};
        const SeriesLook look{d.style.text, guide.dash, Marker::none, d.style.width(1.25f), 0};
        d.buffers.lines = {{a, b}, {0}};
        draw_lines(d.canvas, d.buffers.lines, look, d.buffers.strokes);
    }
    if (label.empty()) return;
    label = shortened(d.canvas, label, area.width() - d.canvas.line_height());
    if (guide.vertical)
        labels.beside(at, label);
    else
        labels.along(at, label);
}

}  // namespace

void draw_guides(const Drawing& d) {
    if (!d.view.has_data) return;
    Labels labels(d);
    for (const Guide& guide : d.model.guides) draw_guide(d, guide, labels);
}

}  // namespace pliant::viewer
