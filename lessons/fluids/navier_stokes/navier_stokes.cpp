#include "navier_stokes.h"

#include <pliant/lesson/format.h>

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace pliant::navier_stokes {
namespace {

using std::numbers::pi;

// The stirrer pushes the fluid within about this distance ahead of it, on its way around a figure of eight.
constexpr Real stirrer_radius = 0.06, stirrer_width = 0.3, stirrer_height = 0.25, stirrer_period = 8;  // m, m, m, s
// A pull is a jet at its start, of this acceleration per metre that it is drawn out.
constexpr Real pull_radius = 0.06, pull_stiffness = 40;  // m, 1/s²
constexpr Index most_iterations = 200;

const Registration<NavierStokes> registration{
    {.id = "fluids/navier_stokes",
     .title = "Navier–Stokes equations",
     .summary = "Forces, advection, viscosity, projection: one step of an incompressible fluid on a staggered grid.",
     .demo_steps = 300}};

}  // namespace

NavierStokes::NavierStokes()
    : scenario(*this,
               {.key = "scene",
                .help = "a stirred box with walls to slide along, a cavity driven by its lid, or periodic Taylor–Green vortices",
                .effect = Effect::rebuild},
               {{"box", "stirred box"}, {"cavity", "lid-driven cavity"}, {"taylor_green", "Taylor–Green vortices"}}),
      resolution(*this, {.key = "resolution",
                         .symbol = "n",
                         .help = "cells along each side of the square; Δx = 1 m / n",
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
                        .scale = Scale::log}),
      dt(*this, {.key = "time_step",
                 .symbol = "Δt",
                 .unit = "s",
                 .help = "fixed; semi-Lagrangian advection is stable at any, and accurate while CFL stays small",
                 .initial = 0.02,
                 .useful = {1e-3, 0.5},
                 .accepted = Interval{0, 10, true},
                 .scale = Scale::log}),
      stirring(*this, {.key = "stirring",
                       .symbol = "S",
                       .unit = "m/s²",
                       .help = "body force per unit mass in the middle of the stirrer; negative pushes backwards",
                       .initial = 6,
                       .useful = {-20, 20},
                       .accepted = Interval{-1e6, 1e6},
                       .used = [this] { return scenario == Scenario::box; }}),
      lid_speed(*this, {.key = "lid_speed",
                        .symbol = "U",
                        .unit = "m/s",
                        .help = "of the upper wall, to the right",
                        .initial = 1,
                        .useful = {-2, 2},
                        .accepted = Interval{-1e3, 1e3},
                        .effect = Effect::rebuild,
                        .used = [this] { return scenario == Scenario::cavity; }}),
      tolerance(*this, {.key = "tolerance",
                        .symbol = "τ",
                        .help = "the pressure solver stops when max|∇·u| ≤ τ max|∇·ũ|",
                        .initial = 1e-4,
                        .useful = {1e-8, 0.5},
                        .accepted = Interval{1e-12, 1, false, true},
                        .scale = Scale::log}),
      scheme(*this,
             {.key = "viscosity_scheme",
              .help = "implicit is stable at every Δt; explicit is the lecture's stencil, refused beyond Δt = Δx²/(4ν)",
              .used = [this] { return viscosity > 0; }},
             {{"implicit", "implicit Euler"}, {"explicit", "explicit Euler"}}) {
    declare_fields();
    declare_stages();
    declare_probes();
    declare_lines();
    declare_checks();
}

void NavierStokes::check() const {
    if (scheme != Scheme::explicit_euler || viscosity == 0) return;
    const Real limit = dx() * dx() / (4 * viscosity);
    if (dt > limit * (1 + 1e-12))
        throw Refused(
            "time_step", dt, "s",
            fmt::format("at most Δx²/(4ν) = {:.4g} s, where explicit viscosity is stable for viscosity = {:.4g} m²/s and "
                        "resolution = {}, or set viscosity_scheme to implicit",
                        limit, Real(viscosity), Index(resolution)));
}

// ------------------------------------------------------------------------------------------------------ the initial state

StaggeredGridInfo<2> NavierStokes::domain() const {
    StaggeredGridInfo<2> info;
    info.cells = {resolution, resolution};
    info.dx = dx();
    info.periodic.fill(scenario == Scenario::taylor_green);
    if (scenario == Scenario::cavity) {
        for (auto& axis : info.walls)
            for (Wall<2>& wall : axis) wall.slip = Slip::none;
        info.walls[1][1].velocity = {lid_speed, 0};
    }
    return info;
}

void NavierStokes::reset() {
    grid_ = std::make_unique<StaggeredGrid<2>>(domain());
    advection_ = std::make_unique<SemiLagrangian<2>>(*grid_);
    diffusion_ = std::make_unique<Viscosity<2>>(*grid_);
    projection_ = std::make_unique<PressureProjection<2>>(*grid_, ProjectionSettings{tolerance, most_iterations});
    velocity_ = grid_->zero_velocity();
    if (scenario == Scenario::taylor_green) start_taylor_green();
    grid_->impose_walls(velocity_);
    pressure_ = VecX::Zero(grid_->cells().size());
    elapsed_.setZero();
    divergence(*grid_, velocity_, divergence_after_);
    divergence_before_ = divergence_after_;
    fields_of_flow_.reset(*grid_, velocity_);
    initial_energy_ = specific_energy();
}

// u = sin 2πx cos 2πy, v = −cos 2πx sin 2πy, in m/s [TaylorGreen1937].
void NavierStokes::start_taylor_green() {
    for (int axis = 0; axis < 2; ++axis) {
        const Lattice<2>& faces = grid_->faces(axis);
        for (Index f = 0; f < faces.size(); ++f) {
            const GridPlace<2> at = faces.place(faces.coordinates(f));
            const Real x = 2 * pi * at[0] * dx(), y = 2 * pi * at[1] * dx();
            velocity_[axis][f] = axis == 0 ? std::sin(x) * std::cos(y) : -std::cos(x) * std::sin(y);
        }
    }
}

// ------------------------------------------------------------------------------------------------------------- the stages

void NavierStokes::declare_stages() {
    stages = {
        {.name = "external_forces",
         .formula = "ũ ← u + Δt f,   f: force per unit mass",
         .source = "Utrecht slides, Navier–Stokes equations; Stam1999 §3.1",
         .run = [this] { external_forces(); },
         .reads = {"velocity"},
         .writes = {"u_on_faces", "v_on_faces"},
         .active = [this] { return forced(); },
         .explain = [this](const Question& q) { return why_force(flow::axis_of(q.field), q.index); }},
        {.name = "advection",
         .formula = "ũ(x) ← ũ(x − Δt ũ(x − ½Δt ũ(x)))",
         .source = "semi-Lagrangian: Stam1999 §3.2; Bridson2007 §3",
         .run = [this] { advect(); },
         .reads = {"velocity"},
         .writes = {"u_on_faces", "v_on_faces"},
         .explain =
             [this](const Question& q) {
                 return why_on_grid().advected(advection_->flow(), dt, flow::axis_of(q.field), q.index);
             }},
        {.name = "viscosity",
         .formula = "implicit: ũ − (νΔt/Δx²)(Σũₙ − 4ũ) = ũ old;   explicit: ũ ← ũ + (νΔt/Δx²)(Σũₙ − 4ũ)",
         .source = "Utrecht slides, 4-neighbour stencil, with the 1/Δx² and the old value that they leave out; Stam1999 §3.3",
         .run = [this] { diffuse(); },
         .reads = {"velocity"},
         .writes = {"u_on_faces", "v_on_faces"},
         .active = [this] { return viscosity > 0; },
         .explain = [this](const Question& q) { return why_diffused(flow::axis_of(q.field), q.index); }},
        {.name = "projection",
         .formula = "Δt ∇²p = ∇·ũ,   u ← ũ − Δt ∇p",
         .source = "Utrecht slides, pressure projection (p is p/ρ); Chorin1968; Bridson2007 §4.3",
         .run = [this] { projection_pass(); },
         .reads = {"velocity", "pressure"},
         .writes = {"divergence_before", "pressure", "divergence_after", "u_on_faces", "v_on_faces"},
         .again = [this] { return !projection_->converged(); },
         .begin = [this] { begin_projection(); },
         .end = [this] { end_projection(); },
         .explain = [this](const Question& q) { return why_projection(q); }}};
}

// The middle of the stirrer: a figure of eight around the middle of the box.
Vec<2> NavierStokes::stirrer_place() const {
    const Real angle = 2 * pi * time() / stirrer_period;
    return {0.5 + stirrer_width * std::sin(angle), 0.5 + stirrer_height * std::sin(2 * angle)};
}

Vec<2> NavierStokes::stirrer_heading() const {
    const Real angle = 2 * pi * time() / stirrer_period;
    return Vec<2>(stirrer_width * std::cos(angle), 2 * stirrer_height * std::cos(2 * angle)).normalized();
}

NavierStokes::Jet NavierStokes::stirrer_jet() const { return {stirrer_place(), stirrer_radius, stirring * stirrer_heading()}; }

NavierStokes::Jet NavierStokes::hand_jet() const {
    return {pull_->from.head<2>(), pull_radius, pull_stiffness * (pull_->to - pull_->from).head<2>()};
}

void NavierStokes::external_forces() {
    const auto push = [this](const Jet& jet) { add_jet<2>(*grid_, velocity_, dt, jet.centre, jet.radius, jet.acceleration); };
    if (stirred()) push(stirrer_jet());
    if (pull_) push(hand_jet());
    fields_of_flow_.renew();
}

void NavierStokes::advect() {
    advection_->advect(velocity_, dt);
    fields_of_flow_.renew();
}

void NavierStokes::diffuse() {
    if (scheme == Scheme::explicit_euler)
        diffusion_->diffuse_explicitly(velocity_, viscosity, dt);
    else
        diffusion_->diffuse_implicitly(velocity_, viscosity, dt);
    fields_of_flow_.renew();
}

void NavierStokes::begin_projection() {
    divergence(*grid_, velocity_, divergence_before_);
    projection_->set({tolerance, most_iterations});
    projection_->pressure() = pressure_;
    projection_->begin(velocity_, dt);
}

void NavierStokes::projection_pass() {
    projection_->iterate();
    pressure_ = projection_->pressure();
    // The residual of the solver is the divergence that this pressure leaves.
    divergence_after_ = -dt / (dx() * dx()) * projection_->residual();
}

void NavierStokes::end_projection() {
    projection_->apply(velocity_);
    divergence(*grid_, velocity_, divergence_after_);
    elapsed_ += Eigen::Array2d(dt, viscosity * dt);
    fields_of_flow_.renew();
}

std::string NavierStokes::blow_up_hint() const {
    return fmt::format(
        "The fastest fluid crosses {} cells per step; semi-Lagrangian advection is stable there but the forces are not resolved: "
        "lower time_step below {} or the force",
        format_quantity(courant_number(*grid_, velocity_, dt), ""),
        format_quantity(5 * dx() / std::max(max_speed(velocity_), 1e-300), "s"));
}

std::optional<Fix> NavierStokes::fix(const Failure& failure) const {
    if (failure.field == "pressure") return Fix{"tolerance = 1e-4", {{"tolerance", "1e-4"}}};
    const Real step = rounded_down(2 * dx() / std::max(max_speed(velocity_), dx() / dt));
    return Fix{fmt::format("Δt = {}", format_quantity(step, "s")), {{"time_step", format_exact(step)}}};
}

// The errors of space and time shrink together.
std::vector<std::pair<std::string, std::string>> NavierStokes::finer() const {
    return {{"resolution", std::to_string(std::min<Index>(2 * resolution, 512))}, {"time_step", format_exact(dt / 2)}};
}

}  // namespace pliant::navier_stokes
