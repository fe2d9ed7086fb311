// What the lesson shows and measures: fields, probes and profiles.
#include "free_surface.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::free_surface {
namespace {

using std::numbers::pi;

constexpr Real largest_velocity = 1e9;  // m/s: beyond it the run is stopped

}  // namespace

void FreeSurface::declare_fields() {
    state = {{"u_on_faces", "m/s", [this] { return as_span(liquid_->velocity()[0]); }},
             {"v_on_faces", "m/s", [this] { return as_span(liquid_->velocity()[1]); }},
             {"distance", "m", [this] { return as_span(liquid_->distance()); }},
             state_array("pressure", "m²/s²", pressure_),
             state_array("elapsed", "s", elapsed_)};
    const auto velocity = [this]() -> const FaceField<2>& { return liquid_->velocity(); };
    const auto why = [this] { return why_on_grid(); };
    fields = {
        grid2d::velocity_field(fields_of_flow_, why, "at cell centres; in the air it continues that of the liquid"),
        grid2d::speed_field(fields_of_flow_, why),
        scalar_field("pressure", "p", "m²/s²", On::cell, pressure_,
                     "kinematic pressure p/ρ: times 1000 kg/m³ it is that of water in Pa; 0 on the surface")
            .of_both_signs(),
        scalar_field(
            "distance", "φ", "m", On::cell, [this] { return as_span(liquid_->distance()); },
            "to the surface: below 0 in the liquid, above 0 in the air")
            .of_both_signs(),
        scalar_field("divergence_before", "∇·ũ", "1/s", On::cell, divergence_before_,
                     "in the liquid, of the velocity that enters the projection")
            .of_both_signs(),
        scalar_field("divergence_after", "∇·u", "1/s", On::cell, divergence_after_,
                     "in the liquid, of the velocity that the projection leaves; after a pass of its solver, that which the "
                     "pressure so far would leave")
            .of_both_signs(),
        grid2d::stored_velocity(0, velocity, largest_velocity),
        grid2d::stored_velocity(1, velocity, largest_velocity)};
}

// -------------------------------------------------------------------------------------------------------------- probes

void FreeSurface::declare_probes() {
    probes = {probe_of(
                  "front_position", "x_f", "m", "how far from the left wall the liquid reaches", [this] { return front().place; },
                  [this] { return why_front(); }),
              probe_of(
                  "column_height_at_wall", "h_w", "m",
                  "height of the surface in the cells at the left wall; in the scene of the wave beside linear theory",
                  [this] { return height_in(0).place; }, [this] { return why_height_at_wall(); })
                  .exactly([this](Real t) { return linear_wave(0.5 * dx(), t); }),
              probe_of("volume", "V", "m²", "of the liquid per metre across the picture", [this] { return liquid_->volume(); })
                  .exactly([this](Real) { return std::optional(first_volume_); }),
              probe_of(
                  "pressure_offset", "Δp", "m²/s²",
                  "pressure in the cell on the floor at the left wall, beyond g times its depth: 0 where the liquid is still, "
                  "undefined where p is not set to 0 above it: in a full tank, on a dry floor, in a mould",
                  [this] { return pressure_[0] - *depth_pressure(0); },
                  [this]() -> Explanation {
                      return {"Δp = p − g max(h_w − ½ Δx, 0)",
                              {Input::now("p", "pressure", 0), gravity, Input::part("h_w", "m", why_height_at_wall()),
                               why_on_grid().dx()}};
                  })
                  .when([this] { return depth_pressure(0).has_value(); }),
              probe_of("kinetic_energy", "E_k", "m⁴/s²",
                       "½ ∫ |u|² over the liquid; times its density it is the energy per metre across the picture",
                       [this] { return kinetic_energy(); }),
              probe_of("potential_energy", "E_p", "m⁴/s²", "g ∫ y over the liquid", [this] { return potential_energy(); }),
              grid2d::largest_probe("max_divergence", "max|∇·u|", "1/s", "what the projection leaves in the liquid",
                                    divergence_after_, "divergence_after"),
              probe_of("cfl", "CFL", "", "Courant number |u| Δt/Δx: cells that the fastest liquid crosses in a step",
                       [this] { return liquid_speed() * dt / dx(); }),
              probe_of("solver_iterations", "", "", "of the pressure solver in the latest step",
                       [this] { return static_cast<Real>(liquid_->projection().iterations()); })};
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

// ------------------------------------------------------------------------------------------------------------ profiles

void FreeSurface::declare_lines() {
    lines = {line_of("surface_height", "m", "x", "m", "of the liquid that stands on the floor, over the width of the tank",
                     [this](Curve& curve) {
                         grid2d::sample_centres(curve, resolution, dx(), [this](Index i) { return height_in(i).place; });
                     })
                 .against("linear wave",
                          [this](Curve& curve) {
                              grid2d::sample_centres(curve, resolution, dx(), [this](Index i) {
                                  return linear_wave((static_cast<Real>(i) + 0.5) * dx(), time());
                              });
                          }),
             line_of("pressure_at_wall", "m²/s²", "y", "m",
                     "in the cells at the left wall, beside g times the depth, which holds where nothing is accelerated",
                     [this](Curve& curve) {
                         grid2d::sample_centres(curve, rows(), dx(), [this](Index j) { return pressure_[resolution * j]; });
                     })
                 .against("still liquid: g (h − y)", [this](Curve& curve) {
                     grid2d::sample_centres(curve, rows(), dx(), [this](Index j) { return depth_pressure(j); });
                 })};
}

// Under which conditions the picture can be trusted, and what must not change.

namespace {

using std::numbers::pi;

constexpr Real largest_courant = 3;
constexpr Real steepest_wave = 0.15;   // k A: beyond it the period depends on the height
constexpr Real largest_leak = 0.01;    // of the volume, where nothing keeps it
constexpr Real cells_of_a_column = 6;  // across the smallest length of the scene

}  // namespace

bool FreeSurface::starts_level() const {
    if (gravity == 0 || condition == SurfaceCondition::closed) return !has_paddle() || paddle_stroke == 0;
    switch (scene) {
        case Pouring::column:
            return column_width >= tank_width || column_width == 0 || column_height == 0;
        case Pouring::wave:
            return wave_height == 0;
        case Pouring::drop:
            return drop_radius == 0;
        case Pouring::paddle:
            return paddle_stroke == 0;
    }
    return false;
}

void FreeSurface::declare_checks() {
    assumptions = {
        assumption_of(
            "courant number", "", [this] { return liquid_speed() * dt / dx(); }, [] { return largest_courant; },
            "|u| Δt/Δx ≤ 3 in the liquid",
            "still stable, but thin sheets and drops are jumped over: the splash is smeared and late")
            .otherwise("large Courant number")
            .mended_by([this] { return fix_by(dt, rounded_down(0.8 * largest_courant * dx() / liquid_speed())); }),
        assumption_of(
            "p = 0 at the surface", "cells",
            [this] {
                return condition == SurfaceCondition::at_surface ? Real{0} : condition == SurfaceCondition::closed ? 1.0 : 0.5;
            },
            [] { return Real{0}; }, "p = 0 where φ = 0",
            "in the middle of an air cell p = 0 is off by half a cell on average, and the pressure by g Δx/2; in a mould the "
            "liquid cannot splash at all")
            .otherwise("p = 0 off the surface")
            .mended_by(Fix{"p = 0 on the surface", {{"surface_condition", "at_surface"}}}),
        assumption_of(
            "cells across", "m", [this] { return cells_of_a_column * dx(); },
            [this] {
                switch (scene) {
                    case Pouring::column:
                        return std::min<Real>(column_width, column_height);
                    case Pouring::drop:
                        return 2 * std::min<Real>(drop_radius, depth);
                    default:
                        return Real(depth);
                }
            },
            "6 Δx ≤ the smallest length of the scene",
            "what is thinner than a few cells is not resolved, and drops below a cell are lost")
            .otherwise("few cells across")
            .mended_by([this] { return fix_by(resolution, std::min(2 * resolution.value(), Real(256))); }),
        assumption_of(
            "small waves", "", [this] { return pi / tank_width * std::abs(wave_height); }, [] { return steepest_wave; },
            "k A ≤ 0.15, k = π/W",
            "linear theory, drawn beside the wave, holds for small waves: higher ones are slower and steeper")
            .otherwise("steep waves")
            .when([this] { return scene == Pouring::wave; })
            .mended_by([this] { return fix_by(wave_height, rounded_down(0.9 * steepest_wave * tank_width / pi)); })};
    conserved = {
        {"volume", Law::constant, [this] { return (keep_volume ? 1e-6 : largest_leak) * first_volume_ + 1e-12 * dx() * dx(); }},
        {"max_divergence", Law::zero, [this] {
             const Real rounding = 1e-12 * (liquid_speed() + gravity * dt) / dx();
             return tolerance * liquid_->projection().initial_divergence() * (1 + 1e-6) + rounding;
         }}};
}

}  // namespace pliant::free_surface
