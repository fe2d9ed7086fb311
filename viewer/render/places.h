// Where the things of a picture are: nodes, springs, elements, cells.
#pragma once
#include <pliant/lesson/scene.h>

#include <map>
#include <optional>

namespace pliant::viewer {

// The middle of every pickable mark on `on`, by index.
std::map<Index, Position> places_of(const Scene& scene, On on);
// Of one of them; empty when the picture does not show it.
std::optional<Position> place_of(const Scene& scene, On on, Index index);

}  // namespace pliant::viewer
