// What the lesson shows and measures: fields, probes and profiles.
#include "free_surface.h"

#include <pliant/fluids/diagnostics.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::free_surface {
namespace {

using std::numbers::pi;

constexpr Real largest_velocity = 1e9;  // m/s: beyond it the run is stopped

std::span<Real> numbers_of(VecX& values) { return {values.data(), static_cast<std::size_t>(values.size())}; }

}  // namespace

void FreeSurface::declare_fields() {
    state = {{"u_on_faces", "m/s", [this] { return numbers_of(liquid_->velocity()[0]); }},
             {"v_on_faces", "m/s", [this] { return numbers_of(liquid_->velocity()[1]); }},
             {"distance", "m", [this] { return numbers_of(liquid_->distance()); }},
             state_array("pressure", "m²/s²", pressure_),
             state_array("elapsed", "s", elapsed_)};
    Field velocity{.name = "velocity",
                   .symbol = "u",
                   .unit = "m/s",
                   .on = On::cell,
                   .rank = Rank::vector,
                   .components = 2,
                   .view = [this] { return flow::numbers(fields_of_flow_.centre_velocity()); },
                   .help = "at cell centres; in the air it continues that of the liquid",
                   .defined_by = {"u_on_faces", "v_on_faces"}};
    velocity.explain = [this](const Question& q) { return why_on_grid().cell_velocity(q.index, q.component); };
    Field speed{.name = "speed",
                .symbol = "|u|",
                .unit = "m/s",
                .on = On::cell,
                .view = [this] { return flow::numbers(fields_of_flow_.speed()); },
                .defined_by = {"velocity"}};
    speed.explain = [this](const Question& q) { return why_on_grid().speed(q.index); };
    Field pressure = scalar_field("pressure", "p", "m²/s²", On::cell, pressure_,
                                  "kinematic pressure p/ρ: times 1000 kg/m³ it is that of water in Pa; 0 on the surface");
    Field distance{.name = "distance",
                   .symbol = "φ",
                   .unit = "m",
                   .on = On::cell,
                   .view = [this] { return std::span<const Real>(numbers_of(liquid_->distance())); },
                   .help = "to the surface: below 0 in the liquid, above 0 in the air"};
    const auto on_faces = [this](int axis, std::string_view help) {
        return Field{.name = flow::face_field(axis),
                     .symbol = axis == 0 ? "u" : "v",
                     .unit = "m/s",
                     .on = axis == 0 ? On::x_face : On::y_face,
                     .view = [this, axis] { return std::span<const Real>(numbers_of(liquid_->velocity()[axis])); },
                     .help = help,
                     .bound = [] { return largest_velocity; }};
    };
    fields = {
        std::move(velocity),
        std::move(speed),
        std::move(pressure),
        std::move(distance),
        scalar_field("divergence_before", "∇·ũ", "1/s", On::cell, divergence_before_,
                     "in the liquid, of the velocity that enters the projection"),
        scalar_field("divergence_after", "∇·u", "1/s", On::cell, divergence_after_,
                     "in the liquid, of the velocity that the projection leaves; after a pass of its solver, that which the "
                     "pressure so far would leave"),
        on_faces(0, "x component of the velocity, where it is stored: on the upright faces of the cells"),
        on_faces(1, "y component of the velocity, where it is stored: on the level faces of the cells")};
}

// -------------------------------------------------------------------------------------------------------------- probes

void FreeSurface::declare_probes() {
    probes = {
        {.name = "front_position",
         .symbol = "x_f",
         .unit = "m",
         .help = "how far from the left wall the liquid reaches",
         .value = [this] { return front().place; },
         .explain = [this] { return why_front(); }},
        {.name = "column_height_at_wall",
         .symbol = "h_w",
         .unit = "m",
         .help = "height of the surface in the cells at the left wall; in the scene of the wave beside linear theory",
         .value = [this] { return height_in(0).place; },
         .exact = [this](Real t) { return linear_wave(0.5 * dx(), t); },
         .explain = [this] { return why_height_at_wall(); }},
        {.name = "volume",
         .symbol = "V",
         .unit = "m²",
         .help = "of the liquid per metre across the picture",
         .value = [this] { return liquid_->volume(); },
         .exact = [this](Real) { return std::optional(first_volume_); }},
        {.name = "pressure_offset",
         .symbol = "Δp",
         .unit = "m²/s²",
         .help = "pressure in the cell on the floor at the left wall, beyond g times its depth: 0 where the liquid is still, "
                 "undefined where p is not set to 0 above it: in a full tank, on a dry floor, in a mould",
         .value = [this]() -> std::optional<Real> {
             const auto still = depth_pressure(0);
             return still ? std::optional(pressure_[0] - *still) : std::nullopt;
         },
         .explain = [this] { return why_offset(); }},
        {.name = "kinetic_energy",
         .symbol = "E_k",
         .unit = "m⁴/s²",
         .help = "½ ∫ |u|² over the liquid; times its density it is the energy per metre across the picture",
         .value = [this] { return kinetic_energy(); }},
        {.name = "potential_energy",
         .symbol = "E_p",
         .unit = "m⁴/s²",
         .help = "g ∫ y over the liquid",
         .value = [this] { return potential_energy(); }},
        {.name = "max_divergence",
         .symbol = "max|∇·u|",
         .unit = "1/s",
         .help = "what the projection leaves in the liquid",
         .value = [this] { return divergence_after_.lpNorm<Eigen::Infinity>(); },
         .explain = [this] { return flow::largest("max|∇·u|", divergence_after_, "divergence_after"); }},
        {.name = "cfl",
         .symbol = "CFL",
         .help = "Courant number |u| Δt/Δx: cells that the fastest liquid crosses in a step",
         .value = [this] { return liquid_speed() * dt / dx(); }},
        {.name = "solver_iterations", .help = "of the pressure solver in the latest step", .value = [this] {
             return static_cast<Real>(liquid_->projection().iterations());
         }}};
}

// g times the depth of a cell at the left wall below the surface above it. Without a surface, and in a mould, where any constant
// may be added to p, a pressure has no level to count from.
std::optional<Real> FreeSurface::depth_pressure(Index row) const {
    const Crossing surface = height_in(0);
    if (surface.air < 0 || condition == SurfaceCondition::closed) return std::nullopt;
    return gravity * std::max(Real(0), surface.place - (static_cast<Real>(row) + 0.5) * dx());
}

Real FreeSurface::crossing_of(Index fluid, Index air) const {
    const VecX& phi = liquid_->distance();
    return phi[fluid] / (phi[fluid] - phi[air]);
}

// The rightmost crossing of the surface with a row of cell centres.
FreeSurface::Crossing FreeSurface::front() const {
    const VecX& phi = liquid_->distance();
    const Index n = resolution;
    Crossing furthest;
    for (Index j = 0; j < rows(); ++j)
        for (Index i = n - 1; i >= 0; --i) {
            const Index c = i + n * j;
            if (phi[c] >= 0) continue;
            const Index air = i + 1 < n ? c + 1 : -1;
            const Real place = air < 0 ? Real(tank_width) : (static_cast<Real>(i) + 0.5 + crossing_of(c, air)) * dx();
            if (furthest.fluid < 0 || place > furthest.place) furthest = {c, air, place};
            break;
        }
    return furthest;
}

// Where the liquid that stands on the floor ends.
FreeSurface::Crossing FreeSurface::height_in(Index column) const {
    const VecX& phi = liquid_->distance();
    const Index n = resolution;
    if (phi[column] >= 0) return {};
    for (Index j = 0; j + 1 < rows(); ++j) {
        const Index c = column + n * j;
        if (phi[c + n] >= 0) return {c, c + n, (static_cast<Real>(j) + 0.5 + crossing_of(c, c + n)) * dx()};
    }
    return {column + n * (rows() - 1), -1, tank_top()};
}

Real FreeSurface::liquid_speed() const {
    const VecX& phi = liquid_->distance();
    const VecX& speed = fields_of_flow_.speed();
    Real largest = 0;
    for (Index c = 0; c < phi.size(); ++c)
        if (phi[c] < 0) largest = std::max(largest, speed[c]);
    return largest;
}

Real FreeSurface::kinetic_energy() const {
    const VecX& phi = liquid_->distance();
    const VecX& speed = fields_of_flow_.speed();
    Real sum = 0;
    for (Index c = 0; c < phi.size(); ++c)
        if (phi[c] < 0) sum += speed[c] * speed[c];
    return 0.5 * sum * dx() * dx();
}

// Columns of cells that are filled up to where the surface crosses them; the rest as whole cells.
Real FreeSurface::potential_energy() const {
    const VecX& phi = liquid_->distance();
    const Index n = resolution;
    Real sum = 0;
    for (Index c = 0; c < phi.size(); ++c) {
        const Real filled = std::clamp(0.5 - phi[c] / dx(), Real(0), Real(1));
        sum += filled * (static_cast<Real>(c / n) + 0.5 * filled);
    }
    return gravity * sum * dx() * dx() * dx();
}

Real FreeSurface::wave_frequency() const {
    const Real k = pi / tank_width;
    return std::sqrt(gravity * k * std::tanh(k * depth));
}

std::optional<Real> FreeSurface::linear_wave(Real x, Real t) const {
    if (scene != Pouring::wave || std::abs(wave_height) > depth) return std::nullopt;
    return depth + wave_height * std::cos(pi * x / tank_width) * std::cos(wave_frequency() * t);
}

std::string_view FreeSurface::error_probe() const { return scene == Pouring::wave ? "column_height_at_wall" : "volume"; }

std::vector<std::string_view> FreeSurface::first_plots() const {
    if (scene == Pouring::column) return {"front_position", "pressure_at_wall", "volume"};
    return {"column_height_at_wall", "surface_height", "volume"};
}

std::vector<std::string_view> FreeSurface::key_numbers() const {
    if (scene == Pouring::column) return {"front_position", "column_height_at_wall", "volume"};
    return {"column_height_at_wall", "volume", "cfl"};
}

// ------------------------------------------------------------------------------------------------------------ profiles

void FreeSurface::declare_lines() {
    lines = {{.name = "surface_height",
              .unit = "m",
              .position_name = "x",
              .position_unit = "m",
              .help = "of the liquid that stands on the floor, over the width of the tank",
              .sample =
                  [this](Curve& curve) {
                      curve = {};
                      for (Index i = 0; i < resolution; ++i) {
                          curve.position.push_back((static_cast<Real>(i) + 0.5) * dx());
                          curve.value.push_back(height_in(i).place);
                      }
                  },
              .reference =
                  [this](Curve& curve) {
                      curve = {};
                      for (Index i = 0; i < resolution; ++i) {
                          const Real x = (static_cast<Real>(i) + 0.5) * dx();
                          const auto height = linear_wave(x, time());
                          if (!height) return;
                          curve.position.push_back(x);
                          curve.value.push_back(*height);
                      }
                  },
              .reference_name = "linear wave"},
             {.name = "pressure_at_wall",
              .unit = "m²/s²",
              .position_name = "y",
              .position_unit = "m",
              .help = "in the cells at the left wall, beside g times the depth, which holds where nothing is accelerated",
              .sample =
                  [this](Curve& curve) {
                      curve = {};
                      for (Index j = 0; j < rows(); ++j) {
                          curve.position.push_back((static_cast<Real>(j) + 0.5) * dx());
                          curve.value.push_back(pressure_[Index(resolution) * j]);
                      }
                  },
              .reference =
                  [this](Curve& curve) {
                      curve = {};
                      for (Index j = 0; j < rows(); ++j) {
                          const auto still = depth_pressure(j);
                          if (!still) return;
                          curve.position.push_back((static_cast<Real>(j) + 0.5) * dx());
                          curve.value.push_back(*still);
                      }
                  },
              .reference_name = "still liquid: g (h − y)"}};
}

}  // namespace pliant::free_surface
