#include "render/moving_parts.h"

namespace pliant::viewer {

bool moves(Ink ink) { return ink == Ink::body || ink == Ink::edge || ink == Ink::accent; }

std::vector<Position> moving_parts(const Scene& scene) {
    std::vector<Position> parts;
    const auto add = [&](Ink ink, const std::vector<Position>& places) {
        if (moves(ink)) parts.insert(parts.end(), places.begin(), places.end());
    };
    for (const TriangleMarks& t : scene.triangles) add(t.ink, t.corners);
    for (const LineMarks& l : scene.lines) add(l.ink, l.ends);
    for (const PointMarks& p : scene.points) add(p.ink, p.at);
    return parts;
}

}  // namespace pliant::viewer
