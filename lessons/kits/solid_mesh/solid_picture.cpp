#include "solid_picture.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pliant::solid_mesh {
namespace {

constexpr Real sharp = 0.6;  // cosine of the angle between facets, below which their edge is drawn

Position at_place(const Vec<3>& x) { return position<3>(x); }

// Corners of the triangles that stand for a facet of so many nodes in space, or an element in the plane: with the middles of
// edges, four.
std::vector<std::array<int, 3>> triangles_of(Index nodes) {
    if (nodes < 6) return {{0, 1, 2}};
    return {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
}

}  // namespace

Vec<3> Drawn::middle(Index element) const {
    Vec<3> sum = Vec<3>::Zero();
    for (int a = 0; a <= solid->dim(); ++a) sum += place(solid->node(element, a));
    return sum / (solid->dim() + 1);
}

Real size_at_rest(const Solid& solid) { return (solid.rest().rowwise().maxCoeff() - solid.rest().rowwise().minCoeff()).norm(); }

Real magnification_for(const Solid& solid, const MatX& u) {
    const Real largest = u.size() ? u.cwiseAbs().maxCoeff() : 0, size = size_at_rest(solid);
    if (!(largest > 0) || largest > 0.02 * size) return 1;
    const Real wanted = 0.125 * size / largest, decade = std::pow(10.0, std::floor(std::log10(wanted)));
    const Real lead = wanted / decade;
    return std::max<Real>(1, decade * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1));
}

void draw_body(Scene& scene, const Lesson& lesson, const Drawn& drawn, float opacity) {
    const Solid& solid = *drawn.solid;
    TriangleMarks surface{.corners = {}, .triangles = {}, .ink = Ink::body, .opacity = opacity, .edges = true};
    const std::vector<float> on_nodes = scene.values(lesson, On::node), on_elements = scene.values(lesson, On::element);
    const bool flat_body = solid.dim() == 2;
    const Eigen::MatrixXi& faces = flat_body ? solid.elements() : solid.facets();
    const auto parts = triangles_of(faces.rows());
    for (Index f = 0; f < faces.cols(); ++f) {
        const Index element = flat_body ? f : solid.facet_elements()[static_cast<std::size_t>(f)];
        for (const auto& part : parts) {
            const int first = static_cast<int>(surface.corners.size());
            surface.triangles.push_back({first, first + 1, first + 2});
            for (const int k : part) {
                const Index n = faces(k, f);
                surface.corners.push_back(at_place(drawn.place(n)));
                if (!on_nodes.empty()) surface.values.push_back(on_nodes[static_cast<std::size_t>(n)]);
                if (!on_elements.empty()) surface.values.push_back(on_elements[static_cast<std::size_t>(element)]);
            }
            surface.pick.ids.push_back(element);
        }
    }
    surface.pick.pickable = true;
    surface.pick.on = On::element;
    scene.triangles.push_back(std::move(surface));
}

void draw_nodes(Scene& scene, const Drawn& drawn, float radius) {
    const Solid& solid = *drawn.solid;
    std::vector<char> wanted(static_cast<std::size_t>(solid.node_count()), solid.dim() == 2);
    for (Index f = 0; f < solid.facets().cols(); ++f)
        for (Index a = 0; a < solid.facets().rows(); ++a) wanted[static_cast<std::size_t>(solid.facets()(a, f))] = 1;
    PointMarks nodes{.at = {}, .ink = Ink::edge, .radius = solid.node_count() > 60 ? 0.6f * radius : radius};
    for (Index n = 0; n < solid.node_count(); ++n)
        if (wanted[static_cast<std::size_t>(n)]) nodes.at.push_back(at_place(drawn.place(n))), nodes.pick.ids.push_back(n);
    nodes.pick.pickable = true;
    nodes.pick.on = On::node;
    scene.points.push_back(std::move(nodes));
}

void draw_rest(Scene& scene, const Solid& solid) {
    LineMarks outline{.ends = {}, .ink = Ink::rest, .width = 1.5f, .dashed = true};
    const auto add = [&](Index a, Index b) {
        outline.ends.push_back(at_place(solid.rest(a))), outline.ends.push_back(at_place(solid.rest(b)));
    };
    if (solid.dim() == 2) {
        for (Index f = 0; f < solid.facets().cols(); ++f) add(solid.facets()(0, f), solid.facets()(1, f));
    } else {
        std::map<std::pair<int, int>, Vec<3>> seen;
        for (Index f = 0; f < solid.facets().cols(); ++f) {
            const Vec<3> n = Vec<3>(solid.facet_areas().col(f)).normalized();
            for (int k = 0; k < 3; ++k) {
                const int a = solid.facets()(k, f), b = solid.facets()((k + 1) % 3, f);
                const auto [other, is_new] = seen.try_emplace({std::min(a, b), std::max(a, b)}, n);
                if (!is_new && other->second.dot(n) < sharp) add(a, b);
            }
        }
    }
    if (!outline.ends.empty()) scene.lines.push_back(std::move(outline));
}

namespace {

void draw_held(Scene& scene, const Drawn& drawn, const std::vector<Index>& facets) {
    const Solid& solid = *drawn.solid;
    if (facets.empty()) return;
    const Real off = 0.003 * size_at_rest(solid);
    if (solid.dim() == 2) {
        LineMarks held{.ends = {}, .ink = Ink::fixed, .width = 6};
        for (const Index f : facets)
            for (int a = 0; a < 2; ++a) held.ends.push_back(at_place(drawn.place(solid.facets()(a, f))));
        scene.lines.push_back(std::move(held));
        return;
    }
    TriangleMarks held{.corners = {}, .triangles = {}, .ink = Ink::fixed, .opacity = 0.8f};
    LineMarks rim{.ends = {}, .ink = Ink::fixed, .width = 3};
    for (const Index f : facets) {
        const Vec<3> out = off * Vec<3>(solid.facet_areas().col(f)).normalized();
        const int first = static_cast<int>(held.corners.size());
        held.triangles.push_back({first, first + 1, first + 2});
        for (int a = 0; a < 3; ++a) {
            held.corners.push_back(at_place(drawn.place(solid.facets()(a, f)) + out));
            rim.ends.push_back(at_place(drawn.place(solid.facets()(a, f))));
            rim.ends.push_back(at_place(drawn.place(solid.facets()((a + 1) % 3, f))));
        }
    }
    scene.triangles.push_back(std::move(held));
    scene.lines.push_back(std::move(rim));
}

}  // namespace

void draw_supports(Scene& scene, const Drawn& drawn) { draw_held(scene, drawn, drawn.solid->fixed_facets()); }
void draw_turned(Scene& scene, const Drawn& drawn) { draw_held(scene, drawn, drawn.solid->loaded_facets()); }

void draw_load(Scene& scene, const Drawn& drawn, const Vec<3>& force) {
    const Solid& solid = *drawn.solid;
    const auto& facets = solid.loaded_facets();
    if (facets.empty() || !(force.norm() > 0)) return;
    const Vec<3> along = 0.16 * size_at_rest(solid) * force.normalized();
    // Outward arrows begin on the face, inward ones end there.
    Vec<3> outward = Vec<3>::Zero(), middle = Vec<3>::Zero();
    for (const Index f : facets) outward.head(solid.dim()) += solid.facet_areas().col(f);
    const bool leaves = outward.dot(force) >= -1e-9 * outward.norm() * force.norm();
    // One arrow for a pull along the face, which would hide the others.
    const bool along_face = std::abs(outward.dot(force)) < 0.3 * outward.norm() * force.norm();
    const auto middle_of = [&](Index facet) {
        Vec<3> sum = Vec<3>::Zero();
        for (int a = 0; a < solid.dim(); ++a) sum += drawn.place(solid.facets()(a, facet));
        return Vec<3>(sum / solid.dim());
    };
    for (const Index f : facets) middle += middle_of(f) / static_cast<Real>(facets.size());
    ArrowMarks arrows{.from = {}, .to = {}};
    const auto add = [&](const Vec<3>& on_face) {
        arrows.from.push_back(at_place(leaves ? on_face : Vec<3>(on_face - along)));
        arrows.to.push_back(at_place(leaves ? Vec<3>(on_face + along) : on_face));
    };
    const std::size_t every = std::max<std::size_t>(1, facets.size() / (solid.dim() == 2 ? 3 : 6));
    if (along_face)
        add(middle);
    else
        for (std::size_t f = every / 2; f < facets.size(); f += every) add(middle_of(facets[f]));
    const Vec<3> end = leaves ? Vec<3>(middle + along) : Vec<3>(middle - along);
    scene.arrows.push_back(std::move(arrows));
    LabelMark label{.at = at_place(end), .text = fmt::format("F = {}", format_quantity(force.norm(), "N")), .ink = Ink::force};
    label.away_from = at_place(middle);
    scene.labels.push_back(std::move(label));
}

void draw_element(Scene& scene, const Drawn& drawn, Index element, bool numbers) {
    const Solid& solid = *drawn.solid;
    const int corners = solid.dim() + 1;
    LineMarks edges{.ends = {}, .ink = Ink::accent, .width = 4};
    for (int a = 0; a < corners; ++a)
        for (int b = a + 1; b < corners; ++b) {
            edges.ends.push_back(at_place(drawn.place(solid.node(element, a))));
            edges.ends.push_back(at_place(drawn.place(solid.node(element, b))));
        }
    scene.lines.push_back(std::move(edges));
    if (!numbers) return;
    const Vec<3> middle = drawn.middle(element);
    for (int a = 0; a < corners; ++a) {
        const Index n = solid.node(element, a);
        LabelMark label{.at = at_place(drawn.place(n)), .text = fmt::format("{}", n), .ink = Ink::accent};
        label.away_from = at_place(middle);
        scene.labels.push_back(std::move(label));
    }
}

void frame_body(Scene& scene, const Solid& solid, Real margin) {
    Vec<3> low = Vec<3>::Zero(), high = Vec<3>::Zero();
    low.head(solid.dim()) = solid.rest().rowwise().minCoeff();
    high.head(solid.dim()) = solid.rest().rowwise().maxCoeff();
    const Real more = margin * (high - low).norm();
    for (int k = 0; k < solid.dim(); ++k) low[k] -= more, high[k] += more;
    scene.frame(at_place(low), at_place(high));
}

}  // namespace pliant::solid_mesh
