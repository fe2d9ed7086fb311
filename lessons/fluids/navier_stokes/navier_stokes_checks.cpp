// Assumptions, what mends them, and laws.
#include "navier_stokes.h"

#include <pliant/text/format.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pliant::navier_stokes {
namespace {

constexpr Real largest_courant = 5;        // [Bridson2007 §3.2]
constexpr Real largest_cell_reynolds = 2;  // above it central differences of advection would wiggle
constexpr Real fewest_cells = 8;           // across the disc

}  // namespace

std::optional<Fix> NavierStokes::shorter_step(Real cells) const {
    const Real step = rounded_down(cells * dx() / max_speed(velocity_));
    return Fix{fmt::format("Δt = {}", format_quantity(step, "s")), {{"time_step", format_exact(step)}}};
}

// Where the Reynolds number sets the viscosity, a smaller one.
std::optional<Fix> NavierStokes::thicker_fluid(Real wanted) const {
    if (scene().reynolds_length > 0) {
        const Real Re = rounded_down(reynolds * nu() / wanted);
        return Fix{fmt::format("Re = {}", format_quantity(Re, "")), {{"reynolds", format_exact(Re)}}};
    }
    const Real thicker = -rounded_down(-wanted);
    return Fix{fmt::format("ν = {}", format_quantity(thicker, "m²/s")), {{"viscosity", format_exact(thicker)}}};
}

void NavierStokes::declare_checks() {
    const auto viscous = [this] { return with_viscosity && with_advection && nu() > 0; };
    const auto rounding = [this] { return 1e-12 * std::max(max_speed(velocity_), reference_speed()) / dx(); };
    const auto kept_by_solver = [this, rounding] {
        return tolerance * (projection_ ? projection_->initial_divergence() : Real{0}) * (1 + 1e-6) + rounding();
    };
    assumptions = {
        {.name = "divergence-free",
         .unit = "1/s",
         .value = [this] { return divergence_left(); },
         .limit = kept_by_solver,
         .formula = "max|∇·u| ≤ τ max|∇·ũ|",
         .broken =
             "a stage behind the projection, or no projection, leaves divergence: fluid is made and lost in every step, and "
             "the velocity that is drawn is not that of an incompressible fluid",
         .used = [this] { return time() > 0; },
         .fix =
             [this] {
                 return with_projection
                            ? Fix{"the lecture's order", {{"order", "lecture"}}}
                            : Fix{"project, in the lecture's order", {{"with_projection", "true"}, {"order", "lecture"}}};
             }},
        {.name = "courant number",
         .value = [this] { return courant_number(*grid_, velocity_, dt); },
         .limit = [] { return largest_courant; },
         .formula = "max|u| Δt/Δx ≤ 5",
         .broken = "still stable, but the particle paths cut through vortices and walls: the flow is smeared and late",
         .used = [this] { return bool(with_advection); },
         .fix = [this] { return shorter_step(4); }},
        {.name = "interpolation viscosity",
         .unit = "m²/s",
         .value = [this] { return interpolation_viscosity(); },
         .limit = [this] { return nu(); },
         .formula = "s(1 − s)Δx²/(2Δt) ≤ ν, s: fraction of a cell crossed per step",
         .broken = "linear interpolation smooths the flow more than its own viscosity does: vortices die too soon",
         .used = [this, viscous] { return viscous() && advection == Advection::semi_lagrangian; },
         .fix =
             [] {
                 return Fix{"MacCormack", {{"advection", "mac_cormack"}}};
             }},
        {.name = "cell reynolds number",
         .value = [this] { return max_speed(velocity_) * dx() / nu(); },
         .limit = [] { return largest_cell_reynolds; },
         .formula = "max|u| Δx/ν ≤ 2",
         .broken = "boundary layers and the smallest vortices are thinner than a cell: what is seen is the grid's",
         .used = viscous,
         .fix = [this] { return thicker_fluid(max_speed(velocity_) * dx() / largest_cell_reynolds * 1.2); }},
        {.name = "disc of cells",
         .unit = "",
         .value = [] { return fewest_cells; },
         .limit = [this] { return scene().obstacle * static_cast<Real>(Index(resolution)); },
         .formula = "8 ≤ D/Δx",
         .broken = "a disc of so few squares is no disc: its wake is that of a block",
         .used = [this] { return scene().obstacle > 0; },
         .fix = [this]() -> std::optional<Fix> {
             const auto n = static_cast<Index>(std::ceil(fewest_cells / scene().obstacle));
             return Fix{fmt::format("{} cells per L", n), {{"resolution", std::to_string(n)}}};
         }}};
    conserved = {{.probe = "max_divergence",
                  .law = Law::zero,
                  .tolerance = kept_by_solver,
                  .expected = [this] { return bool(with_projection); }},
                 {.probe = "kinetic_energy",
                  .law = Law::never_grows,
                  .tolerance = [this] { return 1e-9 * std::max(initial_energy_, specific_energy()); },
                  .expected =
                      [this] {
                          const Drives& drives = scene().drives;
                          return order == Order::lecture && with_projection && !(with_forces && forced()) && !drives.lid &&
                                 !drives.inflow;
                      },
                  .cancels = [this] { return specific_energy(); }}};
}

// Steady: what has changed in the time in which the fastest fluid goes the length L is a small part of its speed.
bool NavierStokes::at_rest() const {
    constexpr Real part = 1e-4;
    return elapsed_[5] > 0 && elapsed_[6] <= part * top_speed();
}

std::string NavierStokes::unrest() const {
    // Reynolds numbers up to which they are [Williamson1996], [BruneauSaad2006].
    constexpr Real steady_wake = 40, steady_cavity = 8000;
    const Drives& drives = scene().drives;
    if (with_forces && stirred()) return "a jet goes around in the box without end (stirring)";
    if (with_forces && drives.smoke && buoyancy != 0) return "smoke is made and rises without end (buoyancy)";
    if (with_forces && uniform_force() != Vec<2>::Zero() && !(with_viscosity && nu() > 0))
        return "without viscosity nothing holds the fluid back, and the force makes it ever faster";
    if (!with_advection || !with_viscosity) return "";
    if (scene().readings.wake && reynolds > steady_wake)
        return fmt::format("above Re = {} vortices leave the disc without end (reynolds)", steady_wake);
    if (drives.lid && scene().reynolds_length > 0 && reynolds > steady_cavity)
        return fmt::format("above Re = {} the flow in a cavity is not steady (reynolds)", steady_cavity);
    return "";
}

}  // namespace pliant::navier_stokes
