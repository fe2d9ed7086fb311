// The picture of the static test, and of a chain that swings.
#include "mass_spring.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant::mass_spring {

// From the middle of the net to that of the solid beside it, m.
Real MassSpringLesson::continuum_offset() const {
    const Vec<3> edges = block_->lengths();
    const Real lean = block_test() == BlockTest::shear ? test_amount() + 0.5 * edges[1] : 0;
    return 1.3 * edges[0] + 0.3 * edges[1] + lean;
}

void MassSpringLesson::set_test_frame(Scene& picture) const {
    const Vec<3> edges = block_->lengths();
    const Real grown = (block_test() == BlockTest::stretch ? 0.3 : 0.15) * edges[1] +
                       (block_test() == BlockTest::stretch ? 0.5 * test_amount() : 0);
    const Real side = std::max(0.6 * edges[0], 0.2 * edges[1]) + (block_test() == BlockTest::shear ? 0.25 * edges[1] : 0),
               right = tests_.continuum() ? continuum_offset() : 0;
    // Below, there is room for the names and the matrix.
    picture.frame(position(-side, -grown - 0.25 * edges[1], -0.5 * edges[2]),
                  position(right + side, edges[1] + grown, 0.5 * edges[2]));
}

void MassSpringLesson::draw_test(Scene& picture) const {
    draw_plates(picture);
    draw_continuum(picture);
    if (!test_done_ || !picture.show_arrows) return;
    const Real length = 0.25 * block_->lengths()[1];
    const bool bends = block_test() == BlockTest::bend, test_shears = block_test() == BlockTest::shear;
    const std::string load = fmt::format("{} = {}", bends ? "M" : "F",
                                         format_quantity(tests_.response().stiffness * test_amount(), bends ? "N m" : "N", 3));
    for (const bool last : {true, false}) {
        Vec<3> middle = Vec<3>::Zero();
        const std::vector<Index> plate = block_->layer(1, last);
        for (const Index n : plate) middle += position_.col(n) / Real(plate.size());
        if (bends) {
            if (last) picture.label(position<3>(middle), load, Ink::force, 0, -24);
            continue;
        }
        // Beside the plate that it moves sideways.
        if (test_shears) middle[0] = last ? position_.row(0).maxCoeff() : position_.row(0).minCoeff();
        const Vec<3> along = (last ? 1 : -1) * (block_test() == BlockTest::stretch ? Vec<3>::UnitY() : Vec<3>::UnitX());
        picture.arrow(position<3>(middle), position<3>(middle + length * along), Ink::force, last ? load : "");
    }
}

void MassSpringLesson::draw_plates(Scene& picture) const {
    PointMarks held{.at = {}, .ink = Ink::fixed, .radius = 5};
    for (const bool last : {true, false})
        for (const Index n : block_->layer(1, last)) held.at.push_back(position<3>(position_.col(n)));
    picture.points.push_back(std::move(held));
}

// Its cells are those of the net, without the shift of every other row of triangles.
void MassSpringLesson::draw_continuum(Scene& picture) const {
    if (!test_done_ || !tests_.continuum()) return;
    const NodeLattice<3>& nodes = block_->lattice().nodes();
    const Vec<3> half = 0.5 * block_->lengths();
    Points<3> x = nodes.points() + test_amount() * tests_.continuum()->displacement;
    x.colwise() += Vec<3>(continuum_offset() - half[0], 0, -half[2]);
    LineMarks edges{.ends = {}, .ink = Ink::rest, .width = 2};
    for (const auto& [i, j] : nodes.structural()) {
        const auto a = nodes.position(i), b = nodes.position(j);
        bool outside = block_->dimension() == 2;
        for (int axis = 0; axis < 3; ++axis)
            outside = outside || (a[axis] == b[axis] && (a[axis] == 0 || a[axis] == nodes.cells()[axis]));
        if (!outside) continue;
        edges.ends.push_back(position<3>(x.col(i)));
        edges.ends.push_back(position<3>(x.col(j)));
    }
    picture.lines.push_back(std::move(edges));
    if (!picture.show_labels) return;
    const Real below = -0.08 * block_->lengths()[1] - (block_test() == BlockTest::stretch ? 0.5 * test_amount() : 0);
    picture.label(position(0, below, half[2]), "springs", Ink::text, 0, 18);
    picture.label(position(continuum_offset(), below, half[2]),
                  fmt::format("solid, ν* = {}", format_quantity(target_poisson, "", 3)), Ink::text, 0, 18);
}

// The displacement of every mass drawn sideways, so that the shape of the mode can be seen.
void MassSpringLesson::draw_mode(Scene& picture) const {
    const Real scale = 0.25 * block_->lengths()[1] / (swing_amplitude * edge()), x0 = 0.12 * block_->lengths()[1];
    LineMarks curve{.ends = {}, .ink = Ink::accent, .width = 2.5f}, guides{.ends = {}, .ink = Ink::rest, .width = 1};
    const auto at = [&](Index n) {
        const Real moved = position_(1, n) - block_->rest()(1, n);
        return position(x0 + 0.25 * block_->lengths()[1] + scale * moved, block_->rest()(1, n));
    };
    for (Index n = 0; n < position_.cols(); ++n) {
        guides.ends.insert(guides.ends.end(), {position(x0 + 0.25 * block_->lengths()[1], block_->rest()(1, n)), at(n)});
        if (n > 0) curve.ends.insert(curve.ends.end(), {at(n - 1), at(n)});
    }
    picture.lines.push_back(std::move(guides));
    picture.lines.push_back(std::move(curve));
    if (picture.show_labels)
        picture.label(position(x0 + 0.25 * block_->lengths()[1], -0.02 * block_->lengths()[1]), "displacement", Ink::accent, 0,
                      16);
}

void MassSpringLesson::write_static_notes(Scene& picture) const {
    if (!test_done_) return;
    if (block_test() == BlockTest::stretch && block_->dimension() > 1) {
        const LatticeConstants endless = lattice_constants(lattice(), stiffnesses(), edge());
        const Real measured = tests_.modulus_in_pascal(tests_.response().youngs_modulus, block_->lattice()),
                   exact = tests_.modulus_in_pascal(endless.youngs_modulus(), block_->lattice());
        picture.notes.push_back(
            fmt::format("E = {}; endless lattice: {}", format_quantity(measured, "Pa", 4), format_quantity(exact, "Pa", 4)));
        picture.notes.push_back(
            fmt::format("ν = {}; endless lattice: {}; wished: {}", format_quantity(tests_.response().poisson_ratio, "", 3),
                        format_quantity(endless.poisson_ratio(), "", 3), format_quantity(target_poisson, "", 3)));
    }
    if (tests_.continuum())
        picture.notes.push_back(fmt::format("K/K* = {}: net over solid; motions drawn larger",
                                            format_quantity(tests_.response().stiffness / tests_.continuum()->stiffness, "", 4)));
    if (block_->dimension() == 1) return;
    Mat<3> rounded = (1000 * tests_.coupling()).array().round() / 1000;
    picture.matrix("rows: stretch, shear, bend\n∂ ln K/∂ ln (kₛ, k_d, k_b)", rounded);
}

}  // namespace pliant::mass_spring
