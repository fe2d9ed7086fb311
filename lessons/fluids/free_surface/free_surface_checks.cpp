// Under which conditions the picture can be trusted, and what must not change.
#include "free_surface.h"

#include <pliant/text/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace pliant::free_surface {
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

// As slow as what the grid makes of a level surface.
bool FreeSurface::at_rest() const {
    constexpr Real part = 1e-3;  // of the speed of a fall from the lid
    return time() > 0 && starts_level() && liquid_speed() <= part * std::sqrt(2 * gravity * tank_top());
}

std::string FreeSurface::unrest() const {
    if (starts_level()) return "";
    return has_paddle() ? "the paddle makes waves without end"
                        : "the liquid has no viscosity, and what has begun to slosh goes on";
}

void FreeSurface::declare_checks() {
    assumptions = {
        {.name = "courant number",
         .value = [this] { return liquid_speed() * dt / dx(); },
         .limit = [] { return largest_courant; },
         .formula = "|u| Δt/Δx ≤ 3 in the liquid",
         .broken = "still stable, but thin sheets and drops are jumped over: the splash is smeared and late",
         .fix =
             [this] {
                 const Real step = rounded_down(0.8 * largest_courant * dx() / liquid_speed());
                 return std::optional(
                     Fix{fmt::format("Δt = {}", format_quantity(step, "s")), {{"time_step", format_exact(step)}}});
             }},
        {.name = "p = 0 at the surface",
         .unit = "cells",
         .value =
             [this] {
                 return condition == SurfaceCondition::at_surface ? Real{0} : condition == SurfaceCondition::closed ? 1.0 : 0.5;
             },
         .limit = [] { return Real{0}; },
         .formula = "p = 0 where φ = 0",
         .broken =
             "in the middle of an air cell p = 0 is off by half a cell on average, and the pressure by g Δx/2; in a mould the "
             "liquid cannot splash at all",
         .fix =
             [] {
                 return std::optional(Fix{"p = 0 on the surface", {{"surface_condition", "at_surface"}}});
             }},
        {.name = "cells across",
         .unit = "m",
         .value = [this] { return cells_of_a_column * dx(); },
         .limit =
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
         .formula = "6 Δx ≤ the smallest length of the scene",
         .broken = "what is thinner than a few cells is not resolved, and drops below a cell are lost",
         .fix =
             [this] {
                 const Index more = std::min<Index>(2 * resolution, 256);
                 return std::optional(Fix{fmt::format("n = {}", more), {{"resolution", std::to_string(more)}}});
             }},
        {.name = "small waves",
         .value = [this] { return pi / tank_width * std::abs(wave_height); },
         .limit = [] { return steepest_wave; },
         .formula = "k A ≤ 0.15, k = π/W",
         .broken = "linear theory, drawn beside the wave, holds for small waves: higher ones are slower and steeper",
         .used = [this] { return scene == Pouring::wave; },
         .fix =
             [this] {
                 const Real height = rounded_down(0.9 * steepest_wave * tank_width / pi);
                 return std::optional(
                     Fix{fmt::format("A = {}", format_quantity(height, "m")), {{"wave_height", format_exact(height)}}});
             }}};
    conserved = {{.probe = "volume",
                  .law = Law::constant,
                  .tolerance = [this] { return (keep_volume ? 1e-6 : largest_leak) * first_volume_ + 1e-12 * dx() * dx(); }},
                 {.probe = "max_divergence", .law = Law::zero, .tolerance = [this] {
                      const Real rounding = 1e-12 * (liquid_speed() + gravity * dt) / dx();
                      return tolerance * liquid_->projection().initial_divergence() * (1 + 1e-6) + rounding;
                  }}};
}

}  // namespace pliant::free_surface
