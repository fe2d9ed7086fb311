#include "free_surface.h"

#include <pliant/text/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace pliant::free_surface {
namespace {

using std::numbers::pi;

constexpr Index most_cells = 256 * 256, most_iterations = 300;

const Registration<FreeSurface> registration{
    {.id = "fluids/free_surface",
     .title = "Free surface",
     .summary = "A liquid that falls, splashes and settles: p = 0 on its surface, walls and paddles that it slides along.",
     .demo_steps = 120}};

}  // namespace

FreeSurface::FreeSurface()
    : scene(*this,
            {.key = "scene",
             .help = "a column that falls, a standing wave, a drop that falls into a pool, or a paddle that makes waves",
             .effect = Effect::rebuild},
            {{"column", "falling column"}, {"wave", "standing wave"}, {"drop", "falling drop"}, {"paddle", "wave maker"}}),
      tank_width(*this, {.key = "tank_width",
                         .symbol = "W",
                         .unit = "m",
                         .help = "from wall to wall; Δx = W / n",
                         .initial = 1,
                         .useful = {0.2, 4},
                         .accepted = Interval{1e-6, 1e6},
                         .scale = Scale::log,
                         .effect = Effect::rebuild}),
      tank_height(*this, {.key = "tank_height",
                          .symbol = "H",
                          .unit = "m",
                          .help = "from floor to lid, rounded to whole cells",
                          .initial = 0.6,
                          .useful = {0.1, 2},
                          .accepted = Interval{1e-6, 1e6},
                          .scale = Scale::log,
                          .effect = Effect::rebuild}),
      column_width(*this, {.key = "column_width",
                           .symbol = "a",
                           .unit = "m",
                           .help = "of the column at the left wall; drag its corner",
                           .initial = 0.25,
                           .useful = {0.05, 0.9},
                           .accepted = Interval{0, 1e6},
                           .effect = Effect::rebuild,
                           .used = [this] { return scene == Pouring::column; }}),
      column_height(*this, {.key = "column_height",
                            .symbol = "h",
                            .unit = "m",
                            .help = "of the column at the left wall; drag its corner",
                            .initial = 0.5,
                            .useful = {0.05, 0.6},
                            .accepted = Interval{0, 1e6},
                            .effect = Effect::rebuild,
                            .used = [this] { return scene == Pouring::column; }}),
      depth(*this, {.key = "depth",
                    .symbol = "d",
                    .unit = "m",
                    .help = "of the liquid at rest",
                    .initial = 0.3,
                    .useful = {0.05, 0.5},
                    .accepted = Interval{0, 1e6},
                    .effect = Effect::rebuild,
                    .used = [this] { return scene != Pouring::column; }}),
      wave_height(*this, {.key = "wave_height",
                          .symbol = "A",
                          .unit = "m",
                          .help = "of the wave at the left wall above the level at rest; half a wave is as long as the tank",
                          .initial = 0.03,
                          .useful = {-0.1, 0.1},
                          .accepted = Interval{-1e6, 1e6},
                          .effect = Effect::rebuild,
                          .used = [this] { return scene == Pouring::wave; }}),
      drop_radius(*this, {.key = "drop_radius",
                          .symbol = "R",
                          .unit = "m",
                          .help = "of the drop, which starts halfway between the pool and the lid",
                          .initial = 0.08,
                          .useful = {0.02, 0.12},
                          .accepted = Interval{0, 1e6},
                          .effect = Effect::rebuild,
                          .used = [this] { return scene == Pouring::drop; }}),
      paddle_stroke(*this, {.key = "paddle_stroke",
                            .symbol = "S",
                            .unit = "m",
                            .help = "way of the paddle from one end to the other",
                            .initial = 0.08,
                            .useful = {0, 0.2},
                            .accepted = Interval{0, 1e6},
                            .effect = Effect::rebuild,
                            .used = [this] { return has_paddle(); }}),
      paddle_period(*this, {.key = "paddle_period",
                            .symbol = "T",
                            .unit = "s",
                            .help = "of the paddle, to and fro",
                            .initial = 0.8,
                            .useful = {0.3, 3},
                            .accepted = Interval{1e-6, 1e6},
                            .scale = Scale::log,
                            .effect = Effect::rebuild,
                            .used = [this] { return has_paddle() && paddle_stroke > 0; }}),
      resolution(*this, {.key = "resolution",
                         .symbol = "n",
                         .help = "cells along the width of the tank",
                         .initial = 80,
                         .useful = {16, 160},
                         .accepted = Interval{1, 256},
                         .effect = Effect::rebuild}),
      gravity(*this, {.key = "gravity",
                      .symbol = "g",
                      .unit = "m/s²",
                      .help = "downwards; the earth 9.81, the moon 1.62",
                      .initial = 9.81,
                      .useful = {0, 25},
                      .accepted = Interval{0, 1e6}}),
      dt(*this, {.key = "time_step",
                 .symbol = "Δt",
                 .unit = "s",
                 .help = "fixed; stable at any, accurate while the fastest liquid crosses a cell or two per step",
                 .initial = 0.004,
                 .useful = {5e-4, 0.05},
                 .accepted = Interval{0, 10, true},
                 .scale = Scale::log}),
      condition(
          *this,
          {.key = "surface_condition",
           .help = "p = 0 on the surface itself; in the middle of the first cell of air, off by up to a cell; or a mould of "
                   "u·n = 0 around the liquid",
           .effect = Effect::rebuild},
          {{"at_surface", "p = 0 on the surface"}, {"at_cell_centre", "p = 0 in the air cell"}, {"closed", "u·n = 0: a mould"}}),
      keep_volume(*this, {.key = "keep_volume",
                          .help = "shifts the surface after each step so that the volume stays; without it watch the gauge",
                          .initial = 1}),
      tolerance(*this, {.key = "tolerance",
                        .symbol = "τ",
                        .help = "the pressure solver stops when max|∇·u| ≤ τ max|∇·ũ|",
                        .initial = 1e-5,
                        .useful = {1e-8, 0.5},
                        .accepted = Interval{1e-12, 1, false, true},
                        .scale = Scale::log}) {
    declare_fields();
    declare_stages();
    declare_probes();
    declare_lines();
    declare_checks();
}

Index FreeSurface::rows() const {
    return std::max<Index>(1, static_cast<Index>(std::lround(std::min(tank_height / dx(), Real(1e9)))));
}

void FreeSurface::check() const {
    if (rows() > most_cells / resolution)
        throw Refused(
            "tank_height", tank_height, "m",
            fmt::format("at most {:.4g} m with tank_width = {:.4g} m and resolution = {}, which makes {} cells",
                        dx() * static_cast<Real>(most_cells / resolution), Real(tank_width), Index(resolution), most_cells));
    const auto fits = [](const Number& size, Real room, std::string_view wall) {
        if (size > room * (1 + 1e-12))
            throw Refused(size.info.key, size, "m", fmt::format("at most the {} of the tank, {:.6g} m", wall, room));
    };
    if (scene == Pouring::column) {
        fits(column_width, tank_width, "width");
        fits(column_height, tank_height, "height");
        return;
    }
    fits(depth, tank_height, "height");
    if (scene == Pouring::wave && depth + std::abs(wave_height) > tank_height * (1 + 1e-12))
        throw Refused("wave_height", wave_height, "m",
                      fmt::format("at most {:.4g} m up or down, so that the wave does not touch the lid", tank_height - depth));
    if (has_paddle() && condition == SurfaceCondition::closed)
        throw Refused(
            "surface_condition = closed cannot be used with scene = paddle: in a mould the liquid could not give way to the "
            "paddle. Accepted there: at_surface, at_cell_centre");
    if (has_paddle() && paddle_stroke > 0.3 * tank_width)
        throw Refused("paddle_stroke", paddle_stroke, "m",
                      fmt::format("at most {:.4g} m, so that the paddle stays in the left half of the tank", 0.3 * tank_width));
}

// Half of the plate's way to the left and to the right of a fifth of the tank.
Real FreeSurface::paddle_place(Real t) const {
    return 0.2 * tank_width - 0.5 * paddle_stroke * std::cos(2 * pi * t / paddle_period);
}

Real FreeSurface::paddle_speed(Real t) const {
    return 0.5 * paddle_stroke * (2 * pi / paddle_period) * std::sin(2 * pi * t / paddle_period);
}

Real FreeSurface::paddle_width() const { return std::max(0.02 * tank_width, 2 * dx()); }

std::vector<CellType> FreeSurface::solids() const {
    if (!has_paddle()) return {};
    const Index n = resolution;
    std::vector<CellType> types(static_cast<std::size_t>(n * rows()), CellType::fluid);
    for (Index c = 0; c < n * rows(); ++c) {
        const Real x = (static_cast<Real>(c % n) + 0.5) * dx();
        if (std::abs(x - paddle_place(time())) <= 0.5 * paddle_width()) types[static_cast<std::size_t>(c)] = CellType::solid;
    }
    return types;
}

Real FreeSurface::first_distance(const Vec<2>& x) const {
    const Real above = x[1] - depth;
    switch (scene) {
        case Pouring::column:
            return std::max(x[0] - column_width, x[1] - column_height);
        case Pouring::wave:
            return above - wave_height * std::cos(pi * x[0] / tank_width);
        case Pouring::drop:
            return std::min(above, (x - Vec<2>(0.5 * tank_width, 0.5 * (depth + tank_height))).norm() - drop_radius);
        case Pouring::paddle:
            return above;
    }
    return above;
}

void FreeSurface::reset() {
    StaggeredGridInfo<2> tank;
    tank.cells = {resolution, rows()};
    tank.dx = dx();
    elapsed_.setZero();
    tank.types = solids();
    if (has_paddle()) tank.solid_velocity = [this](const Vec<2>&) { return Vec<2>(paddle_speed(time()), 0); };
    liquid_ = std::make_unique<Liquid<2>>(
        std::move(tank),
        LiquidSettings{.condition = condition, .keep_volume = keep_volume, .projection = {tolerance, most_iterations}});
    liquid_->fill([this](const Vec<2>& x) { return first_distance(x); });
    first_volume_ = liquid_->volume();
    shift_ = 0;
    pressure_ = VecX::Zero(liquid_->grid().cells().size());
    divergence(liquid_->grid(), liquid_->velocity(), divergence_after_);
    divergence_before_ = divergence_after_;
    fields_of_flow_.reset(liquid_->grid(), liquid_->velocity());
}

// The corner of the column, or the crest of the wave.
std::optional<On> FreeSurface::can_pull() const {
    if (scene == Pouring::column || scene == Pouring::wave) return On::handle;
    return std::nullopt;
}

std::vector<std::pair<std::string, Real>> FreeSurface::dragged(const Pull& pull) const {
    if (scene == Pouring::wave)
        return {{"wave_height", std::clamp(pull.to[1] - depth, depth - tank_height, tank_height - depth)}};
    return {{"column_width", std::clamp(pull.to[0], Real(0), Real(tank_width))},
            {"column_height", std::clamp(pull.to[1], Real(0), Real(tank_height))}};
}

std::string FreeSurface::blow_up_hint() const {
    return fmt::format("The fastest liquid crosses {} cells per step: lower time_step below {}, or gravity",
                       format_quantity(liquid_speed() * dt / dx(), ""),
                       format_quantity(2 * dx() / std::max(liquid_speed(), Real(1e-300)), "s"));
}

std::optional<Fix> FreeSurface::fix(const Failure& failure) const {
    if (failure.field == "pressure") return Fix{"tolerance = 1e-4", {{"tolerance", "1e-4"}}};
    const Real step = rounded_down(2 * dx() / std::max(liquid_speed(), dx() / dt));
    return Fix{fmt::format("Δt = {}", format_quantity(step, "s")), {{"time_step", format_exact(step)}}};
}

std::vector<std::pair<std::string, std::string>> FreeSurface::finer() const {
    return {{"resolution", std::to_string(std::min<Index>(2 * resolution, 256))}, {"time_step", format_exact(dt / 2)}};
}

}  // namespace pliant::free_surface
