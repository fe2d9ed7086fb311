#include "free_surface.h"

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

}  // namespace pliant::free_surface
