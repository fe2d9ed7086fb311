// The figure: a heat map of the field that is chosen, the velocity as arrows, the walls, and what drives the fluid.
#include "kits/grid2d/grid_picture.h"
#include "navier_stokes.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::navier_stokes {
namespace {

using std::numbers::pi;

constexpr float wall_width = 5;  // px

void circle(Scene& scene, const Vec<2>& centre, Real radius, Ink ink, float width) {
    constexpr int sides = 48;
    LineMarks line{.ends = {}, .ink = ink, .width = width};
    for (int k = 0; k < sides; ++k)
        for (int end = 0; end < 2; ++end) {
            const Real angle = 2 * pi * (k + end) / sides;
            line.ends.push_back(position<2>(centre + radius * Vec<2>(std::cos(angle), std::sin(angle))));
        }
    scene.lines.push_back(std::move(line));
}

}  // namespace

void NavierStokes::draw(Scene& picture) const {
    grid2d::draw_field(picture, *this, *grid_);
    if (picture.show_arrows)
        grid2d::draw_velocity(picture, *grid_, fields_of_flow_.flow(), arrow_speed(), scene().obstacle > 0 ? 24 : 18);
    if (scene().obstacle > 0) draw_obstacle(picture);
    draw_walls(picture);
    draw_drives(picture);
    write_notes(picture);
    // The arrow of a lid stands above it.
    const Real above = scene().drives.lid ? 0.18 : 0.06;
    picture.frame(position(-0.06 * size, -0.06 * size),
                  position(width() + 0.06 * size, height() + above * std::max(Real(size), height())));
}

void NavierStokes::draw_walls(Scene& picture) const {
    const Real W = width(), H = height();
    const auto side = [&](int axis, const Position& from, const Position& to) {
        const bool open = axis == 0 && scene().drives.inflow, periodic = grid_->periodic(axis);
        if (open) return;
        picture.line(from, to, periodic ? Ink::rest : Ink::ground, periodic ? 2 : wall_width, periodic);
    };
    side(0, position(0, 0), position(0, H));
    side(0, position(W, 0), position(W, H));
    side(1, position(0, 0), position(W, 0));
    side(1, position(0, H), position(W, H));
    if (!picture.show_labels) return;
    if (grid_->periodic(0))
        picture.label(position(0.5 * W, 0), grid_->periodic(1) ? "periodic in x and y" : "periodic in x", Ink::text, 0, 14);
    if (!scene().drives.inflow) return;
    picture.label(position(0, H), "in: U = " + format_quantity(inflow, "m/s"), Ink::velocity, 40, -16);
    picture.label(position(W, H), "out: U", Ink::velocity, -24, -16);
}

void NavierStokes::draw_obstacle(Scene& picture) const {
    grid2d::draw_solids(picture, *grid_);
    const Vec<2> centre = size * obstacle_centre(scene());
    circle(picture, centre, size * scene().obstacle / 2, Ink::ground, 2);
    if (!scene().readings.wake || !picture.show_labels) return;
    const Lattice<2>& faces = grid_->faces(1);
    const GridPlace<2> place = faces.place(faces.coordinates(wake_face_));
    const Position probe = position(place[0] * dx(), place[1] * dx());
    picture.points.push_back({.at = {probe}, .ink = Ink::accent, .radius = 5});
    picture.label(probe, "v", Ink::accent, 0, -14);
}

void NavierStokes::draw_drives(Scene& picture) const {
    const Real W = width(), H = height();
    // Above the upper wall, with its label.
    const auto along_wall = [&](Real half, Ink ink, const std::string& label) {
        const Real above = H + 0.035 * size;
        if (half != 0)
            picture.arrows.push_back(
                {.from = {position(0.72 * W - half, above)}, .to = {position(0.72 * W + half, above)}, .ink = ink, .width = 4});
        if (picture.show_labels) picture.label(position(0.72 * W, above), label, ink, 0, -16);
    };
    if (scene().drives.lid) {
        picture.line(position(0, H), position(W, H), Ink::accent, wall_width + 2);
        along_wall(0.14 * W * std::clamp(Real(lid_speed), Real(-1), Real(1)), Ink::accent,
                   "wall: U = " + format_quantity(lid_speed, "m/s"));
    }
    if (with_forces && stirred()) {
        const Vec<2> middle = stirrer_place(time()), push = (stirring > 0 ? 0.09 : -0.09) * size * stirrer_heading(time());
        picture.points.push_back({.at = {position<2>(middle)}, .ink = Ink::force, .radius = 6});
        picture.arrows.push_back(
            {.from = {position<2>(middle)}, .to = {position<2>(middle + push)}, .ink = Ink::force, .width = 4});
        if (picture.show_labels) picture.label(position<2>(middle), "f", Ink::force, 0, -16);
    }
    if (with_forces && uniform_force()[0] != 0)
        along_wall(body_force > 0 ? 0.1 * W : -0.1 * W, Ink::force, "G = " + format_quantity(body_force, "m/s²"));
    if (scene().drives.smoke) {
        const SmokeSource source = smoke_source();
        circle(picture, size * source.centre, size * source.radius, Ink::accent, 2.5f);
        if (picture.show_labels)
            picture.labels.push_back({.at = position<2>(size * (source.centre + Vec<2>(source.radius, 0))),
                                      .text = "source",
                                      .ink = Ink::accent,
                                      .away_from = position<2>(size * source.centre)});
    }
    if (pull_) picture.arrow(position(pull_->from[0], pull_->from[1]), position(pull_->to[0], pull_->to[1]), Ink::force, "jet");
}

void NavierStokes::write_notes(Scene& picture) const {
    const Counts<2>& cells = grid_->cell_counts();
    picture.notes.push_back(fmt::format("{} × {} cells, Δx = {}", cells[0], cells[1], format_quantity(dx(), "m", 3)));
    std::string fluid = with_viscosity ? "ν = " + format_quantity(nu(), "m²/s", 3) : "without viscosity";
    if (scene().reynolds_length > 0 && with_viscosity)
        fluid += fmt::format(", Re = U {} / ν = {}", scene().obstacle > 0 ? "D" : "L", format_quantity(reynolds, "", 3));
    if (scene().readings.profile && with_viscosity && nu() > 0)
        fluid += ", H²/ν = " + format_quantity(height() * height() / nu(), "s", 3);
    picture.notes.push_back(std::move(fluid));
    if (picture.show_arrows) picture.notes.push_back("arrow of one spacing: " + format_quantity(arrow_speed(), "m/s", 3));
}

std::optional<UnstructuredGrid> NavierStokes::unstructured_grid() const { return grid2d::grid_of_cells(*grid_); }

}  // namespace pliant::navier_stokes
