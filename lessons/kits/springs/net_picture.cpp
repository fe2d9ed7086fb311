#include "kits/springs/net_picture.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

namespace pliant::springs {

void draw_surface(Scene& picture, const Lesson& lesson, PointsIn<3> x, const std::vector<NodeTriple>& triangles, float opacity) {
    TriangleMarks body{
        .corners = {}, .triangles = {}, .values = picture.values(lesson, On::node), .ink = Ink::body, .opacity = opacity};
    for (Index n = 0; n < x.cols(); ++n) body.corners.push_back(position<3>(x.col(n)));
    for (const auto& [a, b, c] : triangles) body.triangles.push_back({int(a), int(b), int(c)});
    picture.triangles.push_back(std::move(body));
}

void draw_pairs(Scene& picture, PointsIn<3> x, const std::vector<NodePair>& pairs, float width) {
    LineMarks lines{.ends = {}, .ink = Ink::edge, .width = width};
    for (const NodePair& pair : pairs)
        for (const Index n : pair) lines.ends.push_back(position<3>(x.col(n)));
    picture.lines.push_back(std::move(lines));
}

void draw_springs(Scene& picture, const Lesson& lesson, const Springs& springs, PointsIn<3> x,
                  const std::array<Index, spring_families + 1>& first) {
    const std::vector<float> values = picture.values(lesson, On::edge);
    constexpr std::array<float, spring_families> widths{3, 1.5f, 1};
    for (const SpringFamily family : {bending, shear, structural}) {
        LineMarks marks{.ends = {}, .ink = Ink::edge, .width = widths[family], .pick = {.pickable = true, .on = On::edge}};
        marks.pick.first = first[family];
        for (Index s = first[family]; s < first[family + 1]; ++s)
            for (const Index n : {springs.i(s), springs.j(s)}) marks.ends.push_back(position<3>(x.col(n)));
        if (!values.empty()) marks.values.assign(values.begin() + first[family], values.begin() + first[family + 1]);
        picture.lines.push_back(std::move(marks));
    }
}

void draw_nodes(Scene& picture, const Lesson& lesson, const DiagonalMass& inertia, PointsIn<3> x, float radius,
                float fixed_radius) {
    PointMarks nodes{.at = {},
                     .values = picture.values(lesson, On::node),
                     .ink = Ink::body,
                     .radius = radius,
                     .pick = {.pickable = true, .on = On::node}};
    PointMarks fixed{.at = {}, .ink = Ink::fixed, .radius = fixed_radius};
    for (Index n = 0; n < x.cols(); ++n) {
        nodes.at.push_back(position<3>(x.col(n)));
        if (inertia.fixed(3 * n)) fixed.at.push_back(nodes.at.back());
    }
    picture.points.push_back(std::move(nodes));
    if (!fixed.at.empty() && fixed_radius > 0) picture.points.push_back(std::move(fixed));
}

void draw_pull(Scene& picture, const PullSpring<3>& hand, Real stiffness, PointsIn<3> x) {
    if (hand.node < 0 || !(stiffness > 0)) return;
    const Vec<3> from = x.col(hand.node), to = hand.target;
    picture.arrow(position<3>(from), position<3>(to), Ink::force, format_quantity(stiffness * (to - from).norm(), "N", 3));
}

bool take_hold(ExternalLoad<3>& load, const std::optional<Pull>& hand, Index nodes) {
    load.pull.node = -1;
    if (!hand || hand->index < 0) return false;
    if (hand->index >= nodes) throw Refused(fmt::format("pull: node {} does not exist, there are {} nodes", hand->index, nodes));
    if (!hand->to.allFinite()) throw Refused("pull: give a finite place in m");
    load.pull.node = hand->index;
    load.pull.target = hand->to;
    return true;
}

UnstructuredGrid grid_of_springs(const Springs& springs, PointsIn<3> x) {
    Eigen::MatrixXi ends(2, springs.size());
    for (Index s = 0; s < springs.size(); ++s) ends.col(s) << static_cast<int>(springs.i(s)), static_cast<int>(springs.j(s));
    return grid_of(x, CellKind::line, std::move(ends), {On::edge});
}

}  // namespace pliant::springs
