// Under which conditions the picture can be trusted, and what must not change.
#include "free_surface.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

void FreeSurface::declare_checks() {
    assumptions = {
        assumption_of(
            "courant number", "", [this] { return liquid_speed() * dt / dx(); }, [] { return largest_courant; },
            "|u| Δt/Δx ≤ 3 in the liquid",
            "still stable, but thin sheets and drops are jumped over: the splash is smeared and late")
            .mended_by([this] { return fix_by(dt, rounded_down(0.8 * largest_courant * dx() / liquid_speed())); }),
        assumption_of(
            "p = 0 at the surface", "cells",
            [this] {
                return condition == SurfaceCondition::at_surface ? Real{0} : condition == SurfaceCondition::closed ? 1.0 : 0.5;
            },
            [] { return Real{0}; }, "p = 0 where φ = 0",
            "in the middle of an air cell p = 0 is off by half a cell on average, and the pressure by g Δx/2; in a mould the "
            "liquid cannot splash at all")
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
            .mended_by([this] { return fix_by(resolution, std::min(2 * resolution.value(), Real(256))); }),
        assumption_of(
            "small waves", "", [this] { return pi / tank_width * std::abs(wave_height); }, [] { return steepest_wave; },
            "k A ≤ 0.15, k = π/W",
            "linear theory, drawn beside the wave, holds for small waves: higher ones are slower and steeper")
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
