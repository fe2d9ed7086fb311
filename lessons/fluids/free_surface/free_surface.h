// A liquid with a free surface in a tank, one time step in stages.
#pragma once
#include "kits/grid2d/advection_why.h"
#include "kits/grid2d/flow_readings.h"

#include <pliant/fluids/liquid.h>
#include <pliant/lesson/registry.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace pliant::free_surface {

enum class Pouring { column, wave, drop, paddle };

// A vertical plane through the tank, from the left wall (x = 0) and the floor (y = 0). Walls and the paddle let the liquid slide.
struct FreeSurface final : Lesson {
    FreeSurface() { declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks(); }

    int dimension() const override { return 2; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return dt; }
    // As slow as what the grid makes of a level surface.
    bool at_rest() const override {
        constexpr Real part = 1e-3;  // of the speed of a fall from the lid
        return time() > 0 && starts_level() && liquid_speed() <= part * std::sqrt(2 * gravity * tank_top());
    }
    std::string unrest() const override {
        if (starts_level()) return "";
        return has_paddle() ? "the paddle makes waves without end"
                            : "the liquid has no viscosity, and what has begun to slosh goes on";
    }
    void draw(Scene& picture) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    // The corner of the column, or the crest of the wave.
    std::optional<On> can_pull() const override {
        if (scene == Pouring::column || scene == Pouring::wave) return On::handle;
        return std::nullopt;
    }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override {
        return fmt::format("The fastest liquid crosses {} cells per step: lower the time step below {}, or gravity",
                           format_quantity(liquid_speed() * dt / dx(), ""),
                           format_quantity(2 * dx() / std::max(liquid_speed(), Real(1e-300)), "s"));
    }
    std::optional<Fix> fix(const Failure& failure) const override {
        if (failure.field == "pressure") return Fix{"a tolerance of 10⁻⁴", {{"tolerance", "1e-4"}}};
        return fix_by(dt, rounded_down(2 * dx() / std::max(liquid_speed(), dx() / dt)));
    }
    std::vector<std::pair<std::string, std::string>> finer() const override {
        return {{"resolution", std::to_string(std::min<Index>(2 * resolution, 256))}, {"time_step", format_exact(dt / 2)}};
    }
    std::string_view error_probe() const override { return scene == Pouring::wave ? "column_height_at_wall" : "volume"; }
    ColourBy first_colours() const override { return {"speed"}; }
    std::vector<Group> first_groups() const override { return {Group::scene, Group::method, Group::start}; }
    std::vector<std::string_view> first_plots() const override {
        if (scene == Pouring::column) return {"front_position", "pressure_at_wall", "volume"};
        return {"column_height_at_wall", "surface_height", "volume"};
    }
    std::vector<std::string_view> key_numbers() const override {
        if (scene == Pouring::column) return {"front_position", "column_height_at_wall", "volume"};
        return {"column_height_at_wall", "volume", "cfl"};
    }

    Choice<Pouring> scene{
        *this,
        setting_of("scene", "a column that falls, a standing wave, a drop that falls into a pool, or a paddle that makes waves")
            .in(Group::scene)
            .rebuilds(),
        {{"column", "falling column"}, {"wave", "standing wave"}, {"drop", "falling drop"}, {"paddle", "wave maker"}}};
    Number tank_width{*this, log_quantity("tank_width", "W", "m", 1, {0.2, 4}, {1e-6, 1e6}, "from wall to wall; Δx = W / n")
                                 .in(Group::shape)
                                 .rebuilds()};
    Number tank_height{
        *this, log_quantity("tank_height", "H", "m", 0.6, {0.1, 2}, {1e-6, 1e6}, "from floor to lid, rounded to whole cells")
                   .in(Group::shape)
                   .rebuilds()};
    Number column_width{
        *this,
        quantity("column_width", "a", "m", 0.25, {0.05, 0.9}, {0, 1e6}, "of the column at the left wall; drag its corner")
            .in(Group::start)
            .rebuilds(),
        [this] { return scene == Pouring::column; }};
    Number column_height{
        *this,
        quantity("column_height", "h", "m", 0.5, {0.05, 0.6}, {0, 1e6}, "of the column at the left wall; drag its corner")
            .in(Group::start)
            .rebuilds(),
        [this] { return scene == Pouring::column; }};
    Number depth{*this,
                 quantity("depth", "d", "m", 0.3, {0.05, 0.5}, {0, 1e6}, "of the liquid at rest").in(Group::start).rebuilds(),
                 [this] { return scene != Pouring::column; }};
    Number wave_height{*this,
                       quantity("wave_height", "A", "m", 0.03, {-0.1, 0.1}, {-1e6, 1e6},
                                "of the wave at the left wall above the level at rest; half a wave is as long as the tank")
                           .in(Group::start)
                           .rebuilds(),
                       [this] { return scene == Pouring::wave; }};
    Number drop_radius{*this,
                       quantity("drop_radius", "R", "m", 0.08, {0.02, 0.12}, {0, 1e6},
                                "of the drop, which starts halfway between the pool and the lid")
                           .in(Group::start)
                           .rebuilds(),
                       [this] { return scene == Pouring::drop; }};
    Number paddle_stroke{
        *this,
        quantity("paddle_stroke", "S", "m", 0.08, {0, 0.2}, {0, 1e6}, "way of the paddle from one end to the other")
            .in(Group::forces)
            .rebuilds(),
        [this] { return has_paddle(); }};
    Number paddle_period{*this,
                         log_quantity("paddle_period", "T", "s", 0.8, {0.3, 3}, {1e-6, 1e6}, "of the paddle, to and fro")
                             .in(Group::forces)
                             .rebuilds(),
                         [this] { return has_paddle() && paddle_stroke > 0; }};
    Whole resolution{*this, quantity("resolution", "n", "", 80, {16, 160}, {1, 256}, "cells along the width of the tank")
                                .in(Group::shape)
                                .rebuilds()};
    Number gravity{
        *this,
        quantity("gravity", "g", "m/s²", 9.81, {0, 25}, {0, 1e6}, "downwards; the earth 9.81, the moon 1.62").in(Group::forces)};
    Number dt{*this, log_quantity("time_step", "Δt", "s", 0.004, {5e-4, 0.05}, {0, 10, true},
                                  "fixed; stable at any, accurate while the fastest liquid crosses a cell or two per step")
                         .in(Group::method)};
    Choice<SurfaceCondition> condition{
        *this,
        setting_of("surface_condition",
                   "p = 0 on the surface itself; in the middle of the first cell of air, off by up to a cell; or a mould of "
                   "u·n = 0 around the liquid")
            .in(Group::method)
            .rebuilds(),
        {{"at_surface", "p = 0 on the surface"}, {"at_cell_centre", "p = 0 in the air cell"}, {"closed", "u·n = 0: a mould"}}};
    Switch keep_volume{
        *this,
        setting_of("keep_volume", "shifts the surface after each step so that the volume stays; without it watch the gauge", 1)
            .in(Group::method)};
    Number tolerance{*this, log_quantity("tolerance", "τ", "", 1e-5, {1e-8, 0.5}, {1e-12, 1, false, true},
                                         "the pressure solver stops when max|∇·u| ≤ τ max|∇·ũ|")
                                .in(Group::solver)};

    void declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks();

    // --- the tank (free_surface.cpp) ---
    Real dx() const { return tank_width / resolution.value(); }
    // Cells along the height of the tank, rounded.
    Index rows() const { return std::max<Index>(1, static_cast<Index>(std::lround(std::min(tank_height / dx(), Real(1e9))))); }
    Real tank_top() const { return static_cast<Real>(rows()) * dx(); }
    Real time() const { return elapsed_[0]; }
    Real first_distance(const Vec<2>& x) const;  // m, of the liquid at the start
    bool has_paddle() const { return scene == Pouring::paddle; }
    Real paddle_place(Real t) const;                                             // of its middle, m
    Real paddle_speed(Real t) const;                                             // m/s
    Real paddle_width() const { return std::max(0.02 * tank_width, 2 * dx()); }  // m
    bool starts_level() const;                                                   // does the liquid lie still at the start?
    std::vector<CellType> solids() const;

    // --- the stages (free_surface.cpp) ---
    // The state may have been put back to another time: what is liquid follows from it. The paddle is where it is now.
    void follow_state() { liquid_->set_solids(solids()); }
    void begin_projection();
    void projection_pass();
    void end_projection() {
        liquid_->end_projection();
        divergence(liquid_->grid(), liquid_->velocity(), divergence_after_);
        fields_of_flow_.renew();
    }

    struct Crossing {
        Index fluid = -1, air = -1;  // cells; -1 where a wall is reached or nothing is wet
        Real place = 0;              // m
    };

    // --- how the numbers came about (free_surface_why.cpp) ---
    grid2d::GridWhy why_on_grid() const {
        return {liquid_->grid(), dt, {&liquid_->distance(), condition == SurfaceCondition::at_surface}};
    }
    Explanation kept(int axis, Index face) const;
    Explanation why_solid(int axis, Index face) const;
    Explanation why_force(int axis, Index face) const;
    Explanation why_advected(int axis, Index face) const {
        if (why_on_grid().closed(axis, face)) return kept(axis, face);
        return grid2d::AdvectionWhy(liquid_->grid(), liquid_->advection(), dt, dt).velocity(axis, face);
    }
    std::optional<Explanation> why_projection(const Question& q) const;
    Explanation why_continued(int axis, Index face) const;
    Explanation why_redistanced(Index cell) const;
    Explanation why_slope(Index cell, int axis, std::string symbol) const;
    Explanation at_crossing(const std::string& symbol, const std::string& meaning, const Crossing& at, Index along) const;
    Explanation why_front() const;
    Explanation why_height_at_wall() const;

    // --- what is measured (free_surface_readings.cpp) ---
    // Part of the way between the centres.
    Real crossing_of(Index fluid, Index air) const {
        return liquid_->distance()[fluid] / (liquid_->distance()[fluid] - liquid_->distance()[air]);
    }
    Crossing front() const;
    Crossing height_in(Index column) const;
    // In m²/s²: g times the depth of a cell at the left wall below the surface above it. Without a surface, and in a mould, where
    // any constant may be added to p, a pressure has no level to count from.
    std::optional<Real> depth_pressure(Index row) const {
        const Crossing surface = height_in(0);
        if (surface.air < 0 || condition == SurfaceCondition::closed) return std::nullopt;
        return gravity * std::max(Real(0), surface.place - (static_cast<Real>(row) + 0.5) * dx());
    }
    Real liquid_speed() const;  // largest in the liquid, m/s
    Real kinetic_energy() const;
    Real potential_energy() const;
    Real wave_frequency() const;  // ω of the linear wave, 1/s
    std::optional<Real> linear_wave(Real x, Real t) const;

    // --- the picture (free_surface_picture.cpp) ---
    Real arrow_speed() const;  // m/s
    void draw_liquid(Scene& picture) const;
    void draw_tank(Scene& picture) const;
    void draw_start(Scene& picture) const;
    void draw_gauge(Scene& picture) const;
    void write_notes(Scene& picture) const;

    std::unique_ptr<Liquid<2>> liquid_;
    // What defines now, beside the velocity and the distance of the liquid: the last pressure [m²/s²] and the time [s].
    VecX pressure_;
    Eigen::Array<Real, 1, 1> elapsed_ = Eigen::Array<Real, 1, 1>::Zero();
    VecX divergence_before_, divergence_after_;  // 1/s
    Real first_volume_ = 0;                      // m²
    Real shift_ = 0;                             // of the surface in the latest step, m
    FlowFields fields_of_flow_;
};

}  // namespace pliant::free_surface
