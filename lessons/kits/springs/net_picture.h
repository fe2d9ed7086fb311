// What the pictures of spring nets in space share, and the hand that pulls at them.
#pragma once
#include <pliant/lesson/lesson.h>
#include <pliant/lesson/unstructured_grid.h>
#include <pliant/mesh/spring_lattice.h>
#include <pliant/solids/springs.h>
#include <pliant/solids/springs_system.h>
#include <pliant/time/mass.h>

#include <array>
#include <optional>
#include <vector>

namespace pliant::springs {

// Of a node's field.
void draw_surface(Scene& picture, const Lesson& lesson, PointsIn<3> x, const std::vector<NodeTriple>& triangles,
                  float opacity = 1);
void draw_pairs(Scene& picture, PointsIn<3> x, const std::vector<NodePair>& pairs, float width);
// The springs of each family, from first[family] to before first[family + 1]. Those to the next node but one lie on the
// structural ones, and so are drawn below them.
void draw_springs(Scene& picture, const Lesson& lesson, const Springs& springs, PointsIn<3> x,
                  const std::array<Index, spring_families + 1>& first);
// fixed_radius: of the nodes that are held; 0 does not mark them. px
void draw_nodes(Scene& picture, const Lesson& lesson, const DiagonalMass& inertia, PointsIn<3> x, float radius,
                float fixed_radius);
// The force of the hand, where one pulls. stiffness: of its spring, N/m
void draw_pull(Scene& picture, const PullSpring<3>& hand, Real stiffness, PointsIn<3> x);

// Where a hand draws a node to from now on; nothing releases it. Returns whether one pulls. Throws Refused for a node that there
// is not, and for a place that is not finite.
bool take_hold(ExternalLoad<3>& load, const std::optional<Pull>& hand, Index nodes);

// Nodes and springs at their places now, for other programs.
UnstructuredGrid grid_of_springs(const Springs& springs, PointsIn<3> x);

}  // namespace pliant::springs
