// Diffusion of a quantity on a row or a square of cells: the stencil of the lecture, explicit and implicit, and what a step does
// to each Fourier mode.
#pragma once
#include "kits/grid2d/flow_readings.h"

#include <pliant/fluids/diffusion.h>
#include <pliant/fluids/wave_modes.h>
#include <pliant/lesson/registry.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace pliant::diffusion {

using Boundary = WaveModes::Boundary;
enum class Dimensions { one, two };
enum class Start { mode, spike, step, random, checkerboard, zero };
enum class Scheme { explicit_euler, implicit_euler };
enum class Form { careful, lecture };

// u(t) on cells of edge Δx = L/n, ∂u/∂t = ν ∇²u. A row of cells is a lattice with one cell across, whose missing neighbours there
// exchange nothing: the five-point stencil then is the three-point one.
struct DiffusionLesson final : Lesson {
    DiffusionLesson() { declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks(); }

    int dimension() const override { return 2; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return viscosity > 0 ? diffusion_number * dx() * dx() / viscosity : Real{1}; }
    bool at_rest() const override;
    std::string unrest() const override { return ""; }  // what diffuses evens out, or blows up
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    void draw(Scene& scene) const override {
        dims() == 1 ? draw_row(scene) : draw_square(scene);
        write_notes(scene);
    }
    std::optional<On> can_pull() const override { return On::handle; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure&) const override {
        if (literal()) return Fix{"the careful form, r = 0.2", {{"form", "careful"}, {"diffusion_number", "0.2"}}};
        if (is_explicit()) return stable_again();
        return Fix{"r = 1", {{"diffusion_number", "1"}}};
    }
    std::vector<Fix> other_fixes(const Failure&) const override {
        if (literal() || !is_explicit()) return {};
        return {Fix{"the implicit scheme", {{"viscosity_scheme", "implicit"}}}};
    }
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return exact(0, 0) ? "error" : "amplitude"; }
    ColourBy first_colours() const override { return {"u"}; }
    std::vector<std::string_view> first_plots() const override { return {"profile", "factors", "amplitude"}; }
    std::vector<std::string_view> key_numbers() const override { return {"factor_measured", "factor_theory", "max"}; }

    Choice<Dimensions> dimensions{*this,
                                  setting_of("dimension", "a row of cells, or a square of them").in(Group::scene).rebuilds(),
                                  {{"1", "1D: a row"}, {"2", "2D: a square"}}};
    Choice<Start> start{
        *this,
        setting_of("start", "u at t = 0: one wave, a spike in the middle, a step, random numbers, a checkerboard, or nothing")
            .in(Group::start)
            .rebuilds(),
        {{"mode", "one mode"},
         {"spike", "spike"},
         {"step", "step"},
         {"random", "random"},
         {"checkerboard", "checkerboard"},
         {"zero", "at rest"}}};
    Whole mode{*this,
               quantity("mode", "m", "", 3, {1, 32}, {0, 1024},
                        "wave number of the mode that is started, and watched in any start: waves over the length, or half waves "
                        "between walls; in 2D along both axes")
                   .in(Group::start)
                   .rebuilds()};
    Whole seed{*this,
               quantity("seed", "", "", 1, {1, 20}, {0, 1e6}, "of the random numbers: each gives others, always the same")
                   .in(Group::start)
                   .rebuilds(),
               [this] { return start == Start::random; }};
    Choice<Scheme> scheme{
        *this,
        setting_of("viscosity_scheme", "explicit: from the old neighbours, at once. implicit: from the new ones, by a solver")
            .once("scheme")
            .in(Group::method),
        {{"explicit", "explicit"}, {"implicit", "implicit"}}};
    Choice<Form> form{
        *this,
        setting_of("form", "careful: u + (νΔt/Δx²) Σ. lecture: νΔt Σ taken literally, which forgets the old u and 1/Δx²")
            .in(Group::method),
        {{"careful", "careful"}, {"lecture", "as on the slide"}},
        [this] { return is_explicit(); }};
    Number diffusion_number{*this,
                            log_quantity("diffusion_number", "r", "", 0.25, {0.01, 100}, {0, 1e12, true},
                                         "r = νΔt/Δx²: how much a cell exchanges with each neighbour. It sets Δt = rΔx²/ν")
                                .in(Group::method),
                            [this] { return viscosity > 0; }};
    Number viscosity{
        *this, log_quantity("viscosity", "ν", "m²/s", 0.01, {1e-6, 1}, {0, 1e6},
                            "kinematic viscosity, or the diffusivity of heat or dye. With 0 nothing diffuses, and a step is 1 s")
                   .in(Group::material)};
    Number length{*this, log_quantity("length", "L", "m", 1, {0.1, 10}, {0, 1e3, true},
                                      "of the row, or of each side of the square; Δx = L/n")
                             .in(Group::shape)
                             .rebuilds()};
    Whole resolution{
        *this, quantity("resolution", "n", "", 32, {4, 128}, {2, 256}, "cells along the row, or along each side of the square")
                   .in(Group::shape)
                   .rebuilds()};
    Choice<Boundary> boundary{
        *this,
        setting_of(
            "boundary",
            "periodic: the ends meet. fixed: walls keep their value, half a cell beyond the last cells. insulated: nothing "
            "passes")
            .in(Group::scene)
            .rebuilds(),
        {{"periodic", "periodic"}, {"fixed", "fixed walls"}, {"insulated", "insulated"}}};
    Number wall_low{
        *this, quantity("wall_low", "U₀", "m/s", 0, {-1, 1}, {-1e3, 1e3}, "value of the left wall").in(Group::scene).rebuilds(),
        [this] { return couette(); }};
    Number wall_high{
        *this, quantity("wall_high", "U₁", "m/s", 1, {-1, 1}, {-1e3, 1e3}, "value of the right wall").in(Group::scene).rebuilds(),
        [this] { return couette(); }};
    Whole cell_x{*this, quantity("cell_x", "i", "", 12, {0, 127}, {0, 255},
                                 "column of the cell whose stencil is drawn; drag the handle in the picture")
                            .in(Group::view)
                            .looks()};
    Whole cell_y{*this,
                 quantity("cell_y", "j", "", 12, {0, 127}, {0, 255},
                          "row of the cell whose stencil is drawn; drag the handle in the picture")
                     .in(Group::view)
                     .looks(),
                 [this] { return dims() == 2; }};
    Number tolerance{*this,
                     log_quantity("tolerance", "ε", "", 1e-10, {1e-12, 0.1}, {1e-14, 1},
                                  "largest error of an implicit step, relative to u (2-norm): the solver stops there")
                         .in(Group::solver),
                     [this] { return !is_explicit(); }};

    void declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks();

    // --- the stages ---
    void end_step() { elapsed_ += Eigen::Array2d(time_step(), viscosity * time_step()); }

    // --- the grid ---
    int dims() const { return dimensions == Dimensions::two ? 2 : 1; }
    Real dx() const { return length / resolution.value(); }
    Real rate() const { return viscosity > 0 ? Real(diffusion_number) : 0; }  // r = ν Δt/Δx² of a step
    Real limit() const { return 1 / static_cast<Real>(2 * dims()); }          // of r, for the explicit stencil
    // Of r, for an explicit step in the form that is chosen: there the shortest wave keeps its size.
    Real stable_rate() const { return literal() ? limit() / (2 * dx() * dx()) : limit(); }
    bool is_explicit() const { return scheme == Scheme::explicit_euler; }
    bool literal() const { return is_explicit() && form == Form::lecture; }
    bool couette() const { return dims() == 1 && boundary == Boundary::fixed; }
    // Two walls with values of their own exist in a row alone: around a square the fixed walls are at rest.
    LatticeSide side(bool high) const {
        if (boundary == Boundary::periodic) return {Beyond::periodic, 0};
        if (boundary == Boundary::insulated) return {Beyond::zero_gradient, 0};
        return {Beyond::wall_value, couette() ? Real(high ? wall_high : wall_low) : Real{0}};
    }
    Lattice<2> make_lattice() const;
    Counts<2> selected() const {
        return {std::min<Index>(cell_x, lattice_.count[0] - 1), std::min<Index>(cell_y, lattice_.count[1] - 1)};
    }
    Index selected_cell() const { return lattice_.index(selected()); }
    struct Neighbour {
        const char* name;  // "left"
        int axis, step;
    };
    std::vector<Neighbour> neighbours() const {
        std::vector<Neighbour> beside{{"left", 0, -1}, {"right", 0, 1}};
        if (dims() == 2) beside.insert(beside.end(), {{"below", 1, -1}, {"above", 1, 1}});
        return beside;
    }

    // --- solutions in closed form ---
    VecX starting_values() const;
    // What u tends to between two walls, m/s.
    Real steady(Index cell) const {
        if (!couette()) return 0;
        const Real share = (static_cast<Real>(lattice_.coordinates(cell)[0]) + 0.5) / resolution.value();
        return wall_low + (wall_high - wall_low) * share;
    }
    // u less its steady value
    VecX deviation(const VecX& u) const {
        if (!couette()) return u;
        return u - VecX::NullaryExpr(u.size(), [this](Index c) { return steady(c); });
    }
    // Of the equation itself; τ = ∫ν dt, m².
    std::optional<Real> exact(Index cell, Real tau) const {
        const Counts<2> at = lattice_.coordinates(cell);
        return exact_at(static_cast<Real>(at[0]), static_cast<Real>(at[1]), tau);
    }
    std::optional<Real> exact_at(Real s_x, Real s_y, Real tau) const;  // in cells from the middle of the first one
    Real tau(Real t) const { return elapsed_[1] + viscosity * (t - elapsed_[0]); }
    // The largest |u| of the start and the walls, m/s.
    Real scale() const {
        const Real walls = couette() ? std::max(std::abs(wall_low), std::abs(wall_high)) : Real{0};
        if (start == Start::mode) return 1 + walls;
        return start == Start::zero && walls > 0 ? walls : std::max(Real(1), walls);
    }

    // --- what is measured ---
    Real explicit_factor(Index m) const { return 1 - rate() * modes_.stencil_factor(m); }
    Real implicit_factor(Index m) const { return 1 / (1 + rate() * modes_.stencil_factor(m)); }
    Real lecture_factor(Index m) const { return -rate() * dx() * dx() * modes_.stencil_factor(m); }
    Real exact_factor(Index m) const { return std::exp(-rate() * modes_.laplace_factor(m)); }
    Real theory(Index m) const { return literal() ? lecture_factor(m) : is_explicit() ? explicit_factor(m) : implicit_factor(m); }
    std::optional<Real> measured_factor() const;
    std::optional<Real> starting_amplitude() const;
    Real error_in(Index cell) const { return std::abs(u_[cell] - *exact(cell, elapsed_[1])); }
    Index worst_cell() const;
    void measured_factors(Curve& curve) const;
    void theory_factors(Curve& curve, Real (DiffusionLesson::*factor)(Index) const) const;
    void profile(Curve& curve) const {
        const Index row = selected()[1];
        grid2d::sample_centres(curve, resolution, dx(), [&](Index i) { return u_[lattice_.index({i, row})]; });
    }
    void exact_profile(Curve& curve) const;

    Fix stable_again() const { return fix_by(diffusion_number, rounded_down(0.9 * stable_rate())); }
    std::optional<Fix> finer_in_space() const;

    // --- how the numbers came about (diffusion_why.cpp) ---
    Input why_rate() const {
        return viscosity > 0 ? Input::of(diffusion_number) : Input::constant("r", 0, "", "νΔt/Δx² without viscosity");
    }
    Input why_dx() const { return Input::part("Δx", "m", {"Δx = L / n", {length, resolution}}); }
    Explanation why_time_step() const {
        if (viscosity == 0) return fixed_value("Δt = 1   (any: without viscosity nothing diffuses)");
        return {"Δt = r Δx² / ν", {diffusion_number, why_dx(), viscosity}};
    }
    std::vector<Input> why_neighbours(Index cell, Input::From from, const char* mark) const;
    std::optional<Explanation> why_neighbourhood(const Question& q) const;
    Explanation why_updated(Index cell) const;
    std::optional<Explanation> why_solved(const Question& q) const;
    Explanation why_amplitude(std::string_view field) const;
    Explanation why_theory() const;
    Explanation why_extreme(bool largest) const {
        Index at = 0;
        largest ? u_.maxCoeff(&at) : u_.minCoeff(&at);
        return {fmt::format("{} u = u   (of all cells: cell {})", largest ? "max" : "min", at), {Input::now("u", "u", at)}};
    }

    // --- the picture (diffusion_picture.cpp) ---
    void draw_row(Scene& scene) const;
    void draw_exchanges(Scene& scene) const;
    void draw_curve(Scene& scene) const;
    void draw_square(Scene& scene) const;
    void draw_cells(Scene& scene, const Position& lower, const Position& upper) const;
    // Where the stencil is drawn large [m].
    struct Magnifier {
        Vec<2> middle;  // of the selected cell
        Vec<2> apart;   // from there to its neighbours along x and y
        Vec<2> half;    // of a cell
    };
    void draw_stencil(Scene& scene, const Magnifier& large) const;
    void draw_neighbour(Scene& scene, const Magnifier& large, const Neighbour& n) const;
    struct Weights {
        std::string beside_symbols, own_symbols;
        Real beside, own;
    };
    Weights weights() const;
    Vec<2> cell_middle(const Counts<2>& at) const;  // m; beyond the ends for cells beyond a wall
    Vec<2> cell_half() const;
    void write_notes(Scene& scene) const;
    std::string formula_at_cell() const;

    Lattice<2> lattice_;
    WaveModes modes_{Boundary::periodic, 1, 1};
    std::unique_ptr<Diffusion<2>> diffusion_;

    // What defines now: u and what it was before the latest step [m/s], and the time [s] with ∫ν dt [m²] up to it.
    VecX u_, previous_;
    Eigen::Array2d elapsed_ = Eigen::Array2d::Zero();
    // What the stages make of it: Σ u_n − 2 Dim u [m/s], ∇²u [1/(m s)], and what the solver has left of its equations [m/s].
    VecX stencil_, laplacian_, residual_;
};

}  // namespace pliant::diffusion
