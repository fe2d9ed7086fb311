// Assumptions, what mends them, and laws.
#include "navier_stokes.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::navier_stokes {
namespace {

constexpr Real largest_courant = 5;        // [Bridson2007 §3.2]
constexpr Real largest_cell_reynolds = 2;  // above it central differences of advection would wiggle
constexpr Real fewest_cells = 8;           // across the disc

}  // namespace

// Where the Reynolds number sets the viscosity, a smaller one.
Fix NavierStokes::thicker_fluid(Real wanted) const {
    if (scene().reynolds_length > 0) return fix_by(reynolds, rounded_down(reynolds * nu() / wanted));
    return fix_by(viscosity, -rounded_down(-wanted));
}

void NavierStokes::declare_checks() {
    const auto viscous = [this] { return with_viscosity && with_advection && nu() > 0; };
    const auto rounding = [this] { return 1e-12 * std::max(max_speed(velocity_), reference_speed()) / dx(); };
    const auto kept_by_solver = [this, rounding] {
        return tolerance * (projection_ ? projection_->initial_divergence() : Real{0}) * (1 + 1e-6) + rounding();
    };
    assumptions = {
        assumption_of(
            "divergence-free", "1/s", [this] { return divergence_left(); }, kept_by_solver, "max|∇·u| ≤ τ max|∇·ũ|",
            "a stage behind the projection, or no projection, leaves divergence: fluid is made and lost in every step, and "
            "the velocity that is drawn is not that of an incompressible fluid")
            .when([this] { return time() > 0; })
            .mended_by([this] {
                return with_projection
                           ? Fix{"the lecture's order", {{"order", "lecture"}}}
                           : Fix{"project, in the lecture's order", {{"with_projection", "true"}, {"order", "lecture"}}};
            }),
        assumption_of(
            "courant number", "", [this] { return courant_number(*grid_, velocity_, dt); }, [] { return largest_courant; },
            "max|u| Δt/Δx ≤ 5",
            "still stable, but the particle paths cut through vortices and walls: the flow is smeared and late")
            .when([this] { return bool(with_advection); })
            .mended_by([this] { return fix_by(dt, rounded_down(4 * dx() / max_speed(velocity_))); }),
        assumption_of(
            "interpolation viscosity", "m²/s", [this] { return interpolation_viscosity(); }, [this] { return nu(); },
            "s(1 − s)Δx²/(2Δt) ≤ ν, s: fraction of a cell crossed per step",
            "linear interpolation smooths the flow more than its own viscosity does: vortices die too soon")
            .when([this, viscous] { return viscous() && advection == grid2d::Carrying::linear; })
            .mended_by(Fix{"MacCormack", {{"advection", "mac_cormack"}}}),
        assumption_of(
            "cell reynolds number", "", [this] { return max_speed(velocity_) * dx() / nu(); },
            [] { return largest_cell_reynolds; }, "max|u| Δx/ν ≤ 2",
            "boundary layers and the smallest vortices are thinner than a cell: what is seen is the grid's")
            .when(viscous)
            .mended_by([this] { return thicker_fluid(max_speed(velocity_) * dx() / largest_cell_reynolds * 1.2); }),
        assumption_of(
            "disc of cells", "", [] { return fewest_cells; }, [this] { return scene().obstacle * resolution.value(); },
            "8 ≤ D/Δx", "a disc of so few squares is no disc: its wake is that of a block")
            .when([this] { return scene().obstacle > 0; })
            .mended_by([this]() -> std::optional<Fix> {
                const auto n = static_cast<Index>(std::ceil(fewest_cells / scene().obstacle));
                return Fix{fmt::format("{} cells per L", n), {{"resolution", std::to_string(n)}}};
            })};
    conserved = {{"max_divergence", Law::zero, kept_by_solver, [this] { return bool(with_projection); }},
                 {"kinetic_energy", Law::never_grows, [this] { return 1e-9 * std::max(initial_energy_, specific_energy()); },
                  [this] {
                      const Drives& drives = scene().drives;
                      return order == Order::lecture && with_projection && !(with_forces && forced()) && !drives.lid &&
                             !drives.inflow;
                  },
                  [this] { return specific_energy(); }}};
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
