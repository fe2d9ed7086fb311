// The picture: elements drawn apart, the forces on the faces of one or of all, the share of each node and their sum, and the
// force of finite elements under it.
#include "fvm.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::fvm {
namespace {

constexpr Index most_apart = 4000;                         // elements that are drawn one by one
constexpr Real longest_arrow = 0.5, longest_of_all = 0.2;  // in sizes of the body
constexpr Real least_arrow = 0.01;                         // shorter ones are not drawn

Vec<3> as_space(const VecX& v) {
    Vec<3> x = Vec<3>::Zero();
    x.head(v.size()) = v;
    return x;
}

}  // namespace

// A place drawn towards the middle of its element.
Vec<3> FvmLesson::apart(Index element, const Vec<3>& x) const {
    return x + (solid_->element_count() > most_apart ? Real{0} : Real{shrink}) * (drawn().middle(element) - x);
}

// What the load makes of a face, about, so that arrows do not change their scale while the body swings.
Real FvmLesson::arrow_scale() const {
    const Real slender = body.length / body.height;
    Real usual = 2 * slender * (load_force().norm() + mass_.sum() * weight_acceleration() / 2);
    if (!held()) usual = 0.1 * mass_.sum() * spin_rate * spin_rate * body.length;
    if (in_space()) usual /= static_cast<Real>(Index(body.cells_z));
    const Real largest = std::max(usual, largest_face_force());
    return largest > 0 ? (all_faces ? longest_of_all : longest_arrow) * solid_mesh::size_at_rest(*solid_) / largest : Real{0};
}

void FvmLesson::draw_elements(Scene& scene) const {
    const Solid& solid = *solid_;
    if (solid.element_count() > most_apart) return solid_mesh::draw_body(scene, *this, drawn());
    const std::vector<float> on_nodes = scene.values(*this, On::node), on_elements = scene.values(*this, On::element),
                             on_faces = scene.values(*this, On::face);
    // In space the lit element is seen through the others.
    TriangleMarks others{.corners = {}, .triangles = {}, .ink = Ink::body, .edges = true}, own = others;
    for (TriangleMarks* each : {&others, &own}) each->pick.pickable = true, each->pick.on = On::element;
    if (solid.dim() == 3 && scene.show_arrows) others.opacity = 0.25f, others.edges = false;
    const auto add = [&](Index e, const std::vector<Index>& nodes, std::optional<Index> of_face) {
        TriangleMarks& marks = e == lit() ? own : others;
        const int first = static_cast<int>(marks.corners.size());
        marks.triangles.push_back({first, first + 1, first + 2});
        marks.pick.ids.push_back(e);
        for (const Index n : nodes) {
            marks.corners.push_back(position<3>(apart(e, drawn().place(n))));
            if (!on_nodes.empty()) marks.values.push_back(on_nodes[static_cast<std::size_t>(n)]);
            if (!on_elements.empty()) marks.values.push_back(on_elements[static_cast<std::size_t>(e)]);
            if (!on_faces.empty() && of_face) marks.values.push_back(on_faces[static_cast<std::size_t>(*of_face)]);
        }
    };
    LineMarks edges{.ends = {}, .ink = Ink::edge, .width = 4};
    for (Index e = 0; e < solid.element_count(); ++e) {
        if (solid.dim() == 2) add(e, {solid.node(e, 0), solid.node(e, 1), solid.node(e, 2)}, std::nullopt);
        for (int k = 0; k < corners(); ++k) {
            const std::vector<Index> nodes = face_nodes(e, k);
            if (solid.dim() == 3) {
                add(e, nodes, face(e, k));
            } else if (!on_faces.empty()) {
                for (const Index n : nodes) edges.ends.push_back(position<3>(apart(e, drawn().place(n))));
                edges.values.push_back(on_faces[static_cast<std::size_t>(face(e, k))]);
            }
        }
    }
    scene.triangles.push_back(std::move(own));
    scene.triangles.push_back(std::move(others));
    if (!edges.ends.empty()) scene.lines.push_back(std::move(edges));
}

Vec<3> FvmLesson::middle_of_face(Index element, int opposite) const {
    Vec<3> sum = Vec<3>::Zero();
    const std::vector<Index> nodes = face_nodes(element, opposite);
    for (const Index n : nodes) sum += apart(element, drawn().place(n));
    return sum / static_cast<Real>(nodes.size());
}

// f_A on the faces of the lit element, or of all.
void FvmLesson::draw_face_forces(Scene& scene) const {
    const Real scale = arrow_scale(), least = least_arrow * solid_mesh::size_at_rest(*solid_);
    ArrowMarks others{.from = {}, .to = {}, .ink = Ink::rest, .width = 1.5f},
        own{.from = {}, .to = {}, .ink = Ink::force, .width = 3};
    for (Index e = 0; e < solid_->element_count(); ++e) {
        if (e != lit() && !all_faces) continue;
        for (int k = 0; k < corners(); ++k) {
            const VecX f = face_force_.col(face(e, k));
            const Vec<3> from = middle_of_face(e, k), to = from + scale * as_space(f);
            if ((to - from).norm() < least) continue;
            ArrowMarks& arrows = e == lit() ? own : others;
            arrows.from.push_back(position<3>(from)), arrows.to.push_back(position<3>(to));
            if (e != lit() || !scene.show_labels) continue;
            LabelMark label{.at = position<3>(to), .text = format_quantity(f.norm(), "N", 3), .ink = Ink::force};
            label.away_from = position<3>(from);
            scene.labels.push_back(std::move(label));
        }
    }
    scene.arrows.push_back(std::move(others));
    scene.arrows.push_back(std::move(own));
}

// On the corners of the lit element: what its faces give each of them, over the force of finite elements; and the sums of all
// elements on every node.
void FvmLesson::draw_nodal_forces(Scene& scene) const {
    const Real scale = arrow_scale(), least = least_arrow * solid_mesh::size_at_rest(*solid_);
    ArrowMarks sums{.from = {}, .to = {}, .ink = Ink::text, .width = 1.5f},
        fem{.from = {}, .to = {}, .ink = Ink::velocity, .width = 8},
        shared{.from = {}, .to = {}, .ink = Ink::accent, .width = 2.5f};
    const auto add = [&](ArrowMarks& arrows, const Vec<3>& from, const VecX& f) {
        const Vec<3> to = from + scale * as_space(f);
        if ((to - from).norm() < least) return;
        arrows.from.push_back(position<3>(from)), arrows.to.push_back(position<3>(to));
    };
    if (all_faces)
        for (Index n = 0; n < solid_->node_count(); ++n) add(sums, drawn().place(n), force_.col(n));
    const Index e = lit();
    const MatX of_elements = -solid_->volumes()[e] * taken(stress_, e) * solid_->slopes(e);
    for (int a = 0; a < corners(); ++a) {
        VecX f = VecX::Zero(solid_->dim());
        for (int k = 0; k < corners(); ++k)
            if (k != a) f -= face_force_.col(face(e, k)) / solid_->dim();
        const Vec<3> from = apart(e, drawn().place(solid_->node(e, a)));
        add(fem, from, of_elements.col(a));
        add(shared, from, f);
    }
    for (ArrowMarks* arrows : {&sums, &fem, &shared}) scene.arrows.push_back(std::move(*arrows));
}

void FvmLesson::write_notes(Scene& scene) const {
    if (scene.awaits("face_force")) return;
    const Index e = lit();
    Vec<3> sum = Vec<3>::Zero();
    for (int k = 0; k < corners(); ++k) sum += as_space(face_force_.col(face(e, k)));
    const bool cancels = sum.norm() <= 1e-12 * largest_face_force() + 100 * face_rounding();
    scene.notes.push_back(fmt::format("element {}: forces on its {} faces, {}; at its corners 1/{} of each face they belong to",
                                      e, corners(), cancels ? "which cancel" : "which do not cancel", solid_->dim()));
    scene.notes.push_back("broad arrows: the forces of finite elements on the same corners");
}

void FvmLesson::draw(Scene& scene) const {
    const Real L = body.length, h = body.height;
    if (held())
        scene.frame(position(-0.14 * L, -0.26 * L, 0), position(1.14 * L, h + 0.1 * L, in_space() ? Real{body.width} : Real{0}));
    else
        scene.frame(position(L / 2 - 0.62 * std::hypot(L, h), h / 2 - 0.6 * std::hypot(L, h)),
                    position(L / 2 + 0.62 * std::hypot(L, h), h / 2 + 0.6 * std::hypot(L, h)));
    solid_mesh::draw_rest(scene, *solid_);
    draw_elements(scene);
    if (held()) solid_mesh::draw_supports(scene, drawn());
    solid_mesh::draw_nodes(scene, drawn(), 2.5f);
    LineMarks outline{.ends = {}, .ink = Ink::accent, .width = 3};
    for (int a = 0; a < corners(); ++a)
        for (int b = a + 1; b < corners(); ++b)
            for (const int c : {a, b}) outline.ends.push_back(position<3>(apart(lit(), drawn().place(solid_->node(lit(), c)))));
    scene.lines.push_back(std::move(outline));
    if (scene.show_arrows) {
        if (held()) solid_mesh::draw_load(scene, drawn(), load_force());
        if (!scene.awaits("face_force")) draw_face_forces(scene), draw_nodal_forces(scene);
        if (pulled()) {
            const Vec<3> from = drawn().place(pull_->index);
            scene.arrow(position<3>(from), position<3>(pull_->to), Ink::force,
                        format_quantity(pull_stiffness * (pull_->to - from).norm(), "N", 3));
        }
    }
    write_notes(scene);
}

}  // namespace pliant::fvm
