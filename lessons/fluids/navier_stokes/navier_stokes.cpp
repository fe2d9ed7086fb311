#include "navier_stokes.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant::navier_stokes {
namespace {

const Registration<NavierStokes> registration{
    {.id = "fluids/navier_stokes",
     .title = "Navier–Stokes equations",
     .summary = "Forces, advection, viscosity, projection: one step of an incompressible fluid on a staggered grid.",
     .demo_steps = 300}};

}  // namespace

void NavierStokes::check() const {
    constexpr Index most_cells = 1 << 19;
    const Counts<2> cells = cells_of(scene(), settings());
    if (const Index all = cells[0] * cells[1]; all > most_cells) {
        const Real fewer = std::sqrt(static_cast<Real>(most_cells) / static_cast<Real>(all));
        throw Refused("resolution", resolution.value(), "",
                      fmt::format("at most about {} for a domain of this shape, which then has {} cells",
                                  static_cast<Index>(fewer * resolution.value()), most_cells));
    }
    if (scheme != Scheme::explicit_euler || !with_viscosity || nu() == 0) return;
    const Real limit = dx() * dx() / (4 * nu());
    if (dt > limit * (1 + 1e-12))
        throw Refused(
            "time_step", dt, "s",
            fmt::format("at most Δx²/(4ν) = {:.4g} s, where explicit viscosity is stable for viscosity = {:.4g} m²/s and "
                        "resolution = {}, or choose the implicit viscosity scheme",
                        limit, nu(), Index(resolution)));
}

// -------------------------------------------------------------------------------------------------- what follows from them

Input NavierStokes::nu_input() const {
    if (scene().reynolds_length == 0) return viscosity;
    return part("ν = |U| l L / Re", {speed_parameter(), reynolds_length_input(), size, reynolds});
}

// ------------------------------------------------------------------------------------------------------ the initial state

void NavierStokes::reset() {
    grid_ = std::make_unique<StaggeredGrid<2>>(domain(scene(), settings()));
    advection_.reset();
    diffusion_.reset();
    projection_.reset();
    velocity_ = grid_->zero_velocity();
    if (scene().start) scene().start(*grid_, settings(), velocity_);
    grid_->impose_walls(velocity_);
    const Index cells = grid_->cells().size(), pressures = with_projection ? cells : 0;
    for (VecX* array : {&pressure_, &divergence_before_, &divergence_after_}) *array = VecX::Zero(pressures);
    smoke_ = VecX::Zero(scene().drives.smoke ? cells : 0);
    fill_source();
    elapsed_.setZero();
    elapsed_[4] = max_speed(velocity_);
    wake_.reset();
    if (scene().readings.wake) {
        // Two and a half diameters behind the middle of the disc.
        const Vec<2> place = (obstacle_centre(scene()) + Vec<2>(2.5 * scene().obstacle, 0)) * resolution.value();
        const Lattice<2>& faces = grid_->faces(1);
        Counts<2> at{static_cast<Index>(place[0]), std::lround(place[1])};
        for (int a = 0; a < 2; ++a) at[a] = std::min(at[a], faces.count[a] - 1);
        wake_face_ = faces.index(at);
        // The stream starts as it flows around the disc without friction.
        if (with_projection) PressureProjection<2>(*grid_, {1e-6, 1000}).project(velocity_, dt);
    }
    fields_of_flow_.reset(*grid_, velocity_);
    initial_energy_ = specific_energy();
    compared_ = velocity_;
}

std::string NavierStokes::blow_up_hint() const {
    return fmt::format(
        "The fastest fluid crosses {} cells per step; semi-Lagrangian advection is stable there but the forces are not resolved: "
        "lower the time step below {} or the force",
        format_quantity(courant_number(*grid_, velocity_, dt), ""),
        format_quantity(5 * dx() / std::max(max_speed(velocity_), 1e-300), "s"));
}

std::optional<Fix> NavierStokes::fix(const Failure& failure) const {
    if (failure.field == "pressure" && max_iterations < 200) return Fix{"200 iterations", {{"max_iterations", "200"}}};
    if (failure.field == "pressure") return Fix{"a tolerance of 10⁻⁴", {{"tolerance", "1e-4"}}};
    return fix_by(dt, rounded_down(2 * dx() / std::max(max_speed(velocity_), dx() / dt)));
}

}  // namespace pliant::navier_stokes
