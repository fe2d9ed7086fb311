// The figure: a heat map of the field that is chosen, the velocity as arrows, and the walls.
#include "fluids/flow/grid_picture.h"
#include "navier_stokes.h"

#include <pliant/lesson/format.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pliant::navier_stokes {
namespace {

constexpr float wall_width = 5;  // px

}  // namespace

void NavierStokes::draw(Scene& scene) const {
    flow::draw_field(scene, *this, *grid_);
    if (scene.show_arrows) flow::draw_velocity(scene, *grid_, fields_of_flow_.flow(), arrow_speed());
    draw_walls(scene);
    write_notes(scene);
    scene.frame(position(-0.06, -0.06), position(1.06, 1.12));
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
