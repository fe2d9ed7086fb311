// A liquid with a free surface in a tank, one time step in stages.
#pragma once
#include "fluids/flow/advection_why.h"
#include "fluids/flow/flow_fields.h"
#include "fluids/flow/grid_why.h"

#include <pliant/fluids/liquid.h>
#include <pliant/lesson/registry.h>

#include <memory>
#include <optional>

namespace pliant::free_surface {

enum class Pouring { column, wave, drop, paddle };

// A vertical plane through the tank, from the left wall (x = 0) and the floor (y = 0). Walls and the paddle let the liquid slide.
class FreeSurface final : public Lesson {
public:
    FreeSurface();

    int dimension() const override { return 2; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return dt; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& picture) const override;
    std::optional<On> can_pull() const override;
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override;
    ColourBy first_colours() const override { return {"speed"}; }
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override;

private:
    Choice<Pouring> scene;
    Number tank_width, tank_height, column_width, column_height, depth, wave_height, drop_radius, paddle_stroke, paddle_period;
    Whole resolution;
    Number gravity, dt;
    Choice<SurfaceCondition> condition;
    Switch keep_volume;
    Number tolerance;

    void declare_fields();
    void declare_stages();
    void declare_probes();
    void declare_lines();
    void declare_checks();

    // --- the tank (free_surface.cpp) ---
    Real dx() const { return tank_width / static_cast<Real>(Index(resolution)); }
    Index rows() const;  // cells along the height of the tank, rounded
    Real tank_top() const { return static_cast<Real>(rows()) * dx(); }
    Real time() const { return elapsed_[0]; }
    Real first_distance(const Vec<2>& x) const;  // m, of the liquid at the start
    bool has_paddle() const { return scene == Pouring::paddle; }
    Real paddle_place(Real t) const;  // of its middle, m
    Real paddle_speed(Real t) const;  // m/s
    Real paddle_width() const;        // m
    bool starts_level() const;        // does the liquid lie still at the start?
    std::vector<CellType> solids() const;

    // --- the stages (free_surface_stages.cpp) ---
    void follow_state();
    void move_solids();
    void external_forces();
    void advect();
    void begin_projection();
    void projection_pass();
    void end_projection();
    void continue_velocity();
    void move_surface();
    void redistance();
    void finish();

    // --- how the numbers came about (free_surface_why.cpp) ---
    flow::GridWhy why_on_grid() const;
    Explanation kept(int axis, Index face) const;
    Explanation why_solid(int axis, Index face) const;
    Explanation why_force(int axis, Index face) const;
    Explanation why_advected(int axis, Index face) const;
    std::optional<Explanation> why_projection(const Question& q) const;
    Explanation why_carried(Index cell) const;
    Explanation why_continued(int axis, Index face) const;
    Explanation why_redistanced(Index cell) const;
    Explanation why_slope(Index cell, int axis, std::string symbol) const;
    Explanation why_front() const;
    Explanation why_height_at_wall() const;
    Explanation why_offset() const;

    // --- what is measured (free_surface_readings.cpp) ---
    struct Crossing {
        Index fluid = -1, air = -1;  // cells; -1 where a wall is reached or nothing is wet
        Real place = 0;              // m
    };
    Real crossing_of(Index fluid, Index air) const;  // part of the way between the centres
    Crossing front() const;
    Crossing height_in(Index column) const;
    std::optional<Real> depth_pressure(Index row) const;  // m²/s²
    Real liquid_speed() const;                            // largest in the liquid, m/s
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
    flow::FlowFields fields_of_flow_;
};

}  // namespace pliant::free_surface
