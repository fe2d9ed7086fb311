// Diffusion of a quantity on a row or a square of cells: the stencil of the lecture, explicit and implicit, and what a step does
// to each Fourier mode.
#pragma once
#include "wave_modes.h"

#include <pliant/fluids/diffusion.h>
#include <pliant/lesson/registry.h>

#include <cmath>
#include <memory>
#include <optional>

namespace pliant::diffusion {

enum class Dimensions { one, two };
enum class Start { mode, spike, step, random, checkerboard, zero };
enum class Scheme { explicit_euler, implicit_euler };
enum class Form { careful, lecture };

// u(t) on cells of edge Δx = L/n, ∂u/∂t = ν ∇²u. A row of cells is a lattice with one cell across, whose missing neighbours there
// exchange nothing: the five-point stencil then is the three-point one.
class DiffusionLesson final : public Lesson {
public:
    DiffusionLesson();

    int dimension() const override { return 2; }
    void check() const override;
    void reset() override;
    Real time_step() const override;
    bool at_rest() const override;
    std::string unrest() const override { return ""; }  // what diffuses evens out, or blows up
    void draw(Scene& scene) const override;
    std::optional<On> can_pull() const override { return On::handle; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return exact(0, 0) ? "error" : "amplitude"; }
    ColourBy first_colours() const override { return {"u"}; }
    std::vector<std::string_view> first_plots() const override { return {"profile", "factors", "amplitude"}; }
    std::vector<std::string_view> key_numbers() const override { return {"factor_measured", "factor_theory", "max"}; }

private:
    Choice<Dimensions> dimensions;
    Choice<Start> start;
    Whole mode, seed;
    Choice<Scheme> scheme;
    Choice<Form> form;
    Number diffusion_number, viscosity, length;
    Whole resolution;
    Choice<Boundary> boundary;
    Number wall_low, wall_high;
    Whole cell_x, cell_y;
    Number tolerance;

    void declare_fields();
    void declare_stages();
    void declare_probes();
    void declare_mode_probes();
    void declare_lines();
    void declare_checks();

    // --- the stages ---
    void look_at_neighbours();
    void update();
    void begin_solve();
    void solve_pass();
    void end_step();

    // --- the grid ---
    int dims() const { return dimensions == Dimensions::two ? 2 : 1; }
    Real dx() const { return length / static_cast<Real>(Index(resolution)); }
    Real rate() const { return viscosity > 0 ? Real(diffusion_number) : 0; }  // r = ν Δt/Δx² of a step
    Real limit() const { return 1 / static_cast<Real>(2 * dims()); }          // of r, for the explicit stencil
    bool is_explicit() const { return scheme == Scheme::explicit_euler; }
    bool literal() const { return is_explicit() && form == Form::lecture; }
    bool couette() const { return dims() == 1 && boundary == Boundary::fixed; }
    LatticeSide side(bool high) const;
    Lattice<2> make_lattice() const;
    Counts<2> selected() const;
    Index selected_cell() const { return lattice_.index(selected()); }
    struct Neighbour {
        const char* name;  // "left"
        int axis, step;
    };
    std::vector<Neighbour> neighbours() const;

    // --- solutions in closed form ---
    VecX starting_values() const;
    Real steady(Index cell) const;                                     // what u tends to between two walls, m/s
    VecX deviation(const VecX& u) const;                               // u less that
    std::optional<Real> exact(Index cell, Real tau) const;             // τ = ∫ν dt, m²
    std::optional<Real> exact_at(Real s_x, Real s_y, Real tau) const;  // in cells from the middle of the first one
    Real tau(Real t) const { return elapsed_[1] + viscosity * (t - elapsed_[0]); }
    Real scale() const;  // m/s: the largest |u| of the start and the walls

    // --- what is measured ---
    Real explicit_factor(Index m) const { return 1 - rate() * modes_.stencil_factor(m); }
    Real implicit_factor(Index m) const { return 1 / (1 + rate() * modes_.stencil_factor(m)); }
    Real lecture_factor(Index m) const { return -rate() * dx() * dx() * modes_.stencil_factor(m); }
    Real exact_factor(Index m) const { return std::exp(-rate() * modes_.laplace_factor(m)); }
    Real theory(Index m) const;
    std::optional<Real> measured_factor() const;
    std::optional<Real> starting_amplitude() const;
    std::optional<Real> largest_error() const;
    void measured_factors(Curve& curve) const;
    void theory_factors(Curve& curve, Real (DiffusionLesson::*factor)(Index) const) const;
    void profile(Curve& curve) const;
    void exact_profile(Curve& curve) const;

    std::optional<Fix> stable_again() const;
    std::optional<Fix> finer_in_time() const;
    std::optional<Fix> finer_in_space() const;

    // --- how the numbers came about (diffusion_why.cpp) ---
    Input why_rate() const;
    Input why_dx() const;
    Explanation why_time_step() const;
    std::vector<Input> why_neighbours(Index cell, Input::From from, const char* mark) const;
    std::optional<Explanation> why_neighbourhood(const Question& q) const;
    Explanation why_updated(Index cell) const;
    std::optional<Explanation> why_solved(const Question& q) const;
    Explanation why_amplitude(std::string_view field) const;
    Explanation why_factor() const;
    Explanation why_theory() const;
    Explanation why_exact_factor() const;
    Explanation why_extreme(bool largest) const;
    Explanation why_error() const;

    // --- the picture (diffusion_picture.cpp, stencil_picture.cpp) ---
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
