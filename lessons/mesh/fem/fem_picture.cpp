// The figure: the body at rest and deformed, supports and load, the element that is lit with its matrices, and the pattern of K.
#include "fem.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::fem {
namespace {

constexpr Index most_pattern_nodes = 150;

// A square of one block of K.
void add_block(TriangleMarks& marks, Real x, Real y, Real side) {
    const int first = static_cast<int>(marks.corners.size());
    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        marks.corners.push_back(position(x + dx * side, y + dy * side));
    marks.triangles.push_back({first, first + 1, first + 2});
    marks.triangles.push_back({first, first + 2, first + 3});
}

}  // namespace

Drawn FemLesson::drawn() const {
    const Real itself = moving() ? Real{1} : solid_mesh::magnification_for(*solid_, displacement_),
               larger = magnification > 0 ? Real(magnification) : itself;
    return {solid_.get(), &displacement_, larger};
}

void FemLesson::draw(Scene& scene) const {
    const Drawn now = drawn();
    set_frame(scene);
    if (!moving() || bent()) solid_mesh::draw_rest(scene, *solid_);
    solid_mesh::draw_body(scene, *this, now);
    if (is(Setting::twist) && turned == Turned::end) solid_mesh::draw_turned(scene, now);
    if (!moving() || bent()) solid_mesh::draw_supports(scene, now);
    solid_mesh::draw_nodes(scene, now);
    solid_mesh::draw_load(scene, now, force());
    if (solved_pull_)
        scene.arrow(position<3>(now.place(solved_pull_->index)),
                    position<3>(Vec<3>(now.place(solved_pull_->index) + solved_pull_->to - solved_pull_->from)), Ink::force,
                    "hand");
    const bool assembling = next_element_ > first_of_pass_ && next_element_ < solid_->element_count();
    solid_mesh::draw_element(scene, now, assembling ? first_of_pass_ : lit(), scene.show_labels);
    if (show_matrix && !moving() && solid_->node_count() <= most_pattern_nodes) draw_pattern(scene);
    if (show_numbers) write_matrices(scene);
    write_notes(scene);
}

void FemLesson::set_frame(Scene& scene) const {
    const Real L = body.length, h = body.height, w = body.width;
    if (is(Setting::spin)) return scene.frame(position(-0.2 * L, -0.75 * L + h / 2, 0), position(1.2 * L, 0.75 * L + h / 2, w));
    if (!is(Setting::drop)) {
        solid_mesh::frame_body(scene, *solid_, bent() ? 0.22 : 0.08);
        // Room for the matrices below.
        if (bent()) scene.lower[1] -= static_cast<float>(0.22 * solid_mesh::size_at_rest(*solid_));
        return;
    }
    const Real low = start_position_.row(0).minCoeff(), high = start_position_.row(0).maxCoeff(),
               top = start_position_.row(1).maxCoeff();
    const Real more = 0.25 * (high - low);
    TriangleMarks floor{.corners = {position(low - more, 0, -L), position(high + more, 0, -L), position(high + more, 0, L + w),
                                    position(low - more, 0, L + w)},
                        .triangles = {{0, 1, 2}, {0, 2, 3}},
                        .ink = Ink::ground,
                        .opacity = 0.6f};
    scene.triangles.push_back(std::move(floor));
    scene.frame(position(low - more, -0.05 * L, 0), position(high + more, top + 0.05 * L, w));
}

// Blocks of K that elements have written, those that are still empty, and those of the element that is lit; row 0 on top.
void FemLesson::draw_pattern(Scene& scene) const {
    const Index n = solid_->node_count();
    Vec<3> low = Vec<3>::Zero(), high = Vec<3>::Zero();
    low.head(solid_->dim()) = solid_->rest().rowwise().minCoeff();
    high.head(solid_->dim()) = solid_->rest().rowwise().maxCoeff();
    const Vec<3> size = high - low;
    const bool above = size[0] > 1.5 * size[1];
    const Real side = above ? 0.5 * size[0] : 0.7 * std::max(size[0], size[1]), cell = side / static_cast<Real>(n);
    const Real left = above ? low[0] + 0.25 * size[0] : high[0] + 0.45 * size[0];
    const Real top = above ? high[1] + 0.12 * size[0] + side : 0.5 * (low[1] + high[1] + side);
    TriangleMarks written{.corners = {}, .triangles = {}, .ink = Ink::rest, .opacity = 0.9f};
    TriangleMarks empty{.corners = {}, .triangles = {}, .ink = Ink::rest, .opacity = 0.3f};
    TriangleMarks present{.corners = {}, .triangles = {}, .ink = Ink::accent};
    const bool assembling = next_element_ > first_of_pass_ && next_element_ < solid_->element_count();
    const Index element = assembling ? first_of_pass_ : lit();
    std::vector<char> of_present(static_cast<std::size_t>(n));
    for (int a = 0; a < solid_->nodes_of_element(); ++a) of_present[static_cast<std::size_t>(solid_->node(element, a))] = 1;
    for (Index row = 0; row < n; ++row) {
        // 2 where an element that is assembled has written, 1 where others will.
        std::vector<char> kind(static_cast<std::size_t>(n));
        for (const auto& [e, a] : solid_->elements_about(row))
            for (int b = 0; b < solid_->nodes_of_element(); ++b) {
                char& k = kind[static_cast<std::size_t>(solid_->node(e, b))];
                k = std::max<char>(k, e < next_element_ ? 2 : 1);
            }
        for (Index column = 0; column < n; ++column) {
            const bool lit_here = of_present[static_cast<std::size_t>(row)] && of_present[static_cast<std::size_t>(column)];
            const char k = kind[static_cast<std::size_t>(column)];
            if (k == 0 && !lit_here) continue;
            add_block(lit_here ? present
                      : k == 2 ? written
                               : empty,
                      left + static_cast<Real>(column) * cell, top - static_cast<Real>(row + 1) * cell, cell);
        }
    }
    scene.triangles.push_back(std::move(empty)), scene.triangles.push_back(std::move(written));
    scene.triangles.push_back(std::move(present));
    scene.box(position(left, top - side), position(left + side, top), Ink::rest);
    scene.label(position(left + side, top), fmt::format("K, {} × {}", solid_->dim() * n, solid_->dim() * n), Ink::text, 0, -14);
    const Real margin = 0.04 * side;
    for (std::size_t k = 0; k < 2; ++k) {
        const std::array<Real, 2> least{left, top - side}, most{left + side, top};
        scene.lower[k] = std::min(scene.lower[k], static_cast<float>(least[k] - margin));
        scene.upper[k] = std::max(scene.upper[k], static_cast<float>(most[k] + margin));
    }
}

// Of the element that is lit.
void FemLesson::write_matrices(Scene& scene) const {
    const Index e = lit();
    scene.matrix(fmt::format("F of element {}", e), taken(deformation_, e));
    scene.matrix("P", taken(stress_, e), "Pa");
    if (moving()) return;
    if (solid_->dim() == 2 && order() == 1)
        scene.matrix("Kₑ", solid_->element_stiffness(e, displacement_), "N/m", Ink::accent);
    else
        scene.matrix("Kₑ, first corner", taken(block_, e), "N/m", Ink::accent);
}

void FemLesson::write_notes(Scene& scene) const {
    const Real larger = drawn().magnification;
    scene.notes.push_back(fmt::format("{} nodes, {} elements, {} unknowns{}", solid_->node_count(), solid_->element_count(),
                                      unknowns(),
                                      larger == 1 ? "" : fmt::format("; deformation × {}", format_quantity(larger, "", 2))));
    if (levels() > 1 && level_ > 0 && done_[0] == 0)
        scene.notes.push_back(fmt::format("load step {} of {}", static_cast<Index>(level_), levels()));
}

}  // namespace pliant::fem
