// Pictures of a plane flow on a staggered grid.
#pragma once
#include <pliant/fluids/staggered_grid.h>
#include <pliant/fluids/velocity_sampler.h>
#include <pliant/lesson/lesson.h>
#include <pliant/lesson/scene.h>
#include <pliant/lesson/unstructured_grid.h>

namespace pliant::grid2d {

// The heat map of the field that is chosen. Numbers on faces are drawn as cells around the faces, half of which reach beyond the
// walls; a lesson without a field on the grid to show gets the plain cells.
void draw_field(Scene& scene, const Lesson& lesson, const StaggeredGrid<2>& grid);

// Its cells, for other programs.
UnstructuredGrid grid_of_cells(const StaggeredGrid<2>& grid);

// What is no fluid: squares of the cells.
void draw_solids(Scene& scene, const StaggeredGrid<2>& grid);

// The velocity as arrows on evenly spaced places, at most `most` along the longer side. speed: m/s of an arrow that is as long as
// the arrows are apart. Places that `shown`, if given, turns down stay empty.
void draw_velocity(Scene& scene, const StaggeredGrid<2>& grid, const VelocitySampler<2>& flow, Real speed, Index most = 18,
                   const std::function<bool(const Vec<2>&)>& shown = {});

// The liquid of a level set as a picture: triangles up to the surface, and the surface as a line.

// distance: signed, at the cell centres, m; between them linear, so that the surface is drawn where φ = 0. values: a number per
// cell that gives its colour, or none for the ink of a body.
void draw_liquid(Scene& picture, const StaggeredGrid<2>& grid, const VecX& distance, const std::vector<float>& values);

}  // namespace pliant::grid2d
