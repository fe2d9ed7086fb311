// The figure: the unit cube under F, its edges as the columns of F, the forces on its faces, and the formulas with their numbers.
#include "energy_density.h"

#include <pliant/continuum/deformation.h>
#include <pliant/lesson/unstructured_grid.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::energies {
namespace {

constexpr std::array<std::string_view, 3> below{"₁", "₂", "₃"};

Position at(const Vec<3>& x) { return position<3>(x); }

// Two triangles a side, seen from outside; corners are numbered x fastest.
constexpr std::array<std::array<int, 3>, 12> sides{{{0, 2, 1},
                                                    {1, 2, 3},
                                                    {4, 5, 6},
                                                    {5, 7, 6},
                                                    {0, 1, 4},
                                                    {1, 5, 4},
                                                    {2, 6, 3},
                                                    {3, 6, 7},
                                                    {0, 4, 2},
                                                    {2, 4, 6},
                                                    {1, 3, 5},
                                                    {3, 7, 5}}};
constexpr std::array<std::array<int, 2>, 12> edges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

}  // namespace

void EnergyDensityLesson::draw(Scene& scene) const {
    draw_cube(scene);
    draw_tractions(scene);
    if (way().stretches())
        draw_measures(scene);
    else
        draw_principal(scene);
    if (block_) draw_block(scene);
    write_notes(scene);
    // The same for all amounts that the slider gives, so that the picture stays in place.
    Vec<3> lower(-0.35, -0.25, -0.15), upper(2.35, 1.3, 1.15);
    if (is(Path::volumetric)) upper = Vec<3>(2.3, 2.2, 2.1);
    if (block_) lower[1] = -1.4;
    if (!way().stretches()) lower = Vec<3>(-0.9, -0.4, -0.2);
    for (Index n = 0; n < 8; ++n) {
        const Vec<3> x = F_ * cube_corner(n);
        lower = lower.cwiseMin(x), upper = upper.cwiseMax(x);
    }
    scene.frame(at(lower), at(upper));
}

void EnergyDensityLesson::draw_cube(Scene& scene) const {
    scene.box(at(Vec<3>::Zero()), at(Vec<3>::Ones()), Ink::rest, 2, true);
    const std::vector<float> on_node = scene.values(*this, On::node), on_element = scene.values(*this, On::element);
    TriangleMarks body{.corners = {}, .triangles = {}, .ink = J_[0] > 0 ? Ink::body : Ink::accent, .opacity = 0.6f};
    LineMarks outline{.ends = {}, .ink = Ink::edge, .width = 2};
    PointMarks handles{.at = {}, .ink = Ink::edge, .radius = 4, .pick = {.pickable = true, .on = On::node}};
    for (Index n = 0; n < 8; ++n) {
        const Position p = at(F_ * cube_corner(n));
        body.corners.push_back(p);
        handles.at.push_back(p);
    }
    if (!on_node.empty()) body.values.assign(on_node.begin(), on_node.begin() + corners);
    if (!on_element.empty()) body.values.assign(8, on_element[0]);
    for (const auto& side : sides) {
        body.triangles.push_back(side);
        body.pick.ids.push_back(0);
    }
    body.pick.pickable = true;
    body.pick.on = On::element;
    for (const auto& edge : edges)
        for (const int end : edge) outline.ends.push_back(body.corners[static_cast<std::size_t>(end)]);
    scene.triangles.push_back(std::move(body));
    scene.lines.push_back(std::move(outline));
    scene.points.push_back(std::move(handles));
}

// Below the cube, about its own middle.
void EnergyDensityLesson::draw_block(Scene& scene) const {
    const SimplexMesh<3>& mesh = block_->mesh();
    const std::vector<float> on_node = scene.values(*this, On::node);
    TriangleMarks surface{.corners = {}, .triangles = {}, .ink = Ink::body, .edges = true};
    const Points<3> u = displacement_.rightCols(mesh.node_count());
    const Real narrower = Ends(ends) == Ends::sliding ? 0.5 * StretchedBlock::width_at_rest * (1 - block_->width(u)) : 0;
    const Vec<3> place(0, -1.3 + narrower, 0.25 + narrower);
    for (Index n = 0; n < mesh.node_count(); ++n) {
        surface.corners.push_back(at(place + mesh.points().col(n) + u.col(n)));
        if (!on_node.empty()) surface.values.push_back(on_node[static_cast<std::size_t>(corners + n)]);
    }
    for (Index f = 0; f < mesh.facet_count(); ++f)
        surface.triangles.push_back({mesh.facets()(0, f), mesh.facets()(1, f), mesh.facets()(2, f)});
    scene.triangles.push_back(std::move(surface));
    const Vec<3> low(0, -1.3, 0.25);
    scene.box(at(low), at(low + Vec<3>(1, StretchedBlock::width_at_rest, StretchedBlock::width_at_rest)), Ink::rest, 1.5f, true);
}

// The force on each of the three faces that are seen, per area at rest: the columns of P.
void EnergyDensityLesson::draw_tractions(Scene& scene) const {
    const Real largest = P_.colwise().norm().maxCoeff();
    if (largest <= 1e-9 * material().mu) return;
    // A stress as large as Young's modulus is drawn as long as the cube.
    const Real scale = std::min<Real>(1 / youngs_modulus, 0.7 / largest);
    for (int j = 0; j < 3; ++j) {
        const Vec<3> force = P_.col(j), middle = F_ * (0.5 * (Vec<3>::Ones() + Vec<3>::Unit(j)));
        if (force.norm() < 0.02 * largest) continue;
        // A push ends on the face, a pull starts there.
        const bool pushes = force.dot(F_.col(j)) < 0;
        const Vec<3> tip = middle + scale * force, tail = middle - scale * force;
        scene.arrow(at(pushes ? tail : middle), at(pushes ? middle : tip), Ink::force);
        LabelMark label{
            .at = at(pushes ? tail : tip),
            .text = fmt::format("P e{} = {}", below[static_cast<std::size_t>(j)], format_quantity(force.norm(), "Pa")),
            .ink = Ink::force};
        label.away_from = at(middle);
        scene.labels.push_back(std::move(label));
    }
}

// Stretch and width, at the front below and at the side.
void EnergyDensityLesson::draw_measures(Scene& scene) const {
    const Real s = F_(0, 0), beside = s < 0 ? Real{0.12} : Real{-0.12}, front = std::max<Real>(1, F_(2, 2)),
               low = std::min<Real>(0, F_(1, 1));
    scene.dimension_line(at({0, low - 0.12, front}), at({s, low - 0.12, front}), fmt::format("s = {}", format_quantity(s, "")), 0,
                         16);
    if (is(Path::uniaxial) && std::abs(F_(1, 1)) > 0.02)
        scene.dimension_line(at({beside, 0, F_(2, 2)}), at({beside, F_(1, 1), F_(2, 2)}),
                             fmt::format("a = {}", format_quantity(F_(1, 1), "", 3)), s < 0 ? 46 : -46, 0);
}

// The three directions at right angles that stay at right angles, as long as they have become.
void EnergyDensityLesson::draw_principal(Scene& scene) const {
    const auto [stretches, directions] = principal_stretches<3>(F_);
    const Mat<3> R = nearest_rotation<3>(F_);
    const Vec<3> centre = F_ * Vec<3>::Constant(0.5);
    for (int k = 0; k < 3; ++k) {
        const Vec<3> half = 0.5 * stretches[k] * (R * directions.col(k));
        scene.line(at(centre - half), at(centre + half), Ink::accent, 2.5f);
        LabelMark label{
            .at = at(centre + half), .text = fmt::format("s{}", below[static_cast<std::size_t>(k)]), .ink = Ink::accent};
        label.away_from = at(centre);
        scene.labels.push_back(std::move(label));
    }
}

void EnergyDensityLesson::write_notes(Scene& scene) const {
    scene.matrix("F", Mat<3>(F_));
    if (is(Energy::corotated)) scene.matrix("R", Mat<3>(rotation_));
    if (done_[0] != 0) scene.matrix("P", Mat<3>(P_), "Pa", Ink::force);

    const Lame m = material();
    const std::string mu = format_quantity(m.mu, "Pa"), lambda = format_quantity(m.lambda, "Pa"),
                      psi = format_quantity(psi_[0], "J/m³");
    const auto number = [](Real x) { return format_quantity(x, ""); };
    if (J_[0] <= 0) scene.notes.push_back(fmt::format("det F = {}: {}", number(J_[0]), J_[0] < 0 ? "turned inside out" : "flat"));
    if (!way().stretches()) {
        const Vec<3> stretches = principal_stretches<3>(F_).stretches;
        scene.notes.push_back(fmt::format("principal stretches s₁ = {}, s₂ = {}, s₃ = {}", number(stretches[0]),
                                          number(stretches[1]), number(stretches[2])));
    }
    if (done_[0] == 0) return;
    scene.notes.push_back(fmt::format("μ = {}, λ = {}", mu, lambda));
    if (is(Energy::neo_hookean)) {
        scene.notes.push_back(fmt::format("ψ = ½ μ (I₁ − 3) − μ ln J + ½ λ (ln J)²"));
        scene.notes.push_back(
            fmt::format("  = ½ μ ({} − 3) − μ ({}) + ½ λ ({})² = {}", number(I1_[0]), number(ln_J_[0]), number(ln_J_[0]), psi));
        return;
    }
    const std::string_view strain = is(Energy::linear) ? "ε" : is(Energy::stvk) ? "E" : "(S − I)";
    scene.notes.push_back(fmt::format("ψ = μ {0}:{0} + ½ λ tr{1}{0}{2}²", strain, is(Energy::corotated) ? "" : "(",
                                      is(Energy::corotated) ? "" : ")"));
    scene.notes.push_back(
        fmt::format("  = μ · {} + ½ λ · ({})² = {}", number(strain_.squaredNorm()), number(strain_.trace()), psi));
}

std::optional<UnstructuredGrid> EnergyDensityLesson::unstructured_grid() const {
    const SimplexMesh<3>& mesh = block_->mesh();
    const Vec<3> beside(0, -1.3, 0.25);
    UnstructuredGrid grid{.points = displacement_};
    for (Index n = 0; n < corners; ++n) grid.points.col(n) += cube_corner(n);
    for (Index n = 0; n < mesh.node_count(); ++n) grid.points.col(corners + n) += beside + mesh.points().col(n);
    Eigen::MatrixXi cube(8, 1);
    cube << 0, 1, 3, 2, 4, 5, 7, 6;  // round the bottom, then round the top
    Eigen::MatrixXi block = mesh.simplices();
    block.array() += corners;
    grid.cells = {{CellKind::hexahedron, std::move(cube)}, {CellKind::tetrahedron, std::move(block)}};
    return grid;
}

}  // namespace pliant::energies
