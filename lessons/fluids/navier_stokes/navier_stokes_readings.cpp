// What the lesson shows and measures: fields, probes, profiles, assumptions.
#include "cavity_tables.h"
#include "navier_stokes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <pliant/lesson/format.h>

#include <fmt/format.h>

namespace pliant::navier_stokes {
namespace {

using std::numbers::pi;

constexpr Real largest_courant = 5;        // [Bridson2007 §3.2]
constexpr Real largest_cell_reynolds = 2;  // above it central differences of advection would wiggle
constexpr Real largest_velocity = 1e9;     // m/s: beyond it the run is stopped

}  // namespace

void NavierStokes::declare_fields() {
    state = {state_array("u_on_faces", "m/s", velocity_[0]), state_array("v_on_faces", "m/s", velocity_[1]),
             state_array("pressure", "m²/s²", pressure_), state_array("elapsed", "s, m²", elapsed_)};
    fields = {{.name = "velocity",
               .symbol = "u",
               .unit = "m/s",
               .on = On::cell,
               .rank = Rank::vector,
               .components = 2,
               .view = [this] { return flow::numbers(fields_of_flow_.centre_velocity()); },
               .help = "at cell centres, the mean of the two faces across each axis, where it is stored",
               .defined_by = {"u_on_faces", "v_on_faces"},
               .explain = [this](const Question& q) { return why_on_grid().cell_velocity(q.index, q.component); }},
              {.name = "speed",
               .symbol = "|u|",
               .unit = "m/s",
               .on = On::cell,
               .view = [this] { return flow::numbers(fields_of_flow_.speed()); },
               .defined_by = {"velocity"},
               .explain = [this](const Question& q) { return why_on_grid().speed(q.index); }},
              {.name = "vorticity",
               .symbol = "ω",
               .unit = "1/s",
               .on = On::cell,
               .view = [this] { return flow::numbers(fields_of_flow_.vorticity()); },
               .help = "∂v/∂x − ∂u/∂y: twice the rate at which the fluid turns, positive to the left",
               .defined_by = {"u_on_faces", "v_on_faces"},
               .explain = [this](const Question& q) { return why_on_grid().vorticity(q.index); }},
              {.name = "divergence_before",
               .symbol = "∇·ũ",
               .unit = "1/s",
               .on = On::cell,
               .view = view_of(divergence_before_),
               .help = "of the velocity that enters the projection: what flows out of each cell, per area"},
              {.name = "divergence_after",
               .symbol = "∇·u",
               .unit = "1/s",
               .on = On::cell,
               .view = view_of(divergence_after_),
               .help = "of the velocity that the projection leaves; after a pass of its solver, that which the pressure so far "
                       "would leave"},
              {.name = "pressure",
               .symbol = "p",
               .unit = "m²/s²",
               .on = On::cell,
               .view = view_of(pressure_),
               .help = "kinematic pressure p/ρ: the lecture's Δt ∇²p = ∇·u has no ρ. Its mean is 0, since a closed box fixes p "
                       "up to a constant"},
              {.name = "u_on_faces",
               .symbol = "u",
               .unit = "m/s",
               .on = On::x_face,
               .view = view_of(velocity_[0]),
               .help = "x component of the velocity, where it is stored: on the upright faces of the cells",
               .bound = [] { return largest_velocity; }},
              {.name = "v_on_faces",
               .symbol = "v",
               .unit = "m/s",
               .on = On::y_face,
               .view = view_of(velocity_[1]),
               .help = "y component of the velocity, where it is stored: on the level faces of the cells",
               .bound = [] { return largest_velocity; }}};
}

// -------------------------------------------------------------------------------------------------------------- probes

void NavierStokes::declare_probes() {
    probes = {
        {.name = "kinetic_energy",
         .symbol = "e",
         .unit = "J/kg",
         .help = "½|u|² per mass, mean over the fluid; times ρ · 1 m² it is the energy per metre of depth",
         .value = [this] { return specific_energy(); },
         .exact = [this](Real t) -> std::optional<Real> {
             if (scenario != Scenario::taylor_green) return std::nullopt;
             return initial_energy_ * std::exp(-16 * pi * pi * (elapsed_[1] + viscosity * (t - time())));
         }},
        {.name = "max_divergence",
         .symbol = "max|∇·u|",
         .unit = "1/s",
         .help = "what the projection leaves",
         .value = [this] { return divergence_after_.lpNorm<Eigen::Infinity>(); },
         .explain = [this] { return flow::largest("max|∇·u|", divergence_after_, "divergence_after"); }},
        {.name = "max_divergence_before",
         .symbol = "max|∇·ũ|",
         .unit = "1/s",
         .help = "what the projection was given",
         .value = [this] { return divergence_before_.lpNorm<Eigen::Infinity>(); },
         .explain = [this] { return flow::largest("max|∇·ũ|", divergence_before_, "divergence_before"); }},
        {.name = "cfl",
         .symbol = "CFL",
         .help = "Courant number max|u| Δt/Δx: cells that the fastest fluid crosses in a step",
         .value = [this] { return courant_number(*grid_, velocity_, dt); },
         .explain = [this] { return why_on_grid().courant(velocity_); }},
        {.name = "solver_iterations",
         .help = "of the pressure solver in the latest step",
         .value = [this] { return static_cast<Real>(projection_->iterations()); }},
        {.name = "reynolds", .symbol = "Re", .help = "U · 1 m / ν of the cavity", .value = [this] { return reynolds(); }},
        {.name = "table_difference",
         .unit = "m/s",
         .help = "largest difference on both centre lines from the table of the steady cavity at Re = 100",
         .value = [this] { return table_difference(); }},
        {.name = "effective_viscosity",
         .unit = "m²/s",
         .help =
             "viscosity that the decay of the Taylor–Green energy amounts to, −ln(e/e₀)/(16π²t); what exceeds ν is the method's",
         .value = [this] { return effective_viscosity(); },
         .exact = [this](Real) { return effective_viscosity() ? std::optional(elapsed_[1] / time()) : std::nullopt; }}};
}

Real NavierStokes::specific_energy() const {
    return pliant::kinetic_energy(*grid_, velocity_) / (grid_->cell_volume() * static_cast<Real>(grid_->fluid_cells()));
}

std::optional<Real> NavierStokes::reynolds() const {
    if (scenario != Scenario::cavity || viscosity == 0) return std::nullopt;
    return std::abs(lid_speed) / viscosity;
}

std::optional<Real> NavierStokes::effective_viscosity() const {
    const Real energy = specific_energy();
    if (scenario != Scenario::taylor_green || time() == 0 || energy <= 0) return std::nullopt;
    return -std::log(energy / initial_energy_) / (16 * pi * pi * time());
}

// What linear interpolation adds where the fluid crosses s cells per step, at the root mean square of the speed:
// s(1 − s)Δx²/(2Δt), with s the fraction of a cell.
Real NavierStokes::interpolation_viscosity() const {
    const Real cells = std::sqrt(2 * specific_energy()) * dt / dx();
    const Real s = cells - std::floor(cells);
    return s * (1 - s) * dx() * dx() / (2 * dt);
}

std::vector<std::string_view> NavierStokes::first_plots() const {
    if (scenario == Scenario::cavity) return {"u_center", "v_center", "kinetic_energy"};
    if (scenario == Scenario::taylor_green) return {"kinetic_energy", "effective_viscosity", "max_divergence"};
    return {"kinetic_energy", "max_divergence", "cfl"};
}

std::vector<std::string_view> NavierStokes::key_numbers() const {
    if (scenario == Scenario::cavity) return {"reynolds", "kinetic_energy", "max_divergence"};
    return {"kinetic_energy", "max_divergence", "cfl"};
}

// ------------------------------------------------------------------------------------------------------------- profiles

void NavierStokes::declare_lines() {
    const auto walled = [this] { return scenario != Scenario::taylor_green; };
    lines = {{.name = "u_center",
              .unit = "m/s",
              .position_name = "y",
              .position_unit = "m",
              .help = "horizontal velocity on the vertical line x = 1/2; the table is that of the steady cavity at Re = 100",
              .sample = [this](Curve& curve) { profile(0, curve); },
              .reference = [this](Curve& curve) { published_profile(0, curve); },
              .reference_name = "Ghia et al. 1982",
              .reference_points = true,
              .used = walled},
             {.name = "v_center",
              .unit = "m/s",
              .position_name = "x",
              .position_unit = "m",
              .help = "vertical velocity on the horizontal line y = 1/2; the table is that of the steady cavity at Re = 100",
              .sample = [this](Curve& curve) { profile(1, curve); },
              .reference = [this](Curve& curve) { published_profile(1, curve); },
              .reference_name = "Ghia et al. 1982",
              .reference_points = true,
              .used = walled}};
}

// The component across `axis` on the centre line along the other axis: at the walls and at every row of faces between.
void NavierStokes::profile(int axis, Curve& curve) const {
    curve.position.clear();
    curve.value.clear();
    for (Index i = -1; i <= resolution; ++i) {
        const Real along = std::clamp((static_cast<Real>(i) + Real(0.5)) * dx(), Real(0), Real(1));
        curve.position.push_back(along);
        curve.value.push_back(velocity_on_centre_line(axis, along));
    }
}

Real NavierStokes::velocity_on_centre_line(int axis, Real along) const {
    const Real n = static_cast<Real>(Index(resolution)), s = std::clamp(along * n, Real(0), n);
    return fields_of_flow_.flow().component(axis).at(axis == 0 ? GridPlace<2>{n / 2, s} : GridPlace<2>{s, n / 2});
}

// A lid that moves to the left makes the mirror image.
void NavierStokes::published_profile(int axis, Curve& curve) const {
    curve.position.clear();
    curve.value.clear();
    const std::optional<Real> Re = reynolds();
    if (!Re || std::abs(*Re - 100) > 0.5) return;
    const bool mirrored = lid_speed < 0;
    const auto add = [&](const TableRow& row) {
        curve.position.push_back(axis == 1 && mirrored ? 1 - row.position : row.position);
        curve.value.push_back((axis == 0 ? Real(lid_speed) : std::abs(lid_speed)) * row.velocity);
    };
    if (axis == 0)
        std::for_each(u_on_vertical_line.begin(), u_on_vertical_line.end(), add);
    else if (mirrored)
        std::for_each(v_on_horizontal_line.rbegin(), v_on_horizontal_line.rend(), add);
    else
        std::for_each(v_on_horizontal_line.begin(), v_on_horizontal_line.end(), add);
}

std::optional<Real> NavierStokes::table_difference() const {
    std::optional<Real> largest;
    Curve published;
    for (int axis = 0; axis < 2; ++axis) {
        published_profile(axis, published);
        for (std::size_t k = 0; k < published.position.size(); ++k) {
            const Real difference = std::abs(velocity_on_centre_line(axis, published.position[k]) - published.value[k]);
            largest = std::max(largest.value_or(0), difference);
        }
    }
    return largest;
}

// -------------------------------------------------------------------------------------------- assumptions and laws

std::optional<Fix> NavierStokes::shorter_step(Real cells) const {
    const Real step = rounded_down(cells * dx() / max_speed(velocity_));
    return Fix{fmt::format("Δt = {}", format_quantity(step, "s")), {{"time_step", format_exact(step)}}};
}

std::optional<Fix> NavierStokes::thicker_fluid(Real wanted) const {
    const Real nu = -rounded_down(-wanted);
    return Fix{fmt::format("ν = {}", format_quantity(nu, "m²/s")), {{"viscosity", format_exact(nu)}}};
}

void NavierStokes::declare_checks() {
    const auto viscous = [this] { return viscosity > 0; };
    assumptions = {{.name = "courant number",
                    .value = [this] { return courant_number(*grid_, velocity_, dt); },
                    .limit = [] { return largest_courant; },
                    .formula = "max|u| Δt/Δx ≤ 5",
                    .broken = "still stable, but the particle paths cut through vortices and walls: the flow is smeared and late",
                    .fix = [this] { return shorter_step(4); }},
                   {.name = "interpolation viscosity",
                    .unit = "m²/s",
                    .value = [this] { return interpolation_viscosity(); },
                    .limit = [this] { return Real(viscosity); },
                    .formula = "s(1 − s)Δx²/(2Δt) ≤ ν, s: fraction of a cell crossed per step",
                    .broken = "linear interpolation smooths the flow more than its own viscosity does: vortices die too soon",
                    .used = viscous,
                    .fix = [this] { return thicker_fluid(1.5 * dx() * dx() / (8 * dt)); }},
                   {.name = "cell reynolds number",
                    .value = [this] { return max_speed(velocity_) * dx() / viscosity; },
                    .limit = [] { return largest_cell_reynolds; },
                    .formula = "max|u| Δx/ν ≤ 2",
                    .broken = "boundary layers and the smallest vortices are thinner than a cell: what is seen is the grid's",
                    .used = viscous,
                    .fix = [this] { return thicker_fluid(max_speed(velocity_) * dx() / largest_cell_reynolds * 1.2); }}};
    conserved = {{.probe = "max_divergence",
                  .law = Law::zero,
                  .tolerance =
                      [this] {
                          const Real rounding = 1e-12 * std::max(max_speed(velocity_), std::abs(lid_speed)) / dx();
                          return tolerance * projection_->initial_divergence() * (1 + 1e-6) + rounding;
                      }},
                 {.probe = "kinetic_energy",
                  .law = Law::never_grows,
                  .tolerance = [] { return 1e-9; },
                  .expected = [this] { return scenario != Scenario::cavity && !forced(); }}};
}

}  // namespace pliant::navier_stokes
