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

    void go(Point from, Point to) {
        const float length = distance(from, to);
        float done = 0;
        Point here = from;
        while (length - done >= left_) {
            done += left_;
            const Point next = between(from, to, done / length);
            draw(here, next);
            here = next;
            part_ = (part_ + 1) % pattern_.size();
            left_ = pattern_[part_];
            on_paper_ = false;
        }
        left_ -= length - done;
        if (done < length) draw(here, to);
    }

private:
    void draw(Point from, Point to) {
        if (part_ % 2 != 0) return;
        if (!on_paper_) {
            out_.starts.push_back(out_.points.size());
            out_.points.push_back(from);
        }
        out_.points.push_back(to);
        on_paper_ = true;
    }

    std::span<const float> pattern_;
    std::size_t part_ = 0;
    float left_;  // px to go in the present part
    bool on_paper_ = false;
    Runs& out_;
};

}  // namespace

void dash(const Runs& lines, std::span<const float> pattern, Runs& out) {
    out.clear();
    for (std::size_t i = 0; i < lines.count(); ++i) {
        const auto run = lines.run(i);
        Pen pen(pattern, out);
        for (std::size_t k = 1; k < run.size(); ++k) pen.go(run[k - 1], run[k]);
    }
}

void spaced(const Runs& lines, float spacing, float first, bool x_alone, std::vector<Point>& out) {
    out.clear();
    Point last{};
    float wanted = first;
    for (std::size_t i = 0; i < lines.count(); ++i) {
        const auto run = lines.run(i);
        if (out.empty()) last = run.front();
        for (const Point point : run) {
            if ((x_alone ? std::abs(point.x - last.x) : distance(last, point)) < wanted) continue;
            out.push_back(point);
            last = point;
            wanted = spacing;
        }
    }
}

}  // namespace pliant::viewer
