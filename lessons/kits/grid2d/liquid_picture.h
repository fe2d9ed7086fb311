// The liquid of a level set as a picture: triangles up to the surface, and the surface as a line.
#pragma once
#include <pliant/fluids/staggered_grid.h>
#include <pliant/lesson/scene.h>

namespace pliant::grid2d {

// distance: signed, at the cell centres, m; between them linear, so that the surface is drawn where φ = 0. values: a number per
// cell that gives its colour, or none for the ink of a body.
void draw_liquid(Scene& picture, const StaggeredGrid<2>& grid, const VecX& distance, const std::vector<float>& values);

}  // namespace pliant::grid2d
