// The picture: the net, and of a static test the plates with the solid beside it; of a chain that swings the shape of its mode.
#include "kits/springs/net_picture.h"
#include "mass_spring.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {
namespace {

std::string mass_text(Real mass) { return mass < 1 ? format_quantity(1000 * mass, "g", 3) : format_quantity(mass, "kg", 3); }

Real frame_side(const MassSpringLesson& l) {
    const Vec<3> edges = l.block_->lengths();
    if (l.setting == Setting::hang) return std::max(0.6 * std::max(edges[0], edges[2]), 0.2 * edges[1]);
    return 0.55 * edges.norm();
}

// The same corners from step to step: room for the fall, the bounce and the turning block.
void set_frame(const MassSpringLesson& l, Scene& picture) {
    const Vec<3> edges = l.block_->lengths();
    if (l.tested()) return l.set_test_frame(picture);
    const Real reach = 0.5 * edges.norm();
    const Real room = l.setting == Setting::spin ? reach - 0.5 * edges[1] : 0.1 * edges[1];
    const Real bottom = l.falls() ? Real{0} : std::min(Real{0}, -room);
    const Real top = !l.falls() ? edges[1] + std::max(room, Real{0})
                                : edges[1] + l.drop_height + (l.setting == Setting::drop ? 0.1 * edges[0] : 0);
    // A block that turns stays within a cylinder, whose outline is that of a narrower box.
    const Real side = (l.setting == Setting::drop || l.setting == Setting::spin ? 0.8 : 1.0) * frame_side(l);
    picture.frame(position(-side, bottom, -side), position(side, top, side));
}

void draw_ground(const MassSpringLesson& l, Scene& picture) {
    if (!l.grounded()) return;
    // A grid of squares as large as the cells of a block of five, out to where the block may roll.
    const Real square = l.size / 5, reach = std::ceil(1.1 * l.block_->lengths().norm() / square) * square;
    LineMarks grid{.ends = {}, .ink = Ink::ground, .width = 1};
    for (Real at = -reach; at <= reach + square / 2; at += square) {
        grid.ends.insert(grid.ends.end(), {position(at, 0, -reach), position(at, 0, reach)});
        grid.ends.insert(grid.ends.end(), {position(-reach, 0, at), position(reach, 0, at)});
    }
    if (l.dimension() == 2) grid.ends = {position(-reach, 0, 0), position(reach, 0, 0)}, grid.width = 2;
    picture.lines.push_back(std::move(grid));
}

void draw_arrows(const MassSpringLesson& l, Scene& picture) {
    const Vec<3> edges = l.block_->lengths();
    if (picture.show_arrows && l.weight_acceleration() > 0) {
        const Real x = -std::max(frame_side(l) + 0.3 * edges.norm(), 0.76 * edges.norm()), top = 0.8 * (edges[1] + l.drop_height),
                   length = 0.4 * edges[1];
        picture.arrow(position(x, top, 0), position(x, top - length, 0), Ink::force,
                      "g = " + format_quantity(l.gravity, "m/s²", 3));
    }
    springs::draw_pull(picture, l.load_.pull, l.pull_stiffness, l.position_);
}

void write_notes(const MassSpringLesson& l, Scene& picture) {
    const auto& cells = l.block_->lattice().nodes().cells();
    picture.notes.push_back(fmt::format("{} × {} × {} cells: {} nodes of {}, {} springs", cells[0], cells[1], cells[2],
                                        l.position_.cols(), mass_text(l.block_->mass()[0]), l.block_->springs().size()));
    if (l.implicit()) {
        picture.notes.push_back(fmt::format("Δt = {}, ω Δt = {}: implicit, no limit", format_quantity(l.dt, "s", 3),
                                            format_quantity(l.rates().omega * l.dt, "", 3)));
    } else if (const std::string too_large = l.too_large_a_step(); too_large.empty()) {
        picture.notes.push_back(fmt::format("Δt = {} ≤ {}, the stability limit", format_quantity(l.dt, "s", 3),
                                            format_quantity(l.stable_time_step(), "s", 3)));
    } else {
        picture.notes.push_back(l.stable_time_step() == 0
                                    ? fmt::format("Δt = {}: unstable at every Δt", format_quantity(l.dt, "s", 3))
                                    : fmt::format("Δt = {} > {}, the stability limit", format_quantity(l.dt, "s", 3),
                                                  format_quantity(l.stable_time_step(), "s", 3)));
    }
}

}  // namespace

void MassSpringLesson::draw(Scene& picture) const {
    set_frame(*this, picture);
    draw_ground(*this, picture);
    const Field* shown = find_field(picture.colour_by.field);
    if (shown && shown->on == On::edge) {
        springs::draw_surface(picture, *this, position_, block_->surface(), 0.45f);
        springs::draw_springs(picture, *this, block_->springs(), position_, block_->families());
    } else {
        springs::draw_surface(picture, *this, position_, block_->surface());
        springs::draw_pairs(picture, position_, block_->surface_edges(), 1.5f);
    }
    springs::draw_nodes(picture, *this, block_->inertia(), position_, 4, 6);
    if (setting == Setting::swing) draw_mode(picture);
    if (tested()) {
        draw_test(picture);
        write_static_notes(picture);
        return;
    }
    draw_arrows(*this, picture);
    write_notes(*this, picture);
}

namespace {

// From the middle of the net to that of the solid beside it, m.
Real continuum_offset(const MassSpringLesson& l) {
    const Vec<3> edges = l.block_->lengths();
    const Real lean = l.block_test() == BlockTest::shear ? l.test_amount() + 0.5 * edges[1] : 0;
    return 1.3 * edges[0] + 0.3 * edges[1] + lean;
}

void draw_plates(const MassSpringLesson& l, Scene& picture) {
    PointMarks plates{.at = {}, .ink = Ink::fixed, .radius = 5};
    for (const bool last : {true, false})
        for (const Index n : l.block_->layer(1, last)) plates.at.push_back(position<3>(l.position_.col(n)));
    picture.points.push_back(std::move(plates));
}

// Its cells are those of the net, without the shift of every other row of triangles.
void draw_continuum(const MassSpringLesson& l, Scene& picture) {
    if (!l.test_done_ || !l.tests_.continuum()) return;
    const NodeLattice<3>& nodes = l.block_->lattice().nodes();
    const Vec<3> half = 0.5 * l.block_->lengths();
    Points<3> x = nodes.points() + l.test_amount() * l.tests_.continuum()->displacement;
    x.colwise() += Vec<3>(continuum_offset(l) - half[0], 0, -half[2]);
    LineMarks edges{.ends = {}, .ink = Ink::rest, .width = 2};
    for (const auto& [i, j] : nodes.structural()) {
        const auto a = nodes.position(i), b = nodes.position(j);
        bool outside = l.block_->dimension() == 2;
        for (int axis = 0; axis < 3; ++axis)
            outside = outside || (a[axis] == b[axis] && (a[axis] == 0 || a[axis] == nodes.cells()[axis]));
        if (!outside) continue;
        edges.ends.push_back(position<3>(x.col(i)));
        edges.ends.push_back(position<3>(x.col(j)));
    }
    picture.lines.push_back(std::move(edges));
    if (!picture.show_labels) return;
    const Real below = -0.08 * l.block_->lengths()[1] - (l.block_test() == BlockTest::stretch ? 0.5 * l.test_amount() : 0);
    picture.label(position(0, below, half[2]), "springs", Ink::text, 0, 18);
    picture.label(position(continuum_offset(l), below, half[2]),
                  fmt::format("solid, ν* = {}", format_quantity(l.target_poisson, "", 3)), Ink::text, 0, 18);
}

}  // namespace

void MassSpringLesson::set_test_frame(Scene& picture) const {
    const Vec<3> edges = block_->lengths();
    const Real grown = (block_test() == BlockTest::stretch ? 0.3 : 0.15) * edges[1] +
                       (block_test() == BlockTest::stretch ? 0.5 * test_amount() : 0);
    const Real side = std::max(0.6 * edges[0], 0.2 * edges[1]) + (block_test() == BlockTest::shear ? 0.25 * edges[1] : 0),
               right = tests_.continuum() ? continuum_offset(*this) : 0;
    // Below, there is room for the names and the matrix.
    picture.frame(position(-side, -grown - 0.25 * edges[1], -0.5 * edges[2]),
                  position(right + side, edges[1] + grown, 0.5 * edges[2]));
}

void MassSpringLesson::draw_test(Scene& picture) const {
    draw_plates(*this, picture);
    draw_continuum(*this, picture);
    if (!test_done_ || !picture.show_arrows) return;
    const Real length = 0.25 * block_->lengths()[1];
    const bool bent = bends(), test_shears = block_test() == BlockTest::shear;
    const std::string load = fmt::format("{} = {}", bent ? "M" : "F",
                                         format_quantity(tests_.response().stiffness * test_amount(), bent ? "N m" : "N", 3));
    for (const bool last : {true, false}) {
        Vec<3> middle = Vec<3>::Zero();
        const std::vector<Index> plate = block_->layer(1, last);
        for (const Index n : plate) middle += position_.col(n) / Real(plate.size());
        if (bent) {
            if (last) picture.label(position<3>(middle), load, Ink::force, 0, -24);
            continue;
        }
        // Beside the plate that it moves sideways.
        if (test_shears) middle[0] = last ? position_.row(0).maxCoeff() : position_.row(0).minCoeff();
        const Vec<3> along = (last ? 1 : -1) * (block_test() == BlockTest::stretch ? Vec<3>::UnitY() : Vec<3>::UnitX());
        picture.arrow(position<3>(middle), position<3>(middle + length * along), Ink::force, last ? load : "");
    }
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
        const LatticeConstants endless = endless_lattice();
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

std::optional<UnstructuredGrid> MassSpringLesson::unstructured_grid() const {
    return springs::grid_of_springs(block_->springs(), position_);
}

}  // namespace pliant::mass_spring
