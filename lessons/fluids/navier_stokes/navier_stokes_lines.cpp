// Profiles: on the centre lines of boxes, against published numbers for the cavity, and across channels, against closed forms.
#include "navier_stokes.h"

#include <pliant/fluids/cavity_tables.h>
#include <pliant/fluids/channel_flow.h>

#include <algorithm>
#include <cmath>

namespace pliant::navier_stokes {
namespace {

// At the walls and in the middle of every row of cells.
template <class Speed>
void sample_across(Index rows, Real dx, Curve& curve, const Speed& speed) {
    curve = {};
    for (Index i = -1; i <= rows; ++i) {
        const Real y = std::clamp((static_cast<Real>(i) + Real(0.5)) * dx, Real(0), static_cast<Real>(rows) * dx);
        curve.position.push_back(y);
        curve.value.push_back(speed(y));
    }
}

}  // namespace

void NavierStokes::declare_lines() {
    const auto walled = [this] { return scene().readings.centre_lines; };
    lines = {
        line_of("u_center", "m/s", "y", "m",
                "horizontal velocity on the vertical line through the middle; the table is that of the steady square cavity at "
                "Re = 100",
                [this](Curve& curve) { profile(0, curve); })
            .against(
                "Ghia et al. 1982", [this](Curve& curve) { published_profile(0, curve); }, true)
            .measures("u on the vertical centre line")
            .when(walled),
        line_of("v_center", "m/s", "x", "m",
                "vertical velocity on the horizontal line through the middle; the table is that of the steady square cavity at "
                "Re = 100",
                [this](Curve& curve) { profile(1, curve); })
            .against(
                "Ghia et al. 1982", [this](Curve& curve) { published_profile(1, curve); }, true)
            .measures("v on the horizontal centre line")
            .when(walled),
        line_of("profile", "m/s", "y", "m",
                "velocity along the channel, from wall to wall; pushed, the steady one is G y (H − y)/(2ν), drawn when it is "
                "near; dragged, U y/H",
                [this](Curve& curve) { profile(0, curve); })
            .against("closed form", [this](Curve& curve) { scene().drives.lid ? present_profile(curve) : steady_profile(curve); })
            .when([this] { return scene().readings.profile; })
            .beside({{.name = "closed form at this time",
                      .sample = [this](Curve& curve) { scene().drives.lid ? void() : present_profile(curve); }},
                     {.name = "steady: U y/H",
                      .sample = [this](Curve& curve) { scene().drives.lid ? steady_profile(curve) : void(); }}})};
}

// The component across `axis` on the centre line along the other axis.
void NavierStokes::profile(int axis, Curve& curve) const {
    sample_across(grid_->cell_counts()[1 - axis], dx(), curve, [&](Real along) { return velocity_on_centre_line(axis, along); });
}

GridPlace<2> NavierStokes::place_on_centre_line(int axis, Real along) const {
    GridPlace<2> place;
    for (int a = 0; a < 2; ++a) {
        const Real n = static_cast<Real>(grid_->cell_counts()[a]);
        place[static_cast<std::size_t>(a)] = a == axis ? n / 2 : std::clamp(along / dx(), Real(0), n);
    }
    return place;
}

// ------------------------------------------------------------------------------------------------------------- the cavity

// A lid that moves to the left makes the mirror image.
void NavierStokes::published_profile(int axis, Curve& curve) const {
    curve = {};
    const Counts<2>& cells = grid_->cell_counts();
    const bool square_cavity = scene().drives.lid && cells[0] == cells[1];
    if (!square_cavity || lid_speed == 0 || std::abs(reynolds - 100) > 0.5 || !with_viscosity) return;
    const bool mirrored = lid_speed < 0;
    const auto add = [&](const cavity::TableRow& row) {
        curve.position.push_back(width() * (axis == 1 && mirrored ? 1 - row.position : row.position));
        curve.value.push_back((axis == 0 ? Real(lid_speed) : std::abs(lid_speed)) * row.velocity);
    };
    if (axis == 0)
        std::for_each(cavity::u_on_vertical_line.begin(), cavity::u_on_vertical_line.end(), add);
    else if (mirrored)
        std::for_each(cavity::v_on_horizontal_line.rbegin(), cavity::v_on_horizontal_line.rend(), add);
    else
        std::for_each(cavity::v_on_horizontal_line.begin(), cavity::v_on_horizontal_line.end(), add);
}

std::optional<NavierStokes::Difference> NavierStokes::largest_from_table() const {
    if (!scene().readings.centre_lines) return std::nullopt;
    std::optional<Difference> largest;
    Curve published;
    for (int axis = 0; axis < 2; ++axis) {
        published_profile(axis, published);
        for (std::size_t k = 0; k < published.position.size(); ++k) {
            const Real along = published.position[k];
            const Difference here{axis, along, velocity_on_centre_line(axis, along), published.value[k]};
            if (!largest || here > *largest) largest = here;
        }
    }
    return largest;
}

// --------------------------------------------------------------------------------------------------------- the channels

bool NavierStokes::has_closed_form() const {
    if (!scene().readings.profile || pull_) return false;
    if (scene().drives.lid) return true;
    const auto kept = [this](Real integral, Real value) {
        return std::abs(integral - value * time()) <= 1e-9 * std::abs(integral);
    };
    return kept(viscous_time(), with_viscosity ? nu() : Real{0}) && kept(pushed(), with_forces ? Real(body_force) : Real{0});
}

Real NavierStokes::closed_form(Real y) const {
    if (scene().drives.lid) return couette_start_up(y, height(), lid_speed, viscous_time());
    return poiseuille_start_up(y, height(), with_forces ? Real(body_force) : Real{0}, with_viscosity ? nu() : Real{0}, time());
}

void NavierStokes::present_profile(Curve& curve) const {
    if (!has_closed_form()) return;
    sample_across(grid_->cell_counts()[1], dx(), curve, [this](Real y) { return closed_form(y); });
}

void NavierStokes::steady_profile(Curve& curve) const {
    curve = {};
    if (nu() == 0 || !with_viscosity) return;
    // What is still far away would leave nothing to see of the flow as it is.
    constexpr Real far = 10;
    const Real middle = height() / 2;
    if (scene().drives.body_force && has_closed_form() &&
        std::abs(poiseuille_speed(middle, height(), body_force, nu())) > far * std::abs(closed_form(middle)))
        return;
    sample_across(grid_->cell_counts()[1], dx(), curve, [this](Real y) {
        return scene().drives.lid ? lid_speed * y / height() : poiseuille_speed(y, height(), body_force, nu());
    });
}

std::optional<NavierStokes::Difference> NavierStokes::largest_from_closed_form() const {
    if (!has_closed_form()) return std::nullopt;
    std::optional<Difference> largest;
    for (Index j = 0; j < grid_->cell_counts()[1]; ++j) {
        const Real y = (static_cast<Real>(j) + Real(0.5)) * dx();
        const Difference here{0, y, velocity_on_centre_line(0, y), closed_form(y)};
        if (!largest || here > *largest) largest = here;
    }
    return largest;
}

}  // namespace pliant::navier_stokes
