// The picture of an elastic body on a mesh: its deformed surface, its outline at rest, supports, loads, and one element lit.
#pragma once
#include "solid.h"

#include <pliant/lesson/lesson.h>

namespace pliant::solid_mesh {

// What is drawn: displacements (dim × nodes, m) times a magnification.
struct Drawn {
    const Solid* solid;
    const MatX* u;
    Real magnification = 1;

    Vec<3> place(Index node) const { return solid->place(node, *u, magnification); }
    Vec<3> middle(Index element) const;
};

// Size of the body at rest [m]: the diagonal of its box.
Real size_at_rest(const Solid& solid);
// 1 where displacements show by themselves; else what draws the largest as about an eighth of the body.
Real magnification_for(const Solid& solid, const MatX& u);

// Triangles, or the surface of tetrahedra, in the colours that are chosen; elements can be picked. Nodes as points that can be
// picked and pulled.
void draw_body(Scene& scene, const Lesson& lesson, const Drawn& drawn, float opacity = 1);
void draw_nodes(Scene& scene, const Drawn& drawn, float radius = 3);
// The outline at rest: boundary edges in the plane, sharp edges in space.
void draw_rest(Scene& scene, const Solid& solid);
void draw_supports(Scene& scene, const Drawn& drawn);
// The loaded face as a support, which turns it.
void draw_turned(Scene& scene, const Drawn& drawn);
// Arrows on the loaded face, towards the whole force [N], and its label.
void draw_load(Scene& scene, const Drawn& drawn, const Vec<3>& force);
// Its edges, and the numbers of its corners.
void draw_element(Scene& scene, const Drawn& drawn, Index element, bool numbers);
// The box about the body at rest, larger by a share of its size on all sides.
void frame_body(Scene& scene, const Solid& solid, Real margin);

}  // namespace pliant::solid_mesh
