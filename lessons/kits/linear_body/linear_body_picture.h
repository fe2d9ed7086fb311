// What the pictures of linear elastic bodies share.
#pragma once
#include <pliant/lesson/lesson.h>
#include <pliant/lesson/unstructured_grid.h>
#include <pliant/mesh/simplex_mesh.h>

#include <functional>

namespace pliant::linear_body {

// 1, 2, 5, 10, 20, ... (or 0.5, 0.2, ...), so that a strain is drawn as about 0.12 to 0.3; 1 for strains that show by themselves.
Real magnification_for(Real largest_strain);

// The deformed surface, `place` giving where a node is drawn. A field of elements colours each facet by the element that it
// bounds.
void draw_surface(Scene& scene, const Lesson& lesson, const SimplexMesh<3>& mesh, const std::function<Vec<3>(Index node)>& place,
                  float opacity = 1);

// Its elements at their places now, for other programs.
template <int Dim>
UnstructuredGrid grid_of_body(const SimplexMesh<Dim>& mesh, const Points<3>& displacement) {
    return grid_of(in_space(mesh.points()) + displacement, Dim == 2 ? CellKind::triangle : CellKind::tetrahedron,
                   mesh.simplices(), {On::element});
}

}  // namespace pliant::linear_body
