#include "diffusion.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <random>

namespace pliant::diffusion {
namespace {

constexpr Index most_iterations = 10000;
constexpr Real longest_step = 1e12;  // s

const Registration<DiffusionLesson> registration{
    {.id = "fluids/diffusion",
     .title = "Diffusion",
     .summary =
         "The viscosity stencil in one and two dimensions: its weights, its stability limit, and its factor for each wave.",
     .demo_steps = 40}};

}  // namespace

void DiffusionLesson::check() const {
    if (const Real step = time_step(); !(step > 0) || step > longest_step)
        throw Refused("viscosity", viscosity, "m²/s",
                      fmt::format("0, or so large that the time step Δt = rΔx²/ν = {:.3g} s lies between 0 and {:.0e} s: raise "
                                  "viscosity, or change diffusion_number",
                                  step, longest_step));
}

// ------------------------------------------------------------------------------------------------------ the initial state

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
    formula_symbols = grid2d::symbols_and({});
    stages = {
        stage_of("neighbours",
                 "1D: s = u_left + u_right − 2u;   2D: s = u_left + u_right + u_below + u_above − 4u;   ∇²u ≈ s/Δx²",
                 "Utrecht slides, viscosity: 2-neighbour and 4-neighbour stencil",
                 [this] {
                     previous_ = u_;
                     diffusion_->stencil(u_, stencil_);
                     laplacian_ = stencil_ / (dx() * dx());
                 })
            .done_in("core/pliant/fluids/diffusion.cpp: rate_of_change")
            .shows([this]() -> std::string_view {
                return dimensions == Dimensions::one ? "s = u_left + u_right − 2u,   ∇²u ≈ s/Δx²"
                                                     : "s = u_left + u_right + u_below + u_above − 4u,   ∇²u ≈ s/Δx²";
            })
            .maps({"u"}, {"u_before", "stencil", "laplacian"})
            .when([this] { return is_explicit(); })
            .because([this](const Question& q) { return why_neighbourhood(q); }),
        stage_of("update", "u ← u + (νΔt/Δx²) s;   as on the slide: u ← νΔt s",
                 "Utrecht slides, viscosity, with the old value and the 1/Δx² that they leave out",
                 [this] {
                     literal() ? u_ = rate() * dx() * dx()* stencil_ : u_ += rate() * stencil_;
                     end_step();
                 })
            .done_in("core/pliant/fluids/diffusion.cpp: explicit_step")
            .shows([this]() -> std::string_view { return form == Form::lecture ? "u ← νΔt s" : "u ← u + (νΔt/Δx²) s"; })
            .maps({"u", "stencil"}, {"u"})
            .when([this] { return is_explicit(); })
            .because([this](const Question& q) { return std::optional(why_updated(q.index)); }),
        stage_of("solve", "u′ − (νΔt/Δx²) s(u′) = u, by conjugate gradients: one iteration a pass", "Stam1999 §2.2; Shewchuk1994",
                 [this] {
                     diffusion_->iterate(u_);
                     residual_ = diffusion_->residual();
                 })
            .done_in("core/pliant/fluids/diffusion.cpp: begin_implicit, iterate")
            .maps({"u"}, {"u_before", "u", "residual"})
            .repeats([this] { return !diffusion_->converged(); },
                     [this] {
                         previous_ = u_;
                         diffusion_->begin_implicit(u_, rate(), {tolerance, most_iterations});
                     },
                     [this] { end_step(); })
            .when([this] { return !is_explicit(); })
            .because([this](const Question& q) { return why_solved(q); })};
}

// ------------------------------------------------------------------------------------------------------------- the handle

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

// Under which conditions the result can be trusted, what a run must obey, and which parameters mend what does not.

namespace {

constexpr Real most_decay = 0.5;          // νk²Δt: there an implicit step errs by a tenth
constexpr Real most_waves = Real(1) / 8;  // per cell: there the stencil's decay errs by 5 %
constexpr Index finest = 256;

}  // namespace

void DiffusionLesson::declare_checks() {
    assumptions = {
        assumption_of(
            "stability", "", [this] { return rate(); }, [this] { return stable_rate(); },
            "νΔt/Δx² ≤ 1/2 in 1D, 1/4 in 2D; as on the slide νΔt ≤ 1/4 m² in 1D, 1/8 m² in 2D",
            "the shortest wave overshoots: each step turns its sign and makes it larger, until nothing else is seen")
            .otherwise("beyond the explicit limit")
            .when([this] { return is_explicit(); })
            .mended_by([this] { return stable_again(); }),
        assumption_of(
            "the slide's formula is complete", "", [] { return Real{2}; }, [] { return Real{0}; },
            "terms left out: the old u, and 1/Δx²",
            "u ← νΔt Σ keeps only the increment, and of that not the 1/Δx²: the first step leaves almost nothing of u")
            .otherwise("terms missing from the slide's formula")
            .when([this] { return literal(); })
            .mended_by(Fix{"the careful form", {{"form", "careful"}}}),
        assumption_of(
            "mode resolved in time", "", [this] { return rate() * modes_.laplace_factor(mode); }, [] { return most_decay; },
            "ν|k|²Δt ≤ 0.5, of the watched mode",
            "it decays by much within one step: the factor of the scheme is not exp(−ν|k|²Δt), stable or not")
            .otherwise("mode too fast for Δt")
            .mended_by([this] { return fix_by(diffusion_number, rounded_down(0.8 * most_decay / modes_.laplace_factor(mode))); }),
        assumption_of(
            "mode resolved in space", "", [this] { return modes_.phase(mode) / (2 * std::numbers::pi); },
            [] { return most_waves; }, "at least 8 cells per wave",
            "the stencil lets a short wave live too long; with fewer than 2 cells per wave the cells show another wave")
            .otherwise("mode too short for the grid")
            .mended_by([this] { return finer_in_space(); })};
    const auto sound = [this] { return !literal() && (!is_explicit() || rate() <= limit()); };
    conserved = {{"sum", Law::constant, [this] { return 1e-9 * scale() * static_cast<Real>(u_.size()); },
                  [this] { return boundary != Boundary::fixed && !literal(); }, [this] { return u_.lpNorm<1>(); }},
                 {"max", Law::never_grows, [this] { return (is_explicit() ? 1e-12 : 1e-12 + 2 * tolerance) * scale(); },
                  [this, sound] { return boundary != Boundary::fixed && sound(); }}};
}

// As many cells as the wave needs, or a wave that the most cells can show.
std::optional<Fix> DiffusionLesson::finer_in_space() const {
    const Real waves = modes_.phase(mode) / (2 * std::numbers::pi) * resolution.value();
    const auto cells = static_cast<Index>(std::ceil(waves / most_waves - 1e-9));
    if (cells <= finest) return fix_by(resolution, static_cast<Real>(cells));
    return Fix{"m = 3, n = 64", {{"mode", "3"}, {"resolution", "64"}}};
}

std::string DiffusionLesson::blow_up_hint() const {
    const char* limit_text = dims() == 1 ? "1/2 in 1D" : "1/4 in 2D";
    const Real shortest = 4 * static_cast<Real>(dims());
    if (literal())
        return fmt::format(
            "The slide's formula multiplies the shortest wave by −{}νΔt/(1 m²) = {} in every step: choose the careful form",
            shortest, format_quantity(-shortest * rate() * dx() * dx(), "", 3));
    if (!is_explicit())
        return "An implicit step has no limit of stability: lower the diffusion number below 10⁶, or raise the tolerance";
    return fmt::format(
        "r = νΔt/Δx² = {} is above the limit of the explicit stencil, {}: the shortest wave is multiplied by 1 − {}r = {} in "
        "every "
        "step. Lower r to {} or less, or choose the implicit scheme",
        format_quantity(rate(), "", 3), limit_text, shortest, format_quantity(1 - shortest * rate(), "", 3), limit());
}

// With r as it is, half the cell size means a quarter of the time step: both errors fall alike.
std::vector<std::pair<std::string, std::string>> DiffusionLesson::finer() const {
    if (start == Start::random || start == Start::checkerboard || start == Start::spike || resolution == finest) return {};
    return {{"resolution", std::to_string(std::min<Index>(2 * resolution, finest))}};
}

}  // namespace pliant::diffusion
