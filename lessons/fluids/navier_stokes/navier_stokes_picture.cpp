// The figure: a heat map of the field that is chosen, the velocity as arrows, and the walls.
#include "navier_stokes.h"

#include <pliant/lesson/format.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pliant::navier_stokes {
namespace {

constexpr Index most_arrows = 18;    // along each side
constexpr Real longest_arrow = 1.8;  // in spacings; faster fluid has arrows of this length
constexpr float wall_width = 5;      // px

}  // namespace

void NavierStokes::draw(Scene& scene) const {
    draw_field(scene);
    if (scene.show_arrows) draw_velocity(scene);
    draw_walls(scene);
    write_notes(scene);
    scene.frame(position(-0.06, -0.06), position(1.06, 1.12));
}

// Numbers on faces are drawn as cells around the faces, half of which reach beyond the walls.
void NavierStokes::draw_field(Scene& scene) const {
    const Field* field = find_field(scene.colour_by.field);
    const On on = field && (field->on == On::x_face || field->on == On::y_face) ? field->on : On::cell;
    const Lattice<2>& lattice = on == On::x_face ? grid_->faces(0) : on == On::y_face ? grid_->faces(1) : grid_->cells();
    const auto corner = [&](Real beyond_x, Real beyond_y) {
        return position((lattice.offset[0] - 0.5 + beyond_x) * dx(), (lattice.offset[1] - 0.5 + beyond_y) * dx());
    };
    GridMarks map;
    map.nx = static_cast<int>(lattice.count[0]);
    map.ny = static_cast<int>(lattice.count[1]);
    map.lower = corner(0, 0);
    map.upper = corner(static_cast<Real>(map.nx), static_cast<Real>(map.ny));
    map.pick.on = on;
    map.values = scene.values(*this, on);
    if (map.values.empty()) map.values.assign(static_cast<std::size_t>(lattice.size()), 0.0f);
    scene.grids.push_back(std::move(map));
}

// The speed whose arrow is as long as the arrows are apart. It does not follow the flow, so that arrows compare over time.
Real NavierStokes::arrow_speed() const {
    switch (scenario) {
        case Scenario::box:
            return 0.7;
        case Scenario::cavity:
            return lid_speed == 0 ? 1 : 0.4 * std::abs(lid_speed);
        case Scenario::taylor_green:
            return 1;
    }
    return 1;
}

void NavierStokes::draw_velocity(Scene& scene) const {
    const Index count = std::min<Index>(most_arrows, resolution);
    const Real spacing = Real(1) / static_cast<Real>(count), scale = spacing / arrow_speed();
    ArrowMarks arrows{.from = {}, .to = {}, .ink = Ink::velocity, .width = 1.6f};
    for (Index j = 0; j < count; ++j) {
        for (Index i = 0; i < count; ++i) {
            const Vec<2> x = spacing * Vec<2>(static_cast<Real>(i) + 0.5, static_cast<Real>(j) + 0.5);
            const GridPlace<2> u = fields_of_flow_.flow().at({x[0] / dx(), x[1] / dx()});
            Vec<2> arrow = scale * Vec<2>(u[0], u[1]);
            const Real length = arrow.norm();
            if (length < 0.05 * spacing) continue;
            if (length > longest_arrow * spacing) arrow *= longest_arrow * spacing / length;
            arrows.from.push_back(position<2>(x - 0.5 * arrow));
            arrows.to.push_back(position<2>(x + 0.5 * arrow));
        }
    }
    scene.arrows.push_back(std::move(arrows));
}

void NavierStokes::draw_walls(Scene& scene) const {
    if (scenario == Scenario::taylor_green) {
        scene.box(position(0, 0), position(1, 1), Ink::rest, 2, true);
        if (scene.show_labels)
            scene.label(position(0.5, 1), "periodic: what leaves on one side enters on the other", Ink::text, 0, -14);
        return;
    }
    scene.box(position(0, 0), position(1, 1), Ink::ground, wall_width);
    if (scenario == Scenario::cavity) {
        scene.line(position(0, 1), position(1, 1), Ink::accent, wall_width + 2);
        if (lid_speed == 0) return;
        const Real half = 0.14 * std::clamp(Real(lid_speed), Real(-1), Real(1));
        scene.arrows.push_back(
            {.from = {position(0.5 - half, 1.035)}, .to = {position(0.5 + half, 1.035)}, .ink = Ink::accent, .width = 4});
        if (scene.show_labels)
            scene.label(position(0.5, 1.035), "lid: U = " + format_quantity(lid_speed, "m/s"), Ink::accent, 0, -16);
    } else if (stirred()) {
        const Vec<2> middle = stirrer_place(), push = (stirring > 0 ? 0.09 : -0.09) * stirrer_heading();
        scene.points.push_back({.at = {position<2>(middle)}, .ink = Ink::force, .radius = 6});
        scene.arrows.push_back(
            {.from = {position<2>(middle)}, .to = {position<2>(middle + push)}, .ink = Ink::force, .width = 4});
        if (scene.show_labels) scene.label(position<2>(middle), "f", Ink::force, 0, -16);
    }
    if (pull_) scene.arrow(position(pull_->from[0], pull_->from[1]), position(pull_->to[0], pull_->to[1]), Ink::force, "jet");
}

void NavierStokes::write_notes(Scene& scene) const {
    scene.notes.push_back(fmt::format("{0} × {0} cells, Δx = {1}", Index(resolution), format_quantity(dx(), "m", 3)));
    std::string fluid = "ν = " + format_quantity(viscosity, "m²/s", 3);
    if (const auto Re = reynolds()) fluid += ", Re = U · 1 m / ν = " + format_quantity(*Re, "", 3);
    scene.notes.push_back(std::move(fluid));
    if (scene.show_arrows) scene.notes.push_back("arrow of one spacing: " + format_quantity(arrow_speed(), "m/s", 3));
}

}  // namespace pliant::navier_stokes
