// What the lesson shows and measures: fields and probes.
#include "navier_stokes.h"

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
              {.name = "divergence",
               .symbol = "∇·u",
               .unit = "1/s",
               .on = On::cell,
               .view = [this] { return largest_divergence(), flow::numbers(divergence_now_); },
               .help = "of the velocity as it stands now, behind any stage: what flows out of each cell, per area",
               .defined_by = {"u_on_faces", "v_on_faces"},
               .explain = [this](const Question& q) { return why_on_grid().divergence(q.index, Input::From::now); }},
              {.name = "divergence_before",
               .symbol = "∇·ũ",
               .unit = "1/s",
               .on = On::cell,
               .view = view_of(divergence_before_),
               .help = "of the velocity that enters the projection: what flows out of each cell, per area",
               .used = projected},
              {.name = "divergence_after",
               .symbol = "∇·u",
               .unit = "1/s",
               .on = On::cell,
               .view = view_of(divergence_after_),
               .help = "of the velocity that the projection leaves; after a pass of its solver, that which the pressure so far "
                       "would leave",
               .used = projected},
              {.name = "pressure",
               .symbol = "p",
               .unit = "m²/s²",
               .on = On::cell,
               .view = view_of(pressure_),
               .help = "kinematic pressure p/ρ: the lecture's Δt ∇²p = ∇·u has no ρ. Its mean is 0, since a closed box fixes p "
                       "up to a constant",
               .used = projected},
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
               .bound = [] { return largest_velocity; }},
              {.name = "smoke",
               .symbol = "s",
               .on = On::cell,
               .view = view_of(smoke_),
               .help = "how much of a cell is smoke, 1 where it is made; it is carried along and lifted by its warmth",
               .bound = [] { return 1 + 1e-9; },
               .used = [this] { return scene().drives.smoke; }}};
}

// -------------------------------------------------------------------------------------------------------------- probes

void NavierStokes::declare_probes() {
    const auto size_of = [this](const VecX& field) {
        return with_projection ? std::optional(field.lpNorm<Eigen::Infinity>()) : std::nullopt;
    };
    probes = {
        {.name = "kinetic_energy",
         .symbol = "e",
         .unit = "J/kg",
         .help = "½|u|² per mass, mean over the fluid; times ρ and the area it is the energy per metre of depth",
         .value = [this] { return specific_energy(); },
         .exact = [this](Real t) -> std::optional<Real> {
             if (!scene().readings.decay) return std::nullopt;
             const Real ahead = with_viscosity ? nu() * (t - time()) : Real{0};
             return initial_energy_ * std::exp(-16 * pi * pi * (viscous_time() + ahead) / (size * size));
         }},
        {.name = "max_divergence",
         .symbol = "max|∇·u|",
         .unit = "1/s",
         .help = "what the projection leaves",
         .value = [this, size_of] { return size_of(divergence_after_); },
         .explain = [this] { return flow::largest("max|∇·u|", divergence_after_, "divergence_after"); }},
        {.name = "max_divergence_before",
         .symbol = "max|∇·ũ|",
         .unit = "1/s",
         .help = "what the projection was given",
         .value = [this, size_of] { return size_of(divergence_before_); },
         .explain = [this] { return flow::largest("max|∇·ũ|", divergence_before_, "divergence_before"); }},
        {.name = "divergence_left",
         .symbol = "max|∇·u|",
         .unit = "1/s",
         .help = "of the velocity as it stands; at the end of a step in the lecture's order it is what the projection leaves",
         .value = [this] { return largest_divergence(); },
         .explain = [this] { return largest_divergence(), flow::largest("max|∇·u|", divergence_now_, "divergence"); }},
        {.name = "max_speed",
         .symbol = "max|u|",
         .unit = "m/s",
         .help = "largest component of the velocity on any face",
         .value = [this] { return pliant::max_speed(velocity_); },
         .explain = [this] { return why_max_speed(); }},
        {.name = "cfl",
         .symbol = "CFL",
         .help = "Courant number max|u| Δt/Δx: cells that the fastest fluid crosses in a step",
         .value = [this] { return courant_number(*grid_, velocity_, dt); },
         .explain = [this] { return why_on_grid().courant(velocity_); }},
        {.name = "solver_iterations",
         .help = "of the pressure solver in the latest step",
         .value = [this] { return projection_ ? static_cast<Real>(projection_->iterations()) : 0; }},
        {.name = "reynolds_number",
         .symbol = "Re",
         .help = "U L/ν: of the cavity with the lid's speed, of the vortex street with the disc's diameter and the inflow, "
                 "elsewhere with the fastest fluid",
         .value = [this] { return reynolds_number(); },
         .explain = [this] { return why_reynolds(); }},
        {.name = "table_difference",
         .unit = "m/s",
         .help = "largest difference on both centre lines from the table of the steady square cavity at Re = 100",
         .value = [this] { return size_of_difference(largest_from_table()); },
         .explain = [this] { return why_table_difference(); }},
        {.name = "effective_viscosity",
         .unit = "m²/s",
         .help = "viscosity that the decay of the Taylor–Green energy amounts to, −ln(e/e₀) L²/(16π²t); what exceeds ν is "
                 "the method's",
         .value = [this] { return effective_viscosity(); },
         .exact = [this](Real) { return effective_viscosity() ? std::optional(viscous_time() / time()) : std::nullopt; },
         .explain = [this] { return why_effective_viscosity(); }}};
}

void NavierStokes::declare_wake_probes() {
    const auto watched = [this](auto value) {
        return [this, value]() -> std::optional<Real> {
            if (!scene().readings.wake) return std::nullopt;
            return value();
        };
    };
    probes.insert(probes.end(),
                  {{.name = "profile_difference",
                    .unit = "m/s",
                    .help = "largest difference across the channel from the closed form at this time",
                    .value = [this] { return size_of_difference(largest_from_closed_form()); },
                    .explain = [this] { return why_profile_difference(); }},
                   {.name = "wake_velocity",
                    .symbol = "v",
                    .unit = "m/s",
                    .help = "across the stream, 2½ diameters behind the middle of the disc: it swings with the vortices",
                    .value = watched([this] { return wake_velocity(); }),
                    .explain =
                        [this] {
                            return Explanation{"v = v_face   (the face nearest to the mark)",
                                               {Input::now("v_face", "v_on_faces", wake_face_)}};
                        }},
                   {.name = "strouhal",
                    .symbol = "St",
                    .help = "D/(U T), where T is the mean of the latest periods (at most 4) of the velocity in the wake",
                    .value = watched([this] { return strouhal(); }),
                    .explain = [this] { return why_strouhal(); }},
                   {.name = "smoke_volume",
                    .unit = "m²",
                    .help = "of all smoke, per metre of depth",
                    .value = [this]() -> std::optional<Real> {
                        if (!scene().drives.smoke) return std::nullopt;
                        return smoke_.sum() * dx() * dx();
                    }}});
}

// Leaves the divergence of each cell in divergence_now_.
Real NavierStokes::largest_divergence() const {
    divergence(*grid_, velocity_, divergence_now_);
    return divergence_now_.lpNorm<Eigen::Infinity>();
}

std::optional<Real> NavierStokes::size_of_difference(const std::optional<Difference>& difference) {
    return difference ? std::optional(difference->size()) : std::nullopt;
}

std::vector<std::string_view> NavierStokes::shown(std::vector<std::string_view> names) const {
    if (order != Order::lecture || !with_projection)
        std::ranges::replace(names, std::string_view("max_divergence"), std::string_view("divergence_left"));
    return names;
}

Real NavierStokes::specific_energy() const {
    return pliant::kinetic_energy(*grid_, velocity_) / (grid_->cell_volume() * static_cast<Real>(grid_->fluid_cells()));
}

std::optional<Real> NavierStokes::reynolds_number() const {
    if (!with_viscosity || nu() == 0) return std::nullopt;
    const Real length = scene().reynolds_length;
    return length > 0 ? reference_speed() * length * size / nu() : pliant::max_speed(velocity_) * size / nu();
}

std::optional<Real> NavierStokes::effective_viscosity() const {
    const Real energy = specific_energy();
    if (!scene().readings.decay || time() == 0 || energy <= 0) return std::nullopt;
    return -std::log(energy / initial_energy_) * size * size / (16 * pi * pi * time());
}

// What linear interpolation adds where the fluid crosses s cells per step, at the root mean square of the speed:
// s(1 − s)Δx²/(2Δt), with s the fraction of a cell.
Real NavierStokes::interpolation_viscosity() const {
    const Real cells = std::sqrt(2 * specific_energy()) * dt / dx();
    const Real s = cells - std::floor(cells);
    return s * (1 - s) * dx() * dx() / (2 * dt);
}

Real NavierStokes::wake_velocity() const { return velocity_[1][wake_face_]; }

std::optional<Real> NavierStokes::strouhal() const {
    const auto period = wake_.period();
    if (!period || inflow == 0) return std::nullopt;
    return scene().obstacle * size / (inflow * *period);
}

}  // namespace pliant::navier_stokes
