// What the lesson shows and measures: fields and probes.
#include "navier_stokes.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::navier_stokes {
namespace {

using std::numbers::pi;

constexpr Real largest_velocity = 1e9;  // m/s: beyond it the run is stopped

}  // namespace

void NavierStokes::declare_fields() {
    state = {state_array("u_on_faces", "m/s", velocity_[0]),
             state_array("v_on_faces", "m/s", velocity_[1]),
             state_array("pressure", "m²/s²", pressure_),
             state_array("smoke", "", smoke_),
             state_array("elapsed", "s, m², m/s, 1/s, m/s, s, m/s", elapsed_),
             state_array("wake", "s, m/s", wake_.memory()),
             state_array("u_compared", "m/s", compared_[0]),
             state_array("v_compared", "m/s", compared_[1])};
    const auto projected = [this] { return bool(with_projection); };
    const auto velocity = [this]() -> const FaceField<2>& { return velocity_; };
    const auto why = [this] { return why_on_grid(); };
    fields = {
        grid2d::velocity_field(fields_of_flow_, why,
                               "at cell centres, the mean of the two faces across each axis, where it is stored"),
        grid2d::speed_field(fields_of_flow_, why),
        scalar_field(
            "vorticity", "ω", "1/s", On::cell, [this] { return as_span(fields_of_flow_.vorticity()); },
            "∂v/∂x − ∂u/∂y: twice the rate at which the fluid turns, positive to the left")
            .of_both_signs()
            .follows({"u_on_faces", "v_on_faces"}, [why](const Question& q) { return why().vorticity(q.index); }),
        scalar_field(
            "divergence", "∇·u", "1/s", On::cell,
            [this] { return largest_divergence(), as_span(std::as_const(divergence_now_)); },
            "of the velocity as it stands now, behind any stage: what flows out of each cell, per area")
            .of_both_signs()
            .follows({"u_on_faces", "v_on_faces"},
                     [why](const Question& q) { return why().divergence(q.index, Input::From::now); }),
        scalar_field("divergence_before", "∇·ũ", "1/s", On::cell, divergence_before_,
                     "of the velocity that enters the projection: what flows out of each cell, per area")
            .of_both_signs()
            .when(projected),
        scalar_field("divergence_after", "∇·u", "1/s", On::cell, divergence_after_,
                     "of the velocity that the projection leaves; after a pass of its solver, that which the pressure so far "
                     "would leave")
            .of_both_signs()
            .when(projected),
        scalar_field("pressure", "p", "m²/s²", On::cell, pressure_,
                     "kinematic pressure p/ρ: the lecture's Δt ∇²p = ∇·u has no ρ. Its mean is 0, since a closed box fixes p "
                     "up to a constant")
            .of_both_signs()
            .when(projected),
        grid2d::stored_velocity(0, velocity, largest_velocity),
        grid2d::stored_velocity(1, velocity, largest_velocity),
        scalar_field("smoke", "s", "", On::cell, smoke_,
                     "how much of a cell is smoke, 1 where it is made; it is carried along and lifted by its warmth")
            .stops_at(1 + 1e-9)
            .when([this] { return scene().drives.smoke; })};
}

// -------------------------------------------------------------------------------------------------------------- probes

void NavierStokes::declare_probes() {
    const auto projected = [this] { return bool(with_projection); };
    const auto watched = [this] { return scene().readings.wake; };
    probes = {
        probe_of("kinetic_energy", "e", "J/kg",
                 "½|u|² per mass, mean over the fluid; times ρ and the area it is the energy per metre of depth",
                 [this] { return specific_energy(); })
            .exactly([this](Real t) -> std::optional<Real> {
                if (!scene().readings.decay) return std::nullopt;
                const Real ahead = with_viscosity ? nu() * (t - time()) : Real{0};
                return initial_energy_ * std::exp(-16 * pi * pi * (viscous_time() + ahead) / (size * size));
            }),
        grid2d::largest_probe("max_divergence", "max|∇·u|", "1/s", "what the projection leaves", divergence_after_,
                              "divergence_after")
            .when(projected),
        grid2d::largest_probe("max_divergence_before", "max|∇·ũ|", "1/s", "what the projection was given", divergence_before_,
                              "divergence_before")
            .when(projected),
        probe_of(
            "divergence_left", "max|∇·u|", "1/s",
            "of the velocity as it stands; at the end of a step in the lecture's order it is what the projection leaves",
            [this] { return largest_divergence(); },
            [this] { return largest_divergence(), grid2d::largest("max|∇·u|", divergence_now_, "divergence"); }),
        probe_of(
            "max_speed", "max|u|", "m/s", "largest component of the velocity on any face",
            [this] { return pliant::max_speed(velocity_); }, [this] { return why_max_speed(); }),
        probe_of(
            "cfl", "CFL", "", "Courant number max|u| Δt/Δx: cells that the fastest fluid crosses in a step",
            [this] { return courant_number(*grid_, velocity_, dt); }, [this] { return why_on_grid().courant(velocity_); }),
        probe_of("solver_iterations", "", "", "of the pressure solver in the latest step",
                 [this] { return projection_ ? static_cast<Real>(projection_->iterations()) : 0; }),
        probe_of(
            "reynolds_number", "Re", "",
            "U L/ν: of the cavity with the lid's speed, of the vortex street with the disc's diameter and the inflow, "
            "elsewhere with the fastest fluid",
            [this] {
                const Real length = scene().reynolds_length;
                return (length > 0 ? reference_speed() * length : pliant::max_speed(velocity_)) * size / nu();
            },
            [this] { return why_reynolds(); })
            .when([this] { return with_viscosity && nu() > 0; }),
        probe_of(
            "table_difference", "", "m/s",
            "largest difference on both centre lines from the table of the steady square cavity at Re = 100",
            [this] { return largest_from_table(); }, [this] { return why_difference(*largest_from_table(), "u_table"); }),
        probe_of("effective_viscosity", "", "m²/s",
                 "viscosity that the decay of the Taylor–Green energy amounts to, −ln(e/e₀) L²/(16π²t); what exceeds ν is "
                 "the method's")
            .formula(*this, "ν_eff = −ln(e / e₀) L² / (16 π² t)",
                     {Input::now("e", "kinetic_energy", 0), size,
                      Input::live("e₀", "J/kg", "at the start", [this] { return initial_energy_; }),
                      Input::live("t", "s", "time since the start", [this] { return time(); })})
            .exactly([this](Real) { return viscous_time() / time(); })
            .when([this] { return scene().readings.decay && time() > 0 && specific_energy() > 0; }),
        probe_of(
            "profile_difference", "", "m/s", "largest difference across the channel from the closed form at this time",
            [this] { return largest_from_closed_form(); },
            [this] { return why_difference(*largest_from_closed_form(), "u_exact"); }),
        probe_of(
            "wake_velocity", "v", "m/s",
            "across the stream, 2½ diameters behind the middle of the disc: it swings with the vortices",
            [this] { return wake_velocity(); },
            [this]() -> Explanation {
                return {"v = v_face   (the face nearest to the mark)", {Input::now("v_face", "v_on_faces", wake_face_)}};
            })
            .when(watched),
        probe_of("strouhal", "St", "",
                 "D/(U T), where T is the mean of the latest periods (at most 4) of the velocity in the wake")
            .formula(
                *this, "St = D / (U T)",
                {part("D = d L",
                      {Input::live("d", "", "diameter of the disc in units of L", [this] { return scene().obstacle; }), size}),
                 inflow, Input::live("T", "s", "mean of the latest periods of the wake's v", [this] { return *wake_.period(); })})
            .when([this] { return scene().readings.wake && wake_.period() && inflow != 0; }),
        probe_of("smoke_volume", "", "m²", "of all smoke, per metre of depth", [this] {
            return smoke_.sum() * dx() * dx();
        }).when([this] { return scene().drives.smoke; })};
}

// Leaves the divergence of each cell in divergence_now_.
Real NavierStokes::largest_divergence() const {
    divergence(*grid_, velocity_, divergence_now_);
    return divergence_now_.lpNorm<Eigen::Infinity>();
}

std::vector<std::string_view> NavierStokes::shown(std::vector<std::string_view> names) const {
    if (order != Order::lecture || !with_projection)
        std::ranges::replace(names, std::string_view("max_divergence"), std::string_view("divergence_left"));
    return names;
}

// What linear interpolation adds where the fluid crosses s cells per step, at the root mean square of the speed:
// s(1 − s)Δx²/(2Δt), with s the fraction of a cell.
Real NavierStokes::interpolation_viscosity() const {
    const Real cells = std::sqrt(2 * specific_energy()) * dt / dx();
    const Real s = cells - std::floor(cells);
    return s * (1 - s) * dx() * dx() / (2 * dt);
}

// Assumptions, what mends them, and laws.

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
            .otherwise("divergence left")
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
            .otherwise("large Courant number")
            .when([this] { return bool(with_advection); })
            .mended_by([this] { return fix_by(dt, rounded_down(4 * dx() / max_speed(velocity_))); }),
        assumption_of(
            "interpolation viscosity", "m²/s", [this] { return interpolation_viscosity(); }, [this] { return nu(); },
            "s(1 − s)Δx²/(2Δt) ≤ ν, s: fraction of a cell crossed per step",
            "linear interpolation smooths the flow more than its own viscosity does: vortices die too soon")
            .otherwise("smoothed by interpolation")
            .when([this, viscous] { return viscous() && advection == grid2d::Carrying::linear; })
            .mended_by(Fix{"MacCormack", {{"advection_scheme", "mac_cormack"}}}),
        assumption_of(
            "cell reynolds number", "", [this] { return max_speed(velocity_) * dx() / nu(); },
            [] { return largest_cell_reynolds; }, "max|u| Δx/ν ≤ 2",
            "boundary layers and the smallest vortices are thinner than a cell: what is seen is the grid's")
            .otherwise("details finer than a cell")
            .when(viscous)
            .mended_by([this] { return thicker_fluid(max_speed(velocity_) * dx() / largest_cell_reynolds * 1.2); }),
        assumption_of(
            "disc of cells", "", [] { return fewest_cells; }, [this] { return scene().obstacle * resolution.value(); },
            "8 ≤ D/Δx", "a disc of so few squares is no disc: its wake is that of a block")
            .otherwise("disc of few cells")
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
