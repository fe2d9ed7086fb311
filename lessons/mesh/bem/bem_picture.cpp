// The figure: the body as it deforms, coloured inside; what pulls and what holds; the source and what it does; handles and notes.
#include "bem.h"

#include "kits/linear_body/linear_body_picture.h"

#include <pliant/lesson/unstructured_grid.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::bem {
namespace {

std::string number(Real value, std::string_view unit) { return format_quantity(value, unit, 3); }

constexpr int pieces = 4;  // straight pieces of an element

}  // namespace

Real BemLesson::magnification() const {
    return tally_[solved] == 0 ? 1 : linear_body::magnification_for(2.5 * largest_displacement() / size());
}

BemLesson::View BemLesson::view() const {
    View v{body_->nodes.rowwise().minCoeff(), body_->nodes.rowwise().maxCoeff()};
    for (std::size_t k = 0; is(Setting::hole) && k + 1 < body_->inside().particles.size(); ++k)
        v.lower = v.lower.cwiseMin(body_->inside().particles[k]), v.upper = v.upper.cwiseMax(body_->inside().particles[k]);
    if (is(Setting::hole) && !inside) v.lower *= 4, v.upper *= 4;
    return v;
}

void BemLesson::draw(Scene& scene) const {
    if (in_space()) {
        draw_wall(scene);
    } else {
        draw_inside(scene);
        draw_outline(scene);
        draw_handles(scene);
    }
    draw_loads(scene);
    draw_source(scene);
    draw_matrices(scene);
    write_notes(scene);
    const View v = view();
    const Vec<3> extent = v.upper - v.lower;
    const Real side = extent.maxCoeff();
    const Vec<3> low = v.lower - 0.16 * side * Vec<3>(1, 1, in_space() ? 1 : 0);
    const Vec<3> high = v.upper + Vec<3>(in_space()         ? 0.6 * side
                                         : shows_matrices() ? matrix_room() * side
                                                            : 0.16 * side,
                                         0.16 * side, in_space() ? 0.16 * side : 0);
    scene.frame(position<3>(low), position<3>(high));
}

Vec<3> BemLesson::drawn(const OnBoundary& at) const {
    return tally_[solved] == 0 ? body_->place(at) : Vec<3>(body_->place(at) + magnification() * body_->displacement(at));
}

void BemLesson::draw_inside(Scene& scene) const {
    const InsideMesh& mesh = body_->inside();
    const bool found = tally_[found_inside] != 0;
    const std::vector<float> values = found ? scene.values(*this, On::particle) : std::vector<float>{};
    TriangleMarks marks{.corners = {}, .triangles = mesh.triangles, .ink = Ink::body, .opacity = values.empty() ? 0.25f : 1.0f};
    for (const InsideMesh::Corner& c : mesh.corners) {
        const Vec<3> X = mesh.particles[static_cast<std::size_t>(c.particle)];
        marks.corners.push_back(position<3>(c.edge.element >= 0 ? drawn(c.edge)
                                            : found ? Vec<3>(X + magnification() * inside_displacement_.col(c.particle))
                                                    : X));
        if (!values.empty()) marks.values.push_back(values[static_cast<std::size_t>(c.particle)]);
    }
    for (const auto& t : mesh.triangles) marks.pick.ids.push_back(mesh.corners[static_cast<std::size_t>(t[0])].particle);
    marks.pick.pickable = true, marks.pick.on = On::particle;
    scene.triangles.push_back(std::move(marks));
}

void BemLesson::draw_outline(Scene& scene) const {
    const std::vector<float> of_elements = scene.values(*this, On::element);
    LineMarks rest{.ends = {}, .ink = Ink::rest, .width = 1.5f, .dashed = true},
        now{.ends = {}, .ink = Ink::edge, .width = of_elements.empty() ? 2.5f : 6.0f},
        support{.ends = {}, .ink = Ink::fixed, .width = 7};
    for (Index k = 0; k < body_->element_count(); ++k)
        for (int p = 0; p < pieces; ++p) {
            const OnBoundary from{k, -1 + 2.0 * p / pieces}, to{k, -1 + 2.0 * (p + 1) / pieces};
            rest.ends.push_back(position<3>(body_->place(from))), rest.ends.push_back(position<3>(body_->place(to)));
            for (LineMarks* marks : {&now, held(k) ? &support : nullptr})
                if (marks) marks->ends.push_back(position<3>(drawn(from))), marks->ends.push_back(position<3>(drawn(to)));
            if (!of_elements.empty()) now.values.push_back(of_elements[static_cast<std::size_t>(k)]);
            now.pick.ids.push_back(k);
        }
    now.pick.pickable = true, now.pick.on = On::element;
    if (tally_[solved] != 0) scene.lines.push_back(std::move(rest));
    scene.lines.push_back(std::move(support));
    scene.lines.push_back(std::move(now));
    const std::vector<float> of_nodes = scene.values(*this, On::node);
    PointMarks at_nodes{.at = {},
                        .values = of_nodes,
                        .ink = Ink::edge,
                        .radius = of_nodes.empty() ? 2.5f : 5.0f,
                        .pick = {true, On::node, 0, {}}};
    for (Index n = 0; n < body_->node_count(); ++n)
        at_nodes.at.push_back(position<3>(body_->nodes.col(n) + magnification() * displacement_.col(n)));
    scene.points.push_back(std::move(at_nodes));
}

// The wall of a cavity, seen from inside the rock.
void BemLesson::draw_wall(Scene& scene) const {
    const std::vector<float> of_nodes = scene.values(*this, On::node), of_elements = scene.values(*this, On::element),
                             of_particles = scene.values(*this, On::particle);
    TriangleMarks wall{.corners = {}, .triangles = {}, .ink = Ink::body, .edges = true, .pick = {true, On::element, 0, {}}};
    for (Index k = 0; k < body_->element_count(); ++k) {
        const int first = static_cast<int>(wall.corners.size());
        // Turned over, so that it is seen from outside the cavity.
        wall.triangles.push_back({first, first + 2, first + 1});
        for (int a = 0; a < 3; ++a) {
            const Index n = body_->node_of(k, a);
            wall.corners.push_back(position<3>(body_->nodes.col(n) + magnification() * displacement_.col(n)));
            if (!of_nodes.empty()) wall.values.push_back(of_nodes[static_cast<std::size_t>(n)]);
            if (!of_elements.empty()) wall.values.push_back(of_elements[static_cast<std::size_t>(k)]);
        }
    }
    scene.triangles.push_back(std::move(wall));
    const auto& particles = body_->inside().particles;
    PointMarks along{.at = {}, .values = of_particles, .ink = Ink::accent, .radius = 4, .pick = {true, On::particle, 0, {}}};
    for (const Vec<3>& X : particles) along.at.push_back(position<3>(X));
    if (!body_->contains(point())) {
        along.at.pop_back();
        if (!along.values.empty()) along.values.pop_back();
    }
    scene.points.push_back(std::move(along));
}

// What is given, at the middles of the elements, and what the support answers.
void BemLesson::draw_loads(Scene& scene) const {
    const View v = view();
    const Real side = (v.upper - v.lower).maxCoeff();
    ArrowMarks given{.from = {}, .to = {}, .ink = Ink::force, .width = 2},
        found{.from = {}, .to = {}, .ink = Ink::fixed, .width = 2};
    const Points<3>& all = tally_[solved] != 0 ? traction_ : given_traction_;
    const Real largest = given_traction_.colwise().norm().maxCoeff(), strongest = all.colwise().norm().maxCoeff();
    const Index every = std::max<Index>(1, body_->element_count() / 96);
    for (Index k = 0; k < body_->element_count(); k += every) {
        const Index slot = body_->slot_of(k, body_->nodes_per_element() / 2);
        const bool answers = held(k);
        const Vec<3> t =
            all.col(slot) * (answers ? 0.12 * side / std::max(strongest, 1e-300) : 0.12 * side / std::max(largest, 1e-300));
        if (!(t.norm() > 0.01 * side)) continue;
        const Vec<3> X = in_space() ? Vec<3>(body_->middles.col(k)) : drawn({k, 0});
        const bool pushes = t.dot(body_->normals.col(k)) < 0;
        ArrowMarks& marks = answers ? found : given;
        marks.from.push_back(position<3>(pushes ? Vec<3>(X - t) : X)),
            marks.to.push_back(position<3>(pushes ? X : Vec<3>(X + t)));
    }
    scene.arrows.push_back(std::move(given));
    scene.arrows.push_back(std::move(found));
    if (is(Setting::hole) && remote_stress != 0) {
        const Real length = 0.1 * side * (remote_stress > 0 ? 1 : -1);
        ArrowMarks far{.from = {}, .to = {}, .ink = Ink::force, .width = 3};
        for (const Real x : {-0.35, 0.0, 0.35})
            for (const Real way : {-1.0, 1.0}) {
                const Real edge = way > 0 ? v.upper.y() : v.lower.y(), from = edge + way * 0.02 * side,
                           to = from + way * std::abs(length);
                (length > 0 ? far.from : far.to).push_back(position(x * side, from));
                (length > 0 ? far.to : far.from).push_back(position(x * side, to));
            }
        scene.arrows.push_back(std::move(far));
        if (scene.show_labels)
            scene.label(position(0, v.upper.y() + 0.12 * side), fmt::format("S = {}", number(remote_stress, "Pa")), Ink::force,
                        46, 0);
    }
}

// While rows are filled: the unit force, and how each element feels it. Before: the normals.
void BemLesson::draw_source(Scene& scene) const {
    const View v = view();
    const Real side = (v.upper - v.lower).maxCoeff();
    const bool by_kernel = kernel_displacement_.colwise().norm().maxCoeff() > 0;
    if (!by_kernel) {
        ArrowMarks out{.from = {}, .to = {}, .ink = Ink::accent, .width = 1.5f};
        for (Index k = 0; k < body_->element_count(); ++k) {
            if (normal_.col(k).norm() == 0) continue;
            out.from.push_back(position<3>(body_->middles.col(k))),
                out.to.push_back(position<3>(body_->middles.col(k) + 0.05 * side * normal_.col(k)));
        }
        scene.arrows.push_back(std::move(out));
        return;
    }
    if (tally_[solved] != 0 || tally_[done] != 0) return;
    const Vec<3> X = body_->nodes.col(static_cast<Index>(std::min(tally_[source], static_cast<Real>(body_->node_count() - 1))));
    scene.points.push_back({.at = {position<3>(X)}, .ink = Ink::force, .radius = 7});
    scene.arrow(position<3>(X), position<3>(X + Vec<3>(0.16 * side, 0, 0)), Ink::force, scene.show_labels ? "unit force" : "");
    for (const auto& [field, ink] :
         {std::pair{&kernel_displacement_, Ink::velocity}, std::pair{&kernel_traction_, Ink::accent}}) {
        // Near the source both grow without bound; the others are what is to be seen.
        std::vector<Real> sizes;
        for (Index k = 0; k < field->cols(); ++k) sizes.push_back(field->col(k).norm());
        std::ranges::sort(sizes);
        const Real typical = std::max(sizes[sizes.size() * 3 / 4], 1e-300);
        ArrowMarks marks{.from = {}, .to = {}, .ink = ink, .width = 2};
        for (Index k = 0; k < field->cols(); ++k) {
            Vec<3> arrow = 0.07 * side / typical * field->col(k);
            if (arrow.norm() > 0.14 * side) arrow *= 0.14 * side / arrow.norm();
            if (arrow.norm() < 0.005 * side) continue;
            marks.from.push_back(position<3>(body_->middles.col(k))),
                marks.to.push_back(position<3>(body_->middles.col(k) + arrow));
        }
        scene.arrows.push_back(std::move(marks));
    }
}

void BemLesson::draw_handles(Scene& scene) const {
    const auto handle = [&](const Vec<3>& at, Index which, Ink ink) {
        scene.points.push_back(
            {.at = {position<3>(at)}, .ink = ink, .radius = 6, .pick = {.pickable = true, .on = On::handle, .first = which}});
    };
    if (has_hole()) handle({hole_a, 0, 0}, a_handle, Ink::accent), handle({0, hole_b, 0}, b_handle, Ink::accent);
    if (is(Setting::outline))
        for (std::size_t k = 0; k < static_cast<std::size_t>(Index(corners)); ++k) {
            handle(in_three(outline[k].place()), corner_handle + static_cast<Index>(k), Ink::accent);
            if (scene.show_labels) scene.label(position<2>(outline[k].place()), fmt::format("{}", k + 1), Ink::text, -12, -10);
        }
    const View v = view();
    const bool in_view = ((point() - v.lower).array() >= -1e-9).all() && ((v.upper - point()).array() >= -1e-9).all();
    if (!in_view || !body_->contains(point())) return;
    handle(point(), point_handle, Ink::text);
    if (!scene.show_labels) return;
    const auto stress = point_stress(1, 1);
    scene.label(position<3>(point()),
                stress && !scene.awaits("inside_stress") ? fmt::format("P: σ_yy = {}", number(*stress, "Pa")) : "P", Ink::text, 0,
                -18);
}

// The boundary as lines or triangles over its nodes; of constant elements their nodes.
std::optional<UnstructuredGrid> BemLesson::unstructured_grid() const {
    const Points<3> now = body_->nodes + displacement_;
    const int count = body_->nodes_per_element();
    if (count == 1) return grid_of_points(now, {On::node, On::element});
    Eigen::MatrixXi nodes(count, body_->element_count());
    for (Index k = 0; k < nodes.cols(); ++k)
        for (int a = 0; a < count; ++a) {
            // The middle of a line follows its ends; triangles are turned to be seen from outside the cavity.
            const int from = a == 0 ? 0 : in_space() || count == 3 ? 3 - a : a;
            nodes(a, k) = static_cast<int>(body_->node_of(k, from));
        }
    return grid_of(now,
                   in_space()   ? CellKind::triangle
                   : count == 3 ? CellKind::line3
                                : CellKind::line,
                   std::move(nodes), {On::element});
}

void BemLesson::write_notes(Scene& scene) const {
    const Index n = body_->unknowns();
    scene.notes.push_back(fmt::format("{} elements, {} nodes: {} unknowns, {} entries in the matrix, none of them 0",
                                      body_->element_count(), body_->node_count(), n, n * n));
    if (tally_[done] == 0) {
        if (tally_[source] > 0)
            scene.notes.push_back(fmt::format("rows of {:g} of {} nodes are filled", tally_[source], body_->node_count()));
        if (tally_[source] > 0 && tally_[solved] == 0)
            scene.notes.push_back("arrows: how each element moves by the unit force (U), and what pulls across it (T)");
        return;
    }
    scene.notes.push_back(fmt::format("deformation drawn ×{}", format_quantity(magnification(), "")));
    if (const auto error = worst_error())
        scene.notes.push_back(fmt::format("largest error of the displacement: {} %", format_quantity(100 * *error, "", 2)));
    if (comparison_)
        scene.notes.push_back(fmt::format("finite elements as good: {:.0f} unknowns{}", comparison_->equal.unknowns,
                                          comparison_->beyond ? ", by their order" : ""));
}

}  // namespace pliant::bem
