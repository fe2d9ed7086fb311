#include "plot/free_place.h"

#include <algorithm>
#include <array>
#include <optional>

namespace pliant::viewer {
namespace {

// Places that differ by less than this part of what is around cover as much: the box does not jump for a single point.
constexpr std::size_t shades = 16;

bool touches(Point corner, Point size, Point at, float gap) {
    return at.x > corner.x - gap && at.x < corner.x + size.x + gap && at.y > corner.y - gap && at.y < corner.y + size.y + gap;
}

std::size_t covered(Point corner, Point size, std::span<const Point> around) {
    const auto count = std::ranges::count_if(around, [&](Point p) { return touches(corner, size, p, 0); });
    return around.empty() ? 0 : (static_cast<std::size_t>(count) * shades + around.size() - 1) / around.size();
}

}  // namespace

Point free_place(Point at, Point size, float gap, Box room, std::span<const Point> around) {
    const float left = at.x - gap - size.x, right = at.x + gap, above = at.y - gap - size.y, below = at.y + gap,
                across = at.x - size.x / 2, beside = at.y - size.y / 2;
    const float end_x = room.max.x - size.x, end_y = room.max.y - size.y;
    const std::array<Point, 12> corners{{{right, below},
                                         {left, below},
                                         {right, above},
                                         {left, above},
                                         {right, beside},
                                         {left, beside},
                                         {across, below},
                                         {across, above},
                                         {end_x, room.min.y},
                                         {room.min.x, room.min.y},
                                         {end_x, end_y},
                                         {room.min.x, end_y}}};
    std::optional<Point> best;
    std::size_t least = 0;
    for (Point corner : corners) {
        corner.x = std::max(room.min.x, std::min(corner.x, end_x));
        corner.y = std::max(room.min.y, std::min(corner.y, end_y));
        if (touches(corner, size, at, 0.9f * gap)) continue;
        const std::size_t count = covered(corner, size, around);
        if (!best || count < least) best = corner, least = count;
    }
    return best.value_or(room.min);
}

}  // namespace pliant::viewer
