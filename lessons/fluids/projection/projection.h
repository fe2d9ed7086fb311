// Any velocity in, its divergence, the pressure pass by pass, a velocity without divergence out.
#pragma once
#include "given_field.h"
#include "kits/grid2d/flow_readings.h"

#include <pliant/fluids/collocated.h>
#include <pliant/fluids/helmholtz.h>
#include <pliant/fluids/solver_histories.h>
#include <pliant/fluids/staggered_grid.h>
#include <pliant/lesson/registry.h>

#include <deque>
#include <memory>

namespace pliant::projection {

// The unit square of the lesson: its walls, and the solid cells in it.

enum class Obstacle { none, disc, two_rooms, one_cell, all_solid };

inline const Vec<2> disc_middle{0.66, 0.5};  // m
inline constexpr Real disc_radius = 0.14;    // m

inline bool is_solid(Obstacle obstacle, Index i, Index j, Index n) {
    const auto place = [n](Index k) { return (static_cast<Real>(k) + Real(0.5)) / static_cast<Real>(n); };
    switch (obstacle) {
        case Obstacle::none:
            return false;
        case Obstacle::disc:
            return (Vec<2>(place(i), place(j)) - disc_middle).norm() < disc_radius;
        case Obstacle::two_rooms:
            return i == n / 2;
        case Obstacle::one_cell:
            return i != n / 2 || j != n / 2;
        case Obstacle::all_solid:
            return true;
    }
    return false;
}

// n by n cells. inflow and outflow: speeds to the right on the left and on the right wall, m/s; not used where it is periodic.
inline StaggeredGridInfo<2> unit_square(Index n, bool periodic, Obstacle obstacle, Real inflow, Real outflow) {
    StaggeredGridInfo<2> info;
    info.cells = {n, n};
    info.dx = 1 / static_cast<Real>(n);
    info.periodic.fill(periodic);
    if (!periodic) {
        info.walls[0][0].velocity = {inflow, 0};
        info.walls[0][1].velocity = {outflow, 0};
    }
    if (obstacle == Obstacle::none) return info;
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) info.types.push_back(is_solid(obstacle, i, j, n) ? CellType::solid : CellType::fluid);
    return info;
}

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
struct Projection final : Lesson {
    Projection();

    int dimension() const override { return 2; }
    void reset() override;
    Real time_step() const override { return 0; }
    bool at_rest() const override { return tally_[done] != 0; }
    void draw(Scene& scene) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::optional<On> can_pull() const override { return On::handle; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    ColourBy first_colours() const override { return {staggered() ? "pressure" : "velocity", -1}; }
    std::vector<Group> first_groups() const override { return {Group::scene, Group::method, Group::solver}; }
    std::vector<std::string_view> first_plots() const override { return {"residual"}; }
    std::vector<std::string_view> key_numbers() const override {
        return {"max_divergence_before", "max_divergence", "solver_iterations"};
    }
    std::string_view error_probe() const override { return "max_divergence"; }

    Choice<Given> given{
        *this,
        setting_of("field",
                   "the velocity that is given; drawn: drag three arrows in the picture; through-flow: fluid at rest, with an "
                   "inflow on the left")
            .in(Group::scene)
            .rebuilds(),
        {{"swirl", "swirl and source"},
         {"source_sink", "source and sink"},
         {"jet", "jet"},
         {"random", "random"},
         {"checkerboard", "checkerboard"},
         {"gradient", "a gradient"},
         {"drawn", "drawn: three arrows"},
         {"through_flow", "through-flow"}}};
    Whole resolution{*this,
                     quantity("resolution", "n", "", 24, {4, 128}, {1, 256}, "cells along each side of the square; Δx = 1 m / n")
                         .in(Group::shape)
                         .rebuilds()};
    Choice<Arrangement> arrangement{
        *this,
        setting_of("grid",
                   "staggered: velocity on faces, pressure in cells. Collocated: both in cells, differences over 2Δx, no "
                   "solids, plain conjugate gradients")
            .in(Group::method)
            .rebuilds(),
        {{"staggered", "staggered"}, {"collocated", "collocated"}},
        [this] { return given != Given::through_flow; }};
    Choice<Boundary> boundary{
        *this,
        setting_of("boundary", "a closed box, or what leaves on one side enters on the other").in(Group::scene).rebuilds(),
        {{"box", "box"}, {"periodic", "periodic"}},
        [this] { return given != Given::through_flow; }};
    Choice<Obstacle> obstacle{*this,
                              setting_of("obstacle", "cells that are solid and at rest").in(Group::scene).rebuilds(),
                              {{"none", "none"},
                               {"disc", "disc"},
                               {"two_rooms", "two rooms"},
                               {"one_cell", "one fluid cell"},
                               {"all_solid", "all solid"}},
                              [this] { return staggered(); }};
    Choice<PressurePreconditioner> solver{
        *this,
        setting_of("solver", "conjugate gradients for the pressure, without or with a preconditioner",
                   PressurePreconditioner::multigrid)
            .in(Group::solver)
            .rebuilds(),
        {{"cg", "conjugate gradients, no preconditioner"},
         {"jacobi", "conjugate gradients, Jacobi"},
         {"incomplete_cholesky", "conjugate gradients, incomplete Cholesky"},
         {"multigrid", "conjugate gradients, multigrid"}},
        [this] { return staggered(); }};
    Number tolerance{*this, log_quantity("tolerance", "τ", "", 1e-6, {1e-10, 0.5}, {1e-12, 1, false, true},
                                         "the solver stops when max|∇·u| ≤ τ max|∇·ũ|")
                                .in(Group::solver)
                                .rebuilds()};
    Whole max_iterations{*this, log_quantity("max_iterations", "", "", 1000, {1, 1000}, {1, 100000},
                                             "the solver gives up after so many passes, and says what is left")
                                    .in(Group::solver)
                                    .rebuilds()};
    Number dt{*this,
              log_quantity("time_step", "Δt", "s", 1, {0.01, 1}, {0, 10, true},
                           "in which the pressure acts: half the time takes twice the pressure, and the velocity is the same")
                  .in(Group::method)
                  .rebuilds()};
    Number speed{*this,
                 quantity("speed", "U", "m/s", 1, {-2, 2}, {-1000, 1000},
                          "largest speed of a push, of the noise, of the wave or of the inflow")
                     .in(Group::scene)
                     .rebuilds(),
                 [this] { return given != Given::drawn; }};
    Number outflow{*this,
                   quantity("outflow", "a", "", 1, {0, 1},
                            "share of the inflow that may leave on the right; without the rest there is no pressure")
                       .in(Group::scene)
                       .rebuilds(),
                   [this] { return walls_move(); }};
    Number disturbance{
        *this, quantity("pressure_checkerboard", "A", "m²/s²", 0, {-1, 1}, {-1000, 1000},
                        "added to the pressure that was found, with + and − in turn from cell to cell: does the grid feel it?")
                   .in(Group::scene)
                   .rebuilds()};
    Whole seed{*this,
               quantity("seed", "", "", 1, {1, 100}, {0, 1e9}, "of the noise: another number, another field")
                   .in(Group::scene)
                   .rebuilds(),
               [this] { return given == Given::random; }};
    Number cell_x{
        *this, quantity("cell_x", "x_c", "m", 0.34, {0, 1}, "place of the cell that is drawn large; drag its dot in the picture")
                   .in(Group::view)
                   .looks()};
    Number cell_y{
        *this, quantity("cell_y", "y_c", "m", 0.62, {0, 1}, "place of the cell that is drawn large; drag its dot in the picture")
                   .in(Group::view)
                   .looks()};
    std::deque<DrawnArrow> drawn;

    enum Tally : Index { done, projected, passes, initial, energy_given, overlap, tally_count };
    enum Handle : Index { cell_handle, first_place, first_tip = first_place + Index(arrow_count) };

    void declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks();

    // --- the stages ---
    void give();
    void take_divergence() {
        divergence_of(before_);
        tally_[initial] = before_.lpNorm<Eigen::Infinity>();
    }
    void begin_pressure();
    void pressure_pass();
    void disturb() {
        for (Index c = 0; c < pressure_.size(); ++c)
            if (grid_->is_fluid(c)) pressure_[c] += disturbance * parity(c);
        (staggered() ? projection_->pressure() : central_projection_->pressure()) = pressure_;
    }
    void project();
    void split();

    bool staggered() const { return arrangement == Arrangement::staggered || given == Given::through_flow; }
    bool periodic() const { return boundary == Boundary::periodic && given != Given::through_flow; }
    bool walls_move() const { return given == Given::through_flow; }
    Real dx() const { return Real(1) / resolution.value(); }
    Obstacle solids() const { return staggered() ? Obstacle(obstacle) : Obstacle::none; }
    ProjectionSettings settings() const { return {tolerance, max_iterations, solver}; }
    GivenField given_field() const;
    Real parity(Index cell) const;  // ±1 in turn
    // The velocity at the cell centres, for pictures and parts.
    void renew_centre() {
        if (staggered()) return cell_velocity(*grid_, velocity_, centre_);
        centre_.resize(2, central_[0].size());
        for (int a = 0; a < 2; ++a) centre_.row(a) = central_[a].transpose();
    }
    void divergence_of(VecX& out) const;  // of the velocity as it is now, 1/s
    Points<2> pressure_gradient() const;  // Δt ∇p at cell centres, m/s

    // --- what is measured (projection_readings.cpp) ---
    // Per mass, J/kg.
    Real specific_energy() const {
        if (grid_->fluid_cells() == 0) return 0;
        if (staggered()) return kinetic_energy(*grid_, velocity_) / fluid_area();
        return 0.5 * centre_.squaredNorm() * dx() * dx() / fluid_area();
    }
    Real fluid_area() const { return grid_->cell_volume() * static_cast<Real>(grid_->fluid_cells()); }  // m²
    Index selected_cell() const;
    // Of how many pressures does the gradient of the grid see nothing?
    Index invisible_count() const {
        if (staggered()) return projection_->regions().count();
        return static_cast<Index>(invisible_pressures(grid_->cells()).size());
    }
    Real net_inflow() const;  // m²/s
    void sample_history(Curve& curve, PressurePreconditioner which, Index most) const;

    // --- how the numbers came about (projection_why.cpp) ---
    grid2d::GridWhy grid_why() const { return {*grid_, dt}; }
    Explanation why_given(const Question& q) const;
    Explanation why_divergence(Index cell, Input::From from) const;
    std::optional<Explanation> why_pressure_pass(const Question& q) const;
    Explanation why_passes() const;
    Explanation why_part(const Question& q) const;
    Explanation why_velocity(const Question& q) const;
    Explanation why_energy() const;

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
