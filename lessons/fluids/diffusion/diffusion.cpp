#include "diffusion.h"

#include <algorithm>
#include <random>

#include <fmt/format.h>

namespace pliant::diffusion {
namespace {

constexpr Index most_iterations = 10000;
constexpr Real longest_step = 1e12;  // s

ParameterInfo wall(std::string_view key, std::string_view symbol, std::string_view help, Real initial,
                   std::function<bool()> used) {
    return {.key = key,
            .symbol = symbol,
            .unit = "m/s",
            .help = help,
            .initial = initial,
            .useful = {-1, 1},
            .accepted = Interval{-1e3, 1e3},
            .effect = Effect::rebuild,
            .used = std::move(used)};
}

ParameterInfo cell(std::string_view key, std::string_view symbol, std::string_view help, std::function<bool()> used = {}) {
    return {.key = key,
            .symbol = symbol,
            .help = help,
            .initial = 12,
            .useful = {0, 127},
            .accepted = Interval{0, 255},
            .used = std::move(used)};
}

const Registration<DiffusionLesson> registration{
    {.id = "fluids/diffusion",
     .title = "Diffusion",
     .summary =
         "The viscosity stencil in one and two dimensions: its weights, its stability limit, and its factor for each wave.",
     .demo_steps = 40}};

}  // namespace

DiffusionLesson::DiffusionLesson()
    : dimensions(*this, {.key = "dimension", .help = "a row of cells, or a square of them", .effect = Effect::rebuild},
                 {{"1", "1D: a row"}, {"2", "2D: a square"}}),
      start(*this,
            {.key = "start",
             .help = "u at t = 0: one wave, a spike in the middle, a step, random numbers, a checkerboard, or nothing",
             .effect = Effect::rebuild},
            {{"mode", "one mode"},
             {"spike", "spike"},
             {"step", "step"},
             {"random", "random"},
             {"checkerboard", "checkerboard"},
             {"zero", "at rest"}}),
      mode(*this,
           {.key = "mode",
            .symbol = "m",
            .help = "wave number of the mode that is started, and watched in any start: waves over the length, or half waves "
                    "between walls; in 2D along both axes",
            .initial = 3,
            .useful = {1, 32},
            .accepted = Interval{0, 1024},
            .effect = Effect::rebuild}),
      seed(*this, {.key = "seed",
                   .help = "of the random numbers: each gives others, always the same",
                   .initial = 1,
                   .useful = {1, 20},
                   .accepted = Interval{0, 1e6},
                   .effect = Effect::rebuild,
                   .used = [this] { return start == Start::random; }}),
      scheme(*this,
             {.key = "scheme", .help = "explicit: from the old neighbours, at once. implicit: from the new ones, by a solver"},
             {{"explicit", "explicit"}, {"implicit", "implicit"}}),
      form(*this,
           {.key = "form",
            .help = "careful: u + (νΔt/Δx²) Σ. lecture: νΔt Σ taken literally, which forgets the old u and 1/Δx²",
            .used = [this] { return is_explicit(); }},
           {{"careful", "careful"}, {"lecture", "as on the slide"}}),
      diffusion_number(*this, {.key = "diffusion_number",
                               .symbol = "r",
                               .help = "r = νΔt/Δx²: how much a cell exchanges with each neighbour. It sets Δt = rΔx²/ν",
                               .initial = 0.25,
                               .useful = {0.01, 100},
                               .accepted = Interval{0, 1e12, true},
                               .scale = Scale::log,
                               .used = [this] { return viscosity > 0; }}),
      viscosity(*this,
                {.key = "viscosity",
                 .symbol = "ν",
                 .unit = "m²/s",
                 .help = "kinematic viscosity, or the diffusivity of heat or dye. With 0 nothing diffuses, and a step is 1 s",
                 .initial = 0.01,
                 .useful = {1e-6, 1},
                 .accepted = Interval{0, 1e6},
                 .scale = Scale::log}),
      length(*this, {.key = "length",
                     .symbol = "L",
                     .unit = "m",
                     .help = "of the row, or of each side of the square; Δx = L/n",
                     .initial = 1,
                     .useful = {0.1, 10},
                     .accepted = Interval{0, 1e3, true},
                     .scale = Scale::log,
                     .effect = Effect::rebuild}),
      resolution(*this, {.key = "resolution",
                         .symbol = "n",
                         .help = "cells along the row, or along each side of the square",
                         .initial = 32,
                         .useful = {4, 128},
                         .accepted = Interval{2, 256},
                         .effect = Effect::rebuild}),
      boundary(
          *this,
          {.key = "boundary",
           .help =
               "periodic: the ends meet. fixed: walls keep their value, half a cell beyond the last cells. insulated: nothing "
               "passes",
           .effect = Effect::rebuild},
          {{"periodic", "periodic"}, {"fixed", "fixed walls"}, {"insulated", "insulated"}}),
      wall_low(*this, wall("wall_low", "U₀", "value of the left wall", 0, [this] { return couette(); })),
      wall_high(*this, wall("wall_high", "U₁", "value of the right wall", 1, [this] { return couette(); })),
      cell_x(*this, cell("cell_x", "i", "column of the cell whose stencil is drawn; drag the handle in the picture")),
      cell_y(*this, cell("cell_y", "j", "row of the cell whose stencil is drawn; drag the handle in the picture",
                         [this] { return dims() == 2; })),
      tolerance(*this, {.key = "tolerance",
                        .symbol = "ε",
                        .help = "largest error of an implicit step, relative to u (2-norm): the solver stops there",
                        .initial = 1e-10,
                        .useful = {1e-12, 0.1},
                        .accepted = Interval{1e-14, 1},
                        .scale = Scale::log,
                        .used = [this] { return !is_explicit(); }}) {
    declare_fields();
    declare_stages();
    declare_probes();
    declare_mode_probes();
    declare_lines();
    declare_checks();
}

void DiffusionLesson::check() const {
    if (const Real step = time_step(); !(step > 0) || step > longest_step)
        throw Refused("viscosity", viscosity, "m²/s",
                      fmt::format("0, or so large that the time step Δt = rΔx²/ν = {:.3g} s lies between 0 and {:.0e} s: raise "
                                  "viscosity, or change diffusion_number",
                                  step, longest_step));
}

Real DiffusionLesson::time_step() const { return viscosity > 0 ? diffusion_number * dx() * dx() / viscosity : Real{1}; }

// ------------------------------------------------------------------------------------------------------ the initial state

// Two walls with values of their own exist in a row alone: around a square the fixed walls are at rest.
LatticeSide DiffusionLesson::side(bool high) const {
    if (boundary == Boundary::periodic) return {Beyond::periodic, 0};
    if (boundary == Boundary::insulated) return {Beyond::zero_gradient, 0};
    return {Beyond::wall_value, couette() ? Real(high ? wall_high : wall_low) : Real{0}};
}

Lattice<2> DiffusionLesson::make_lattice() const {
    Lattice<2> lattice;
    lattice.count = {resolution, dims() == 2 ? Index(resolution) : 1};
    lattice.offset = {0.5, 0.5};
    lattice.sides[0] = {side(false), side(true)};
    if (dims() == 2) lattice.sides[1] = lattice.sides[0];
    return lattice;
}

void DiffusionLesson::reset() {
    lattice_ = make_lattice();
    modes_ = WaveModes(boundary, resolution, dims());
    diffusion_ = std::make_unique<Diffusion<2>>(lattice_);
    u_ = starting_values();
    previous_ = u_;
    elapsed_.setZero();
    for (VecX* array : {&stencil_, &laplacian_, &residual_}) *array = VecX::Zero(u_.size());
}

VecX DiffusionLesson::starting_values() const {
    const Index n = resolution;
    std::mt19937 draw(static_cast<std::mt19937::result_type>(Index(seed)));
    VecX u = VecX::Zero(lattice_.size());
    if (start == Start::mode) u = modes_.on_cells(mode);
    for (Index c = 0; c < u.size(); ++c) {
        const Counts<2> at = lattice_.coordinates(c);
        const bool in_middle = at[0] == n / 2 && (dims() == 1 || at[1] == n / 2);
        if (start == Start::mode) u[c] += steady(c);
        if (start == Start::spike) u[c] = in_middle ? 1 : 0;
        if (start == Start::step) u[c] = at[0] < n / 2 ? 1 : 0;
        if (start == Start::random) u[c] = 2 * static_cast<Real>(draw()) / static_cast<Real>(std::mt19937::max()) - 1;
        if (start == Start::checkerboard) u[c] = (at[0] + at[1]) % 2 ? -1 : 1;
    }
    return u;
}

// ------------------------------------------------------------------------------------------------------------- the stages

void DiffusionLesson::declare_stages() {
    stages = {
        {.name = "neighbours",
         .formula = "1D: s = u_left + u_right − 2u;   2D: s = u_left + u_right + u_below + u_above − 4u;   ∇²u ≈ s/Δx²",
         .formula_in_force = [this]() -> std::string_view {
             return dimensions == Dimensions::one ? "s = u_left + u_right − 2u,   ∇²u ≈ s/Δx²"
                                                  : "s = u_left + u_right + u_below + u_above − 4u,   ∇²u ≈ s/Δx²";
         },
         .source = "Utrecht slides, viscosity: 2-neighbour and 4-neighbour stencil",
         .run = [this] { look_at_neighbours(); },
         .reads = {"u"},
         .writes = {"u_before", "stencil", "laplacian"},
         .active = [this] { return is_explicit(); },
         .explain = [this](const Question& q) { return why_neighbourhood(q); }},
        {.name = "update",
         .formula = "u ← u + (νΔt/Δx²) s;   as on the slide: u ← νΔt s",
         .formula_in_force = [this]() -> std::string_view { return form == Form::lecture ? "u ← νΔt s" : "u ← u + (νΔt/Δx²) s"; },
         .source = "Utrecht slides, viscosity, with the old value and the 1/Δx² that they leave out",
         .run =
             [this] {
                 update();
                 end_step();
             },
         .reads = {"u", "stencil"},
         .writes = {"u"},
         .active = [this] { return is_explicit(); },
         .explain = [this](const Question& q) { return std::optional(why_updated(q.index)); }},
        {.name = "solve",
         .formula = "u′ − (νΔt/Δx²) s(u′) = u, by conjugate gradients: one iteration a pass",
         .source = "Stam1999 §2.2; Shewchuk1994",
         .run = [this] { solve_pass(); },
         .reads = {"u"},
         .writes = {"u_before", "u", "residual"},
         .active = [this] { return !is_explicit(); },
         .again = [this] { return !diffusion_->converged(); },
         .begin = [this] { begin_solve(); },
         .end = [this] { end_step(); },
         .explain = [this](const Question& q) { return why_solved(q); }}};
}

void DiffusionLesson::look_at_neighbours() {
    previous_ = u_;
    diffusion_->stencil(u_, stencil_);
    laplacian_ = stencil_ / (dx() * dx());
}

void DiffusionLesson::update() {
    if (literal())
        u_ = rate() * dx() * dx() * stencil_;
    else
        u_ += rate() * stencil_;
}

void DiffusionLesson::begin_solve() {
    previous_ = u_;
    diffusion_->begin_implicit(u_, rate(), {tolerance, most_iterations});
}

void DiffusionLesson::solve_pass() {
    diffusion_->iterate(u_);
    residual_ = diffusion_->residual();
}

void DiffusionLesson::end_step() { elapsed_ += Eigen::Array2d(time_step(), viscosity * time_step()); }

// ------------------------------------------------------------------------------------------------------------- the handle

Counts<2> DiffusionLesson::selected() const {
    return {std::min<Index>(cell_x, lattice_.count[0] - 1), std::min<Index>(cell_y, lattice_.count[1] - 1)};
}

std::vector<DiffusionLesson::Neighbour> DiffusionLesson::neighbours() const {
    std::vector<Neighbour> beside{{"left", 0, -1}, {"right", 0, 1}};
    if (dims() == 2) beside.insert(beside.end(), {{"below", 1, -1}, {"above", 1, 1}});
    return beside;
}

// To the cell under the hand.
std::vector<std::pair<std::string, Real>> DiffusionLesson::dragged(const Pull& pull) const {
    if (pull.index != 0) return {};
    const auto under = [&](int axis) {
        return std::clamp(std::floor(pull.to[axis] / dx()), Real(0), static_cast<Real>(lattice_.count[axis] - 1));
    };
    std::vector<std::pair<std::string, Real>> values{{"cell_x", under(0)}};
    if (dims() == 2) values.emplace_back("cell_y", under(1));
    return values;
}

}  // namespace pliant::diffusion
