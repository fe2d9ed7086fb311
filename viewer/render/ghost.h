// A picture of before, to lay faintly under that of now.
#pragma once
#include <pliant/lesson/scene.h>

namespace pliant::viewer {

// In one ink, what moves: bodies as their outlines, or else their lines dashed and their points small, and a heat map as
// contours; no arrows, words or fills.
Scene ghost_of(const Scene& scene);
// Below all that the picture has of its own.
void lay_under(Scene& picture, const Scene& ghost);

}  // namespace pliant::viewer
