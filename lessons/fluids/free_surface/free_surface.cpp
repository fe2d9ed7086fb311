// The tank, the start, and the stages of a step.
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

constexpr Index most_cells = 256 * 256, most_iterations = 300;

const Registration<FreeSurface> registration{
    {.id = "fluids/free_surface",
     .title = "Free surface",
     .summary = "A liquid that falls, splashes and settles: p = 0 on its surface, walls and paddles that it slides along.",
     .demo_steps = 120}};

}  // namespace

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

std::vector<std::pair<std::string, Real>> FreeSurface::dragged(const Pull& pull) const {
    if (scene == Pouring::wave)
        return {{"wave_height", std::clamp(pull.to[1] - depth, depth - tank_height, tank_height - depth)}};
    return {{"column_width", std::clamp(pull.to[0], Real(0), Real(tank_width))},
            {"column_height", std::clamp(pull.to[1], Real(0), Real(tank_height))}};
}

void FreeSurface::declare_stages() {
    using grid2d::axis_of;
    formula_symbols = grid2d::symbols_and({{"s", "m"}});
    stages = {stage_of("moving_solids", "u·n = u_paddle·n on the paddle; along it the liquid is free",
                       "Utrecht slides, boundary: u·n = u_body·n; Bridson2007 §4.2",
                       [this] {
                           follow_state();
                           fields_of_flow_.renew();
                       })
                  .done_in("core/pliant/fluids/liquid.cpp: set_solids, classify")
                  .maps({}, {"u_on_faces", "v_on_faces"})
                  .when([this] { return has_paddle(); })
                  .because([this](const Question& q) { return why_solid(axis_of(q.field), q.index); }),
              stage_of("external_forces", "ũ ← u + Δt g", "Utrecht slides, Navier–Stokes equations; Stam1999 §2.2",
                       [this] {
                           if (!has_paddle()) follow_state();
                           liquid_->add_force({0, -gravity}, dt);
                           fields_of_flow_.renew();
                       })
                  .done_in("core/pliant/fluids/liquid.cpp: add_force")
                  .maps({"velocity"}, {"u_on_faces", "v_on_faces"})
                  .because([this](const Question& q) { return why_force(axis_of(q.field), q.index); }),
              stage_of("advection", "ũ(x) ← ũ(x − Δt ũ(x − ½Δt ũ(x)))", "semi-Lagrangian: Stam1999 §2.2; Bridson2007 §3",
                       [this] {
                           liquid_->advect(dt);
                           fields_of_flow_.renew();
                       })
                  .done_in("core/pliant/fluids/advection.cpp: trace_row, interpolate_row")
                  .maps({"velocity"}, {"u_on_faces", "v_on_faces"})
                  .because([this](const Question& q) { return why_advected(axis_of(q.field), q.index); }),
              stage_of("projection", "Δt ∇²p = ∇·ũ,   p = 0 on the surface,   u ← ũ − Δt ∇p",
                       "Utrecht slides, pressure on boundary nodes; Chorin1968; Gibou2002 §2; Bridson2007 §4.3",
                       [this] { projection_pass(); })
                  .done_in("core/pliant/fluids/pressure_solve.cpp: iterate; "
                           "core/pliant/fluids/pressure_gradient.cpp: subtract_gradient")
                  .maps({"velocity", "pressure", "distance"},
                        {"divergence_before", "pressure", "divergence_after", "u_on_faces", "v_on_faces"})
                  .repeats([this] { return !liquid_->projection().converged(); }, [this] { begin_projection(); },
                           [this] { end_projection(); })
                  .because([this](const Question& q) { return why_projection(q); }),
              stage_of("continuation", "in the air u is the mean of its neighbours nearer to the liquid", "Bridson2007",
                       [this] {
                           liquid_->continue_velocity();
                           fields_of_flow_.renew();
                       })
                  .done_in("core/pliant/fluids/extrapolation.cpp: fill")
                  .maps({"velocity"}, {"u_on_faces", "v_on_faces"})
                  .because([this](const Question& q) { return why_continued(axis_of(q.field), q.index); }),
              stage_of("surface", "φ(x) ← φ(x − Δt u(x − ½Δt u(x)))", "level set: OsherSethian1988; Bridson2007 §6",
                       [this] { liquid_->advect_surface(dt); })
                  .done_in("core/pliant/fluids/advection.cpp: carry")
                  .maps({"velocity", "distance"}, {"distance"})
                  .because([this](const Question& q) {
                      const LevelSet<2>& surface = liquid_->surface();
                      return grid2d::AdvectionWhy(surface.box(), surface.advection(), dt, dt).quantity("distance", q.index);
                  }),
              stage_of("redistancing", "|∇φ| = 1, with the surface φ = 0 where it is",
                       "Zhao2005; beside the surface: RussoSmereka2000 §3", [this] { liquid_->redistance(); })
                  .done_in("core/pliant/fluids/level_set.cpp: redistance, distance_from")
                  .maps({"distance"}, {"distance"})
                  .because([this](const Question& q) { return why_redistanced(q.index); }),
              stage_of("volume", "φ ← φ − s, with s such that V(φ) is the volume at the start",
                       "bisection; the volume of cells: ScardovelliZaleski2000 §2",
                       [this] {
                           liquid_->kept_volume() = first_volume_;
                           shift_ = keep_volume ? liquid_->restore_volume() : 0;
                           elapsed_ += Real(dt);
                       })
                  .done_in("core/pliant/fluids/level_set.cpp: shift_to_volume")
                  .maps({"distance"}, {"distance"})
                  .because([this](const Question& q) {
                      return Explanation{"φ′ = φ − s",
                                         {Input::before("φ", "distance", q.index),
                                          Input::constant("s", shift_, "m", "way by which all of the surface was shifted")}};
                  })};
}

void FreeSurface::begin_projection() {
    divergence(liquid_->grid(), liquid_->velocity(), divergence_before_);
    PressureProjection<2>& projection = liquid_->projection();
    ProjectionSettings settings = projection.settings();
    settings.tolerance = tolerance;
    projection.set(settings);
    projection.pressure() = pressure_;
    liquid_->begin_projection(dt);
}

void FreeSurface::projection_pass() {
    PressureProjection<2>& projection = liquid_->projection();
    projection.iterate();
    pressure_ = projection.pressure();
    // The residual of the solver is the divergence that this pressure leaves.
    divergence_after_ = -dt / (dx() * dx()) * projection.residual();
}

}  // namespace pliant::free_surface
