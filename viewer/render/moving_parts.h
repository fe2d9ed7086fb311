// Which marks of a picture move.
#pragma once
#include <pliant/lesson/scene.h>

#include <vector>

namespace pliant::viewer {

// Bodies, their meshes and what to look at. Walls, supports and guides stay where they are, and words tell of now.
bool moves(Ink ink);

// The corners, ends and points of the marks that move, m.
std::vector<Position> moving_parts(const Scene& scene);

}  // namespace pliant::viewer
