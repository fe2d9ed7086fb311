#include "navier_stokes.h"

#include <pliant/text/format.h>

#include <cmath>

#include <fmt/format.h>

namespace pliant::navier_stokes {
namespace {

const Registration<NavierStokes> registration{
    {.id = "fluids/navier_stokes",
     .title = "Navier–Stokes equations",
     .summary = "Forces, advection, viscosity, projection: one step of an incompressible fluid on a staggered grid.",
     .demo_steps = 300}};

std::vector<Option> scene_options() {
    std::vector<Option> options;
    for (const FlowScene& s : scenes()) options.push_back({s.key, s.label});
    return options;
}

}  // namespace

NavierStokes::NavierStokes()
    : scenario(*this,
               {.key = "scene",
                .help = "what the fluid is in and what drives it; the presets have one or two of each with fitting numbers",
                .effect = Effect::rebuild},
               scene_options()),
      resolution(*this, {.key = "resolution",
                         .symbol = "n",
                         .help = "cells along the length L; Δx = L/n",
                         .initial = 96,
                         .useful = {8, 256},
                         .accepted = Interval{1, 512},
                         .effect = Effect::rebuild}),
      viscosity(*this, {.key = "viscosity",
                        .symbol = "ν",
                        .unit = "m²/s",
                        .help = "kinematic viscosity μ/ρ; water 1e-6, oil 1e-4, honey 1e-2. 0 leaves the viscosity stage out",
                        .initial = 1e-4,
                        .useful = {1e-6, 1},
                        .accepted = Interval{0, 1e6},
                        .scale = Scale::log,
                        .used = [this] { return with_viscosity && scene().reynolds_length == 0; }}),
      reynolds(*this,
               {.key = "reynolds",
                .symbol = "Re",
                .help = "U L/ν of the cavity, with its width; U D/ν of the vortex street, with the disc's diameter. It sets "
                        "the viscosity of these scenes",
                .initial = 100,
                .useful = {1, 1e4},
                .accepted = Interval{1e-6, 1e9},
                .scale = Scale::log,
                .used = [this] { return with_viscosity && scene().reynolds_length > 0; }}),
      dt(*this, {.key = "time_step",
                 .symbol = "Δt",
                 .unit = "s",
                 .help = "fixed; semi-Lagrangian advection is stable at any, and accurate while CFL stays small",
                 .initial = 0.02,
                 .useful = {1e-3, 0.5},
                 .accepted = Interval{0, 10, true},
                 .scale = Scale::log}),
      aspect(*this, {.key = "aspect",
                     .symbol = "H/W",
                     .help = "height over width of the box or the cavity, rounded to whole cells",
                     .initial = 1,
                     .useful = {0.25, 3},
                     .accepted = Interval{0.1, 10},
                     .effect = Effect::rebuild,
                     .used = [this] { return scene().any_aspect; }}),
      size(*this, {.key = "size",
                   .symbol = "L",
                   .unit = "m",
                   .help = "width of the box, height of the channels; the vortex street has a channel of 2 L × 0.75 L",
                   .initial = 1,
                   .useful = {0.01, 100},
                   .accepted = Interval{1e-6, 1e6},
                   .scale = Scale::log,
                   .effect = Effect::rebuild}),
      lid_speed(*this, {.key = "lid_speed",
                        .symbol = "U",
                        .unit = "m/s",
                        .help = "of the upper wall, to the right",
                        .initial = 1,
                        .useful = {-2, 2},
                        .accepted = Interval{-1e6, 1e6},
                        .effect = Effect::rebuild,
                        .used = [this] { return scene().drives.lid; }}),
      inflow(*this, {.key = "inflow",
                     .symbol = "U",
                     .unit = "m/s",
                     .help = "speed at which the fluid enters on the left, and leaves on the right: as much out as in",
                     .initial = 1,
                     .useful = {0.1, 2},
                     .accepted = Interval{0, 1e6},
                     .effect = Effect::rebuild,
                     .used = [this] { return scene().drives.inflow; }}),
      stirring(*this, {.key = "stirring",
                       .symbol = "S",
                       .unit = "m/s²",
                       .help = "body force per unit mass in the middle of the stirrer; negative pushes backwards",
                       .initial = 6,
                       .useful = {-20, 20},
                       .accepted = Interval{-1e6, 1e6},
                       .used = [this] { return with_forces && scene().drives.stirrer; }}),
      body_force(*this, {.key = "body_force",
                         .symbol = "G",
                         .unit = "m/s²",
                         .help = "body force per unit mass along the channel: a slope's share of gravity, or a pressure drop per "
                                 "length and density",
                         .initial = 0.1,
                         .useful = {-1, 1},
                         .accepted = Interval{-1e6, 1e6},
                         .effect = Effect::rebuild,
                         .used = [this] { return with_forces && scene().drives.body_force; }}),
      buoyancy(*this, {.key = "buoyancy",
                       .symbol = "β",
                       .unit = "m/s²",
                       .help = "upward force per unit mass where the smoke is densest: g times its relative lightness",
                       .initial = 2,
                       .useful = {-5, 5},
                       .accepted = Interval{-1e6, 1e6},
                       .used = [this] { return with_forces && scene().drives.smoke; }}),
      order(
          *this,
          {.key = "order",
           .help = "of the stages. The lecture has forces, advection, viscosity, projection; in another order the step ends with "
                   "divergence",
           .effect = Effect::rebuild},
          {{"lecture", "the lecture's"},
           {"projection_first", "projection first"},
           {"advection_last", "advection last"},
           {"forces_last", "forces last"}}),
      with_forces(*this, {.key = "with_forces",
                          .help = "f: without it nothing pushes the fluid but walls",
                          .initial = 1,
                          .used = [this] { return scene().drives.by_force(); }}),
      with_advection(*this, {.key = "with_advection",
                             .help = "(u·∇)u: without it the fluid does not carry itself along, as in very thick flow",
                             .initial = 1}),
      with_viscosity(*this, {.key = "with_viscosity", .help = "ν ∇²u: without it walls drag nothing along", .initial = 1}),
      with_projection(*this, {.key = "with_projection",
                              .help = "−∇p: without it fluid piles up and thins out, and there is no pressure",
                              .initial = 1,
                              .effect = Effect::rebuild}),
      advection(
          *this,
          {.key = "advection",
           .help = "linear interpolation dissipates most; the monotone cubic less; MacCormack's correction makes the linear one "
                   "second order. None makes a new extremum",
           .used = [this] { return with_advection || scene().drives.smoke; }},
          {{"semi_lagrangian", "semi-Lagrangian, linear"},
           {"monotone_cubic", "semi-Lagrangian, monotone cubic"},
           {"mac_cormack", "MacCormack"}}),
      back_trace(
          *this,
          {.key = "back_trace",
           .help = "how a particle is followed back: straight with the velocity where it arrives (Euler), or with the velocity "
                   "half way",
           .initial = 1,
           .used = [this] { return with_advection || scene().drives.smoke; }},
          {{"euler", "Euler"}, {"midpoint", "midpoint rule"}}),
      scheme(*this,
             {.key = "viscosity_scheme",
              .help = "implicit is stable at every Δt; explicit is the lecture's stencil, refused beyond Δt = Δx²/(4ν)",
              .used = [this] { return with_viscosity && nu() > 0; }},
             {{"implicit", "implicit Euler"}, {"explicit", "explicit Euler"}}),
      tolerance(*this, {.key = "tolerance",
                        .symbol = "τ",
                        .help = "the pressure solver stops when max|∇·u| ≤ τ max|∇·ũ|",
                        .initial = 1e-4,
                        .useful = {1e-8, 0.5},
                        .accepted = Interval{1e-12, 1, false, true},
                        .scale = Scale::log,
                        .used = [this] { return bool(with_projection); }}),
      max_iterations(*this, {.key = "max_iterations",
                             .help = "of the pressure solver; when they are not enough the run stops and says what is left",
                             .initial = 200,
                             .useful = {1, 200},
                             .accepted = Interval{1, 1000},
                             .used = [this] { return bool(with_projection); }}) {
    declare_fields();
    declare_stages();
    declare_probes();
    declare_wake_probes();
    declare_lines();
    declare_checks();
}

void NavierStokes::check() const {
    constexpr Index most_cells = 1 << 19;
    const Counts<2> cells = cells_of(scene(), settings());
    if (const Index all = cells[0] * cells[1]; all > most_cells) {
        const Real fewer = std::sqrt(static_cast<Real>(most_cells) / static_cast<Real>(all));
        throw Refused("resolution", static_cast<Real>(Index(resolution)), "",
                      fmt::format("at most about {} for a domain of this shape, which then has {} cells",
                                  static_cast<Index>(fewer * static_cast<Real>(Index(resolution))), most_cells));
    }
    if (scheme != Scheme::explicit_euler || !with_viscosity || nu() == 0) return;
    const Real limit = dx() * dx() / (4 * nu());
    if (dt > limit * (1 + 1e-12))
        throw Refused(
            "time_step", dt, "s",
            fmt::format("at most Δx²/(4ν) = {:.4g} s, where explicit viscosity is stable for viscosity = {:.4g} m²/s and "
                        "resolution = {}, or set viscosity_scheme to implicit",
                        limit, nu(), Index(resolution)));
}

// -------------------------------------------------------------------------------------------------- what follows from them

Real NavierStokes::width() const { return static_cast<Real>(grid_->cell_counts()[0]) * dx(); }
Real NavierStokes::height() const { return static_cast<Real>(grid_->cell_counts()[1]) * dx(); }

Real NavierStokes::reference_speed() const {
    return scene().drives.lid ? std::abs(lid_speed) : scene().drives.inflow ? Real(inflow) : Real{0};
}

Real NavierStokes::nu() const {
    const Real length = scene().reynolds_length;
    return length > 0 ? reference_speed() * length * size / reynolds : Real(viscosity);
}

Input NavierStokes::nu_input() const {
    const Real length = scene().reynolds_length;
    if (length == 0) return Input::of(viscosity);
    return Input::part("ν", "m²/s",
                       {"ν = |U| l L / Re",
                        {Input::of(scene().drives.lid ? static_cast<const Parameter&>(lid_speed) : inflow),
                         Input::constant("l", length, "", "length of the Reynolds number in units of L"), Input::of(size),
                         Input::of(reynolds)}});
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
        const Vec<2> place =
            (obstacle_centre(scene()) + Vec<2>(2.5 * scene().obstacle, 0)) * static_cast<Real>(Index(resolution));
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
        "lower time_step below {} or the force",
        format_quantity(courant_number(*grid_, velocity_, dt), ""),
        format_quantity(5 * dx() / std::max(max_speed(velocity_), 1e-300), "s"));
}

std::optional<Fix> NavierStokes::fix(const Failure& failure) const {
    if (failure.field == "pressure" && max_iterations < 200) return Fix{"200 iterations", {{"max_iterations", "200"}}};
    if (failure.field == "pressure") return Fix{"tolerance = 1e-4", {{"tolerance", "1e-4"}}};
    const Real step = rounded_down(2 * dx() / std::max(max_speed(velocity_), dx() / dt));
    return Fix{fmt::format("Δt = {}", format_quantity(step, "s")), {{"time_step", format_exact(step)}}};
}

// The errors of space and time shrink together.
std::vector<std::pair<std::string, std::string>> NavierStokes::finer() const {
    return {{"resolution", std::to_string(std::min<Index>(2 * resolution, 512))}, {"time_step", format_exact(dt / 2)}};
}

}  // namespace pliant::navier_stokes
