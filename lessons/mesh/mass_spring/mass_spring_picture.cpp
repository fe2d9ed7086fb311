#include "mass_spring.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {
namespace {

std::string mass_text(Real mass) { return mass < 1 ? format_quantity(1000 * mass, "g", 3) : format_quantity(mass, "kg", 3); }

}  // namespace

void MassSpringLesson::draw(Scene& picture) const {
    set_frame(picture);
    draw_ground(picture);
    const Field* shown = find_field(picture.colour_by.field);
    if (shown && shown->on == On::edge) {
        draw_surface(picture, 0.45f);
        draw_springs(picture);
    } else {
        draw_surface(picture, 1);
        draw_cell_edges(picture);
    }
    draw_nodes(picture);
    if (setting == Setting::swing) draw_mode(picture);
    if (tested()) {
        draw_test(picture);
        write_static_notes(picture);
        return;
    }
    draw_arrows(picture);
    write_notes(picture);
}

Real MassSpringLesson::frame_side() const {
    const Vec<3> edges = block_->lengths();
    if (setting == Setting::hang) return std::max(0.6 * std::max(edges[0], edges[2]), 0.2 * edges[1]);
    return 0.55 * edges.norm();
}

// The same corners from step to step: room for the fall, the bounce and the turning block.
void MassSpringLesson::set_frame(Scene& picture) const {
    const Vec<3> edges = block_->lengths();
    if (tested()) return set_test_frame(picture);
    const Real reach = 0.5 * edges.norm();
    const Real room = setting == Setting::spin ? reach - 0.5 * edges[1] : 0.1 * edges[1];
    const Real bottom = falls() ? Real{0} : std::min(Real{0}, -room);
    const Real top =
        !falls() ? edges[1] + std::max(room, Real{0}) : edges[1] + drop_height + (setting == Setting::drop ? 0.1 * edges[0] : 0);
    // A block that turns stays within a cylinder, whose outline is that of a narrower box.
    const Real side = (setting == Setting::drop || setting == Setting::spin ? 0.8 : 1.0) * frame_side();
    picture.frame(position(-side, bottom, -side), position(side, top, side));
}

void MassSpringLesson::draw_surface(Scene& picture, float opacity) const {
    TriangleMarks body{
        .corners = {}, .triangles = {}, .values = picture.values(*this, On::node), .ink = Ink::body, .opacity = opacity};
    for (Index n = 0; n < position_.cols(); ++n) body.corners.push_back(position<3>(position_.col(n)));
    for (const auto& [a, b, c] : block_->surface()) body.triangles.push_back({int(a), int(b), int(c)});
    picture.triangles.push_back(std::move(body));
}

// The edges of the cells on the surface.
void MassSpringLesson::draw_cell_edges(Scene& picture) const {
    LineMarks edges{.ends = {}, .ink = Ink::edge, .width = 1.5f};
    for (const auto& [i, j] : block_->surface_edges()) {
        edges.ends.push_back(position<3>(position_.col(i)));
        edges.ends.push_back(position<3>(position_.col(j)));
    }
    picture.lines.push_back(std::move(edges));
}

// Springs to the next node but one lie on the structural ones, and so are drawn below them.
void MassSpringLesson::draw_springs(Scene& picture) const {
    const std::vector<float> values = picture.values(*this, On::edge);
    const Springs& springs = block_->springs();
    constexpr std::array<float, spring_families> widths{3, 1.5f, 1};
    for (const SpringFamily family : {bending, shear, structural}) {
        LineMarks marks{.ends = {}, .ink = Ink::edge, .width = widths[family], .pick = {.pickable = true, .on = On::edge}};
        marks.pick.first = block_->first(family);
        for (Index s = block_->first(family); s < block_->last(family); ++s) {
            marks.ends.push_back(position<3>(position_.col(springs.i(s))));
            marks.ends.push_back(position<3>(position_.col(springs.j(s))));
        }
        if (!values.empty()) marks.values.assign(values.begin() + block_->first(family), values.begin() + block_->last(family));
        picture.lines.push_back(std::move(marks));
    }
}

void MassSpringLesson::draw_nodes(Scene& picture) const {
    PointMarks nodes{.at = {},
                     .values = picture.values(*this, On::node),
                     .ink = Ink::body,
                     .radius = 4,
                     .pick = {.pickable = true, .on = On::node}};
    PointMarks fixed{.at = {}, .ink = Ink::fixed, .radius = 6};
    for (Index n = 0; n < position_.cols(); ++n) {
        nodes.at.push_back(position<3>(position_.col(n)));
        if (block_->inertia().fixed(3 * n)) fixed.at.push_back(nodes.at.back());
    }
    picture.points.push_back(std::move(nodes));
    if (!fixed.at.empty()) picture.points.push_back(std::move(fixed));
}

void MassSpringLesson::draw_ground(Scene& picture) const {
    if (!grounded()) return;
    // A grid of squares as large as the cells of a block of five, out to where the block may roll.
    const Real square = size / 5, reach = std::ceil(1.1 * block_->lengths().norm() / square) * square;
    LineMarks grid{.ends = {}, .ink = Ink::ground, .width = 1};
    for (Real at = -reach; at <= reach + square / 2; at += square) {
        grid.ends.insert(grid.ends.end(), {position(at, 0, -reach), position(at, 0, reach)});
        grid.ends.insert(grid.ends.end(), {position(-reach, 0, at), position(reach, 0, at)});
    }
    if (dimension() == 2) grid.ends = {position(-reach, 0, 0), position(reach, 0, 0)}, grid.width = 2;
    picture.lines.push_back(std::move(grid));
}

void MassSpringLesson::draw_arrows(Scene& picture) const {
    const Vec<3> edges = block_->lengths();
    if (picture.show_arrows && weight_acceleration() > 0) {
        const Real x = -std::max(frame_side() + 0.3 * edges.norm(), 0.76 * edges.norm()), top = 0.8 * (edges[1] + drop_height),
                   length = 0.4 * edges[1];
        picture.arrow(position(x, top, 0), position(x, top - length, 0), Ink::force,
                      "g = " + format_quantity(gravity, "m/s²", 3));
    }
    if (!pulled()) return;
    const Vec<3> from = position_.col(load_.pull.node), to = load_.pull.target;
    picture.arrow(position<3>(from), position<3>(to), Ink::force, format_quantity(pull_stiffness * (to - from).norm(), "N", 3));
}

void MassSpringLesson::write_notes(Scene& picture) const {
    const auto& cells = block_->lattice().nodes().cells();
    picture.notes.push_back(fmt::format("{} × {} × {} cells: {} nodes of {}, {} springs", cells[0], cells[1], cells[2],
                                        position_.cols(), mass_text(block_->mass()[0]), block_->springs().size()));
    if (implicit()) {
        picture.notes.push_back(fmt::format("Δt = {}, ω Δt = {}: implicit, no limit", format_quantity(dt, "s", 3),
                                            format_quantity(rates().omega * dt, "", 3)));
    } else if (const std::string too_large = too_large_a_step(); too_large.empty()) {
        picture.notes.push_back(fmt::format("Δt = {} ≤ {}, the stability limit", format_quantity(dt, "s", 3),
                                            format_quantity(stable_time_step(), "s", 3)));
    } else {
        picture.notes.push_back(stable_time_step() == 0
                                    ? fmt::format("Δt = {}: unstable at every Δt", format_quantity(dt, "s", 3))
                                    : fmt::format("Δt = {} > {}, the stability limit", format_quantity(dt, "s", 3),
                                                  format_quantity(stable_time_step(), "s", 3)));
    }
}

}  // namespace pliant::mass_spring
