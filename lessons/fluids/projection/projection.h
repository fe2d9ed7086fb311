// Any velocity in, its divergence, the pressure pass by pass, a velocity without divergence out.
#pragma once
#include "domain.h"
#include "fluids/flow/grid_why.h"
#include "given_field.h"
#include "solver_histories.h"

#include <pliant/fluids/collocated.h>
#include <pliant/fluids/helmholtz.h>
#include <pliant/lesson/registry.h>

#include <deque>
#include <map>
#include <memory>

namespace pliant::projection {

enum class Arrangement { staggered, collocated };
enum class Boundary { box, periodic };

// A velocity that a person draws: a push about a place.
struct DrawnArrow {
    DrawnArrow(Lesson& owner, std::size_t which, std::function<bool()> used);
    Vec<2> place() const { return {x, y}; }
    Vec<2> velocity() const { return {u, v}; }
    Number x, y, u, v;
};
inline constexpr std::size_t arrow_count = 3;
inline constexpr Real drawn_radius = 0.11;  // m
inline constexpr Real drawn_scale = 0.15;   // m in the picture per m/s

// The unit square, 1 m by 1 m. A static lesson: one step is one projection.
class Projection final : public Lesson {
public:
    Projection();

    int dimension() const override { return 2; }
    void reset() override;
    Real time_step() const override { return 0; }
    bool at_rest() const override { return tally_[done] != 0; }
    void draw(Scene& scene) const override;
    std::optional<On> can_pull() const override { return On::handle; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    ColourBy first_colours() const override { return {staggered() ? "pressure" : "velocity", -1}; }
    std::vector<std::string_view> first_plots() const override { return {"residual"}; }
    std::vector<std::string_view> key_numbers() const override {
        return {"max_divergence_before", "max_divergence", "iterations"};
    }

private:
    Choice<Given> given;
    Whole resolution;
    Choice<Arrangement> arrangement;
    Choice<Boundary> boundary;
    Choice<Obstacle> obstacle;
    Choice<PressurePreconditioner> solver;
    Number tolerance;
    Whole max_iterations;
    Number dt, speed, outflow, disturbance;
    Whole seed;
    Number cell_x, cell_y;
    std::deque<DrawnArrow> drawn;

    enum Tally : Index { done, projected, passes, initial, energy_given, overlap, tally_count };
    enum Handle : Index { cell_handle, first_place, first_tip = first_place + Index(arrow_count) };

    void declare_fields();
    void declare_state();
    void declare_stages();
    void declare_probes();
    void declare_lines();
    void declare_checks();

    // --- the stages ---
    void give();
    void take_divergence();
    void begin_pressure();
    void pressure_pass();
    void disturb();
    void project();
    void split();

    bool staggered() const { return arrangement == Arrangement::staggered || given == Given::through_flow; }
    bool periodic() const { return boundary == Boundary::periodic && given != Given::through_flow; }
    bool walls_move() const { return given == Given::through_flow; }
    Real dx() const { return Real(1) / static_cast<Real>(Index(resolution)); }
    Obstacle solids() const { return staggered() ? Obstacle(obstacle) : Obstacle::none; }
    ProjectionSettings settings() const { return {tolerance, max_iterations, solver}; }
    GivenField given_field() const;
    Real parity(Index cell) const;  // ±1 in turn
    void renew_centre();
    Points<2> pressure_gradient() const;  // Δt ∇p at cell centres, m/s

    // --- what is measured (projection_readings.cpp) ---
    Real specific_energy() const;  // J/kg
    Real fluid_area() const;       // m²
    Index selected_cell() const;
    Index invisible_count() const;
    Real net_inflow() const;  // m²/s
    void sample_history(Curve& curve, PressurePreconditioner which, Index most) const;

    // --- how the numbers came about (projection_why.cpp, projection_why_collocated.cpp) ---
    flow::GridWhy grid_why() const { return {*grid_, Input::of(dt)}; }
    Explanation why_given(const Question& q) const;
    Explanation why_divergence(Index cell, Input::From from) const;
    std::optional<Explanation> why_pressure_pass(const Question& q) const;
    Explanation why_disturbed(Index cell) const;
    Explanation why_projected(const Question& q) const;
    Explanation why_part(const Question& q) const;
    Explanation why_face_gradient(const std::string& left, int axis, Index cell, int side) const;
    Explanation why_velocity(const Question& q) const;
    Explanation why_energy() const;
    // Of the collocated grid.
    std::map<Index, Real> wide_row(Index cell) const;  // of 4Δx² ∇·∇
    Explanation why_central_divergence(Index cell, Input::From from) const;
    Explanation why_central_pressure(Index cell) const;
    Explanation why_central_remaining(Index cell) const;
    Explanation why_central_projected(int axis, Index cell) const;
    Explanation why_central_gradient(int axis, Index cell) const;

    // --- the picture (projection_picture.cpp, projection_zoom.cpp) ---
    struct Arrows {
        Points<2> vectors;
        Real sign;
        Ink ink;
        std::string_view name;
    };
    Arrows arrows_for(std::string_view field) const;
    void draw_arrows(Scene& scene) const;
    void draw_walls(Scene& scene) const;
    void draw_handles(Scene& scene) const;
    void draw_zoom(Scene& scene) const;
    struct Beside {
        std::array<Real, 4> u;  // left, right, below, above: what the divergence of the selected cell takes
        Real divergence;
    };
    Beside beside_selected() const;
    std::string selected_sum() const;
    void zoom_cells(Scene& scene) const;
    void zoom_velocity(Scene& scene) const;
    void write_notes(Scene& scene) const;

    std::unique_ptr<StaggeredGrid<2>> grid_;
    std::unique_ptr<PressureProjection<2>> projection_;
    std::unique_ptr<CollocatedProjection<2>> central_projection_;
    GivenField field_;
    mutable SolverHistories histories_;

    FaceField<2> velocity_;            // m/s, on the faces of the staggered grid
    FaceField<2> tentative_;           // what give() made of it
    AxisArrays<2> central_;            // m/s, in the cells of the collocated grid
    Points<2> centre_;                 // m/s, at cell centres
    VecX pressure_, before_, after_;   // m²/s², and ∇·ũ and ∇·u in 1/s
    Points<2> gradient_, solenoidal_;  // m/s, at cell centres
    Vec<2> drift_ = Vec<2>::Zero();    // m/s
    VecX tally_ = VecX::Zero(tally_count);
};

}  // namespace pliant::projection
