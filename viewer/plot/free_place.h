// Where words go that follow the pointer.
#pragma once
#include "plot/trace.h"

#include <span>

namespace pliant::viewer {

// The upper left corner, px, of a box of this size in the room that keeps `gap` from `at` and covers as little as can be of what
// is around: the first such one of right and left, below and above, then of the corners of the room. In a room that is too small
// the box begins at the room's upper left corner and may cover `at`.
Point free_place(Point at, Point size, float gap, Box room, std::span<const Point> around);

}  // namespace pliant::viewer
