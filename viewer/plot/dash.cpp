#include <cmath>

#include "plot/trace.h"

namespace pliant::viewer {
namespace {

float distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }
Point between(Point a, Point b, float t) { return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; }

// Walks along a line and lifts the pen as the pattern says.
class Pen {
public:
    Pen(std::span<const float> pattern, Runs& out) : pattern_(pattern), left_(pattern[0]), out_(out) {}

    void put_down(Point at) {
        if (!drawn()) return;
        out_.starts.push_back(out_.points.size());
        out_.points.push_back(at);
    }
    void go(Point from, Point to) {
        const float length = distance(from, to);
        float done = 0;
        while (length - done >= left_) {
            done += left_;
            const Point here = between(from, to, done / length);
            if (drawn()) out_.points.push_back(here);
            part_ = (part_ + 1) % pattern_.size();
            left_ = pattern_[part_];
            put_down(here);
        }
        left_ -= length - done;
        if (drawn() && done < length) out_.points.push_back(to);
    }

private:
    bool drawn() const { return part_ % 2 == 0; }

    std::span<const float> pattern_;
    std::size_t part_ = 0;
    float left_;  // px to go in the present part
    Runs& out_;
};

}  // namespace

void dash(const Runs& lines, std::span<const float> pattern, Runs& out) {
    out.clear();
    for (std::size_t i = 0; i < lines.count(); ++i) {
        const auto run = lines.run(i);
        Pen pen(pattern, out);
        pen.put_down(run.front());
        for (std::size_t k = 1; k < run.size(); ++k) pen.go(run[k - 1], run[k]);
    }
}

void spaced(const Runs& lines, float spacing, float first, std::vector<Point>& out) {
    out.clear();
    Point last{};
    float wanted = first;
    for (std::size_t i = 0; i < lines.count(); ++i) {
        const auto run = lines.run(i);
        if (out.empty()) last = run.front();
        for (const Point point : run) {
            if (distance(last, point) < wanted) continue;
            out.push_back(point);
            last = point;
            wanted = spacing;
        }
    }
}

}  // namespace pliant::viewer
