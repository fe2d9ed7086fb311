#include "plot/trace.h"

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

struct Place {
    Real x, y;  // px
};

// Joins places to lines and cuts these at the edges of a rectangle.
class LineBuilder {
public:
    LineBuilder(Place min, Place max, Runs& out) : min_(min), max_(max), out_(out) { out_.clear(); }

    void gap() { has_last_ = drawing_ = false; }
    void add(Place place) {
        const bool visible = inside(place);
        if (has_last_ && drawing_ && visible) {
            push(place);
        } else if (has_last_) {
            add_cut(last_, place);
        } else if (visible) {
            begin(place);
        }
        last_ = place;
        has_last_ = true;
        drawing_ = visible;
    }

private:
    bool inside(Place p) const { return p.x >= min_.x && p.x <= max_.x && p.y >= min_.y && p.y <= max_.y; }
    void push(Place p) { out_.points.push_back({static_cast<float>(p.x), static_cast<float>(p.y)}); }
    void begin(Place p) {
        out_.starts.push_back(out_.points.size());
        push(p);
    }
    // The part of the segment inside the rectangle, if any (Liang and Barsky 1984).
    void add_cut(Place a, Place b) {
        Real enter = 0, leave = 1;
        const auto cut = [&](Real direction, Real distance) {
            if (direction == 0) return distance >= 0;
            const Real t = distance / direction;
            if (direction < 0)
                enter = std::max(enter, t);
            else
                leave = std::min(leave, t);
            return enter <= leave;
        };
        const Real dx = b.x - a.x, dy = b.y - a.y;
        if (!cut(-dx, a.x - min_.x) || !cut(dx, max_.x - a.x) || !cut(-dy, a.y - min_.y) || !cut(dy, max_.y - a.y)) return;
        if (!drawing_) begin({a.x + enter * dx, a.y + enter * dy});
        push({a.x + leave * dx, a.y + leave * dy});
    }

    Place min_, max_, last_{};
    bool has_last_ = false, drawing_ = false;
    Runs& out_;
};

bool never_falls(std::span<const Real> xs) {
    for (std::size_t i = 1; i < xs.size(); ++i) {
        if (!(xs[i] >= xs[i - 1])) return false;
    }
    return xs.empty() || std::isfinite(xs.front());
}

// Every sample, less those that fall on the one before.
void trace_all(std::span<const Real> xs, std::span<const Real> ys, const AxisMap& x, const AxisMap& y, Real apart,
               LineBuilder& lines) {
    Place last{};
    bool open = false;
    for (std::size_t i = 0; i < xs.size(); ++i) {
        if (!x.plots(xs[i]) || !y.plots(ys[i])) {
            lines.gap();
            open = false;
            continue;
        }
        const Place place{x.pixel(xs[i]), y.pixel(ys[i])};
        const bool same = open && std::abs(place.x - last.x) < apart && std::abs(place.y - last.y) < apart && i + 1 < xs.size();
        if (same) continue;
        lines.add(place);
        last = place;
        open = true;
    }
}

// Adds the lowest and the highest of the samples in [begin, end), in their order. A gap among them is kept at the end of the
// column where it lies.
void trace_column(std::span<const Real> xs, std::span<const Real> ys, std::size_t begin, std::size_t end, const AxisMap& x,
                  const AxisMap& y, LineBuilder& lines) {
    std::size_t low = end, high = end;
    bool gap_inside = false;
    for (std::size_t i = begin; i < end; ++i) {
        if (!y.plots(ys[i])) {
            if (low == end)
                lines.gap();
            else
                gap_inside = true;
            continue;
        }
        if (low == end) low = high = i;
        if (ys[i] < ys[low]) low = i;
        if (ys[i] > ys[high]) high = i;
    }
    if (low == end) return;
    const auto [first, second] = std::minmax(low, high);
    lines.add({x.pixel(xs[first]), y.pixel(ys[first])});
    if (second != first) lines.add({x.pixel(xs[second]), y.pixel(ys[second])});
    if (gap_inside) lines.gap();
}

}  // namespace

bool trace(std::span<const Real> xs, std::span<const Real> ys, const AxisMap& x, const AxisMap& y, float around, Runs& out) {
    const std::size_t count = std::min(xs.size(), ys.size());
    xs = xs.first(count), ys = ys.first(count);
    const Real left = std::min(x.low(), x.high()) - around, right = std::max(x.low(), x.high()) + around;
    LineBuilder lines({left, std::min(y.low(), y.high()) - around}, {right, std::max(y.low(), y.high()) + around}, out);
    constexpr Real same_place = 0.25;  // px
    if (!never_falls(xs)) {
        trace_all(xs, ys, x, y, same_place, lines);
        return false;
    }

    // One sample more on either side, so that lines run out of the picture.
    const auto offset = [&xs](auto it) { return static_cast<std::size_t>(it - xs.begin()); };
    std::size_t begin = offset(std::lower_bound(xs.begin(), xs.end(), x.value(std::min(left, right))));
    std::size_t end = offset(std::upper_bound(xs.begin(), xs.end(), x.value(right)));
    if (begin > 0) --begin;
    if (end < count) ++end;
    while (begin < end && !x.plots(xs[begin])) ++begin;
    const auto columns = static_cast<std::size_t>(right - left) + 1;
    if (end - begin <= 4 * columns) {
        trace_all(xs.subspan(begin, end - begin), ys.subspan(begin, end - begin), x, y, 0, lines);
        return true;
    }

    for (std::size_t column = 0; begin < end; ++column) {
        const Real edge = x.value(left + static_cast<Real>(column) + 1);
        std::size_t stop = offset(std::upper_bound(xs.begin() + static_cast<std::ptrdiff_t>(begin),
                                                   xs.begin() + static_cast<std::ptrdiff_t>(end), edge));
        if (column >= columns) stop = end;
        trace_column(xs, ys, begin, stop, x, y, lines);
        begin = stop;
    }
    return true;
}

void scatter(std::span<const Real> xs, std::span<const Real> ys, const AxisMap& x, const AxisMap& y, float cell,
             std::vector<Point>& out) {
    out.clear();
    const Real left = std::min(x.low(), x.high()), right = std::max(x.low(), x.high());
    const Real top = std::min(y.low(), y.high()), bottom = std::max(y.low(), y.high());
    const auto columns = static_cast<std::size_t>((right - left) / cell) + 1,
               rows = static_cast<std::size_t>((bottom - top) / cell) + 1;
    std::vector<bool> taken(columns * rows);
    for (std::size_t i = 0; i < std::min(xs.size(), ys.size()); ++i) {
        if (!x.plots(xs[i]) || !y.plots(ys[i])) continue;
        const Real px = x.pixel(xs[i]), py = y.pixel(ys[i]);
        if (px < left || px > right || py < top || py > bottom) continue;
        const auto at = static_cast<std::size_t>((py - top) / cell) * columns + static_cast<std::size_t>((px - left) / cell);
        if (taken[at]) continue;
        taken[at] = true;
        out.push_back({static_cast<float>(px), static_cast<float>(py)});
    }
}

std::optional<std::size_t> nearest_sample(std::span<const Real> xs, std::span<const Real> ys, const AxisMap& x, const AxisMap& y,
                                          Point at, float radius) {
    // Only samples inside the square about the place are worth a logarithm.
    const auto around = [radius](const AxisMap& map, Real pixel) {
        const Real a = map.value(pixel - radius), b = map.value(pixel + radius);
        return Range{std::min(a, b), std::max(a, b)};
    };
    const Range near_x = around(x, at.x), near_y = around(y, at.y);
    std::optional<std::size_t> best;
    Real best_distance = Real{radius} * radius;
    for (std::size_t i = 0; i < std::min(xs.size(), ys.size()); ++i) {
        if (!near_x.contains(xs[i]) || !near_y.contains(ys[i]) || !x.plots(xs[i]) || !y.plots(ys[i])) continue;
        const Real dx = x.pixel(xs[i]) - at.x, dy = y.pixel(ys[i]) - at.y;
        if (dx * dx + dy * dy >= best_distance) continue;
        best_distance = dx * dx + dy * dy;
        best = i;
    }
    return best;
}

}  // namespace pliant::viewer
