// What the lesson shows and measures: fields, probes, lines.
#include "diffusion.h"

#include <pliant/fluids/channel_flow.h>

#include <algorithm>

#include <fmt/format.h>

namespace pliant::diffusion {
namespace {

constexpr Real blown_up = 100;           // times the largest |u| of the start: no diffusion exceeds that itself
constexpr Real least_amplitude = 1e-10;  // of a mode, relative to the largest: below it a factor is rounding

}  // namespace

void DiffusionLesson::declare_fields() {
    state = {state_array("u", "m/s", u_), state_array("u_before", "m/s", previous_), state_array("elapsed", "s, m²", elapsed_)};
    const auto explicitly = [this] { return is_explicit(); };
    const auto largest = [this] { return blown_up * scale(); };
    const auto largest_stencil = [this] { return 4 * dims() * blown_up * scale(); };
    fields = {
        scalar_field("u", "u", "m/s", On::cell, u_,
                     "what diffuses: a velocity component here, whose diffusion is viscosity; heat and dye do the same"),
        scalar_field("u_before", "u_b", "m/s", On::cell, previous_, "u as the latest step found it"),
        scalar_field("stencil", "s", "m/s", On::cell, stencil_, "sum of the neighbours less as many times u"),
        scalar_field("laplacian", "∇²u", "1/(m s)", On::cell, laplacian_, "s/Δx²: how far u lies below its surroundings"),
        scalar_field("residual", "ρ", "m/s", On::cell, residual_, "what the iterations have left of the implicit equation")};
    for (const std::size_t k : {0u, 1u}) fields[k].bound = largest;
    for (const std::size_t k : {2u, 3u}) fields[k].used = explicitly;
    fields[2].bound = largest_stencil;
    fields[3].bound = [this, largest_stencil] { return largest_stencil() / (dx() * dx()); };
    fields[4].used = [this] { return !is_explicit(); };
    // The first residual is a whole explicit step.
    fields[4].bound = [this, largest_stencil] { return (1 + rate()) * largest_stencil(); };
}

Real DiffusionLesson::scale() const {
    const Real walls = couette() ? std::max(std::abs(wall_low), std::abs(wall_high)) : Real{0};
    if (start == Start::mode) return 1 + walls;
    return start == Start::zero && walls > 0 ? walls : std::max(Real(1), walls);
}

// What changes in the time L²/ν, in which diffusion crosses the row, is a small part of the largest u.
bool DiffusionLesson::at_rest() const {
    constexpr Real part = 1e-4;
    if (elapsed_[0] == 0) return false;
    const Real cells = static_cast<Real>(Index(resolution));
    return (u_ - previous_).lpNorm<Eigen::Infinity>() * cells * cells <= part * scale() * rate();
}

// -------------------------------------------------------------------------------------------------------------- probes

void DiffusionLesson::declare_probes() {
    probes = {
        {.name = "max",
         .symbol = "max u",
         .unit = "m/s",
         .help = "diffusion makes no new maximum",
         .value = [this] { return u_.maxCoeff(); },
         .explain = [this] { return why_extreme(true); }},
        {.name = "min",
         .symbol = "min u",
         .unit = "m/s",
         .help = "diffusion makes no new minimum",
         .value = [this] { return u_.minCoeff(); },
         .explain = [this] { return why_extreme(false); }},
        {.name = "sum",
         .symbol = "Σu",
         .unit = "m/s",
         .help = "over all cells: what one cell loses its neighbour gains, so that it changes at walls alone",
         .value = [this] { return u_.sum(); },
         .explain =
             [this] {
                 std::vector<Input> terms;
                 for (Index c = 0; c < u_.size(); ++c) terms.push_back(Input::now("u_" + std::to_string(c), "u", c));
                 return sum_of("Σu = Σ u_c over the cells", std::move(terms));
             }},
        {.name = "u_selected",
         .symbol = "u_i",
         .unit = "m/s",
         .help = "in the selected cell",
         .value = [this] { return u_[selected_cell()]; },
         .exact = [this](Real t) { return exact(selected_cell(), tau(t)); },
         .explain = [this]() -> Explanation {
             return {fmt::format("u_i = u   (cell {})", selected_cell()), {Input::now("u", "u", selected_cell())}};
         }},
        {.name = "error",
         .symbol = "max|u − u_exact|",
         .unit = "m/s",
         .help = "largest difference from the solution of ∂u/∂t = ν∇²u, where it is known: for one mode, and for a channel that "
                 "starts from rest",
         .value = [this] { return largest_error(); },
         .explain = [this] { return why_error(); }},
        {.name = "time_step",
         .symbol = "Δt",
         .unit = "s",
         .help = "rΔx²/ν: half the cell size means a quarter of the time step",
         .value = [this] { return time_step(); },
         .explain = [this] { return why_time_step(); }},
        {.name = "solver_iterations",
         .help = "of the conjugate gradients in the latest implicit step",
         .value = [this]() -> std::optional<Real> {
             if (is_explicit()) return std::nullopt;
             return static_cast<Real>(diffusion_->iterations());
         }}};
}

void DiffusionLesson::declare_mode_probes() {
    const auto of_seen_mode = [this](auto number) {
        return [this, number]() -> std::optional<Real> {
            return modes_.vanishes(mode) ? std::nullopt : std::optional<Real>(number());
        };
    };
    probes.insert(
        probes.begin(),
        {{.name = "amplitude",
          .symbol = "A",
          .unit = "m/s",
          .help = "of the watched mode: Σ u φ/Σ φ² over the cells, of u less its steady part; undefined of one that is 0 "
                  "on every cell",
          .value = of_seen_mode([this] { return modes_.amplitude(deviation(u_), mode); }),
          .exact = [this](Real t) -> std::optional<Real> {
              const auto from = starting_amplitude();
              return from ? std::optional(*from * std::exp(-modes_.laplace_factor(mode) * tau(t) / (dx() * dx()))) : std::nullopt;
          },
          .explain = [this] { return why_amplitude("u"); }},
         {.name = "factor_measured",
          .symbol = "G",
          .help = "by which the latest step multiplied the watched mode",
          .value = [this] { return measured_factor(); },
          .exact = [this](Real) { return measured_factor() ? std::optional(theory(mode)) : std::nullopt; },
          .explain = [this] { return why_factor(); }},
         {.name = "factor_theory",
          .symbol = "G_r",
          .help = "by which a step of this scheme multiplies the watched mode: explicit 1 − rΛ, implicit 1/(1 + rΛ), Λ "
                  "= 4 sin²(κ/2) per "
                  "axis, with κ the phase from cell to cell",
          .value = of_seen_mode([this] { return theory(mode); }),
          .explain = [this] { return why_theory(); }},
         {.name = "factor_exact",
          .symbol = "G_ν",
          .help = "by which ∂u/∂t = ν∇²u itself multiplies the watched mode in Δt: exp(−ν|k|²Δt)",
          .value = of_seen_mode([this] { return exact_factor(mode); }),
          .explain = [this] { return why_exact_factor(); }}});
}

Real DiffusionLesson::theory(Index m) const {
    return literal() ? lecture_factor(m) : is_explicit() ? explicit_factor(m) : implicit_factor(m);
}

std::optional<Real> DiffusionLesson::measured_factor() const {
    if (elapsed_[0] == 0 || modes_.vanishes(mode)) return std::nullopt;
    const VecX before = deviation(previous_);
    const Real amplitude = modes_.amplitude(before, mode);
    if (std::abs(amplitude) <= least_amplitude * std::max(before.lpNorm<Eigen::Infinity>(), least_amplitude * scale()))
        return std::nullopt;
    return modes_.amplitude(deviation(u_), mode) / amplitude;
}

std::optional<Real> DiffusionLesson::starting_amplitude() const {
    if (modes_.vanishes(mode)) return std::nullopt;
    if (start == Start::mode) return 1;
    if (!(couette() && start == Start::zero)) return std::nullopt;
    return modes_.amplitude(deviation(VecX::Zero(u_.size())), mode);
}

std::optional<Real> DiffusionLesson::largest_error() const {
    if (!exact(0, 0)) return std::nullopt;
    Real largest = 0;
    for (Index c = 0; c < u_.size(); ++c) largest = std::max(largest, std::abs(u_[c] - *exact(c, elapsed_[1])));
    return largest;
}

// --------------------------------------------------------------------------------------------- solutions in closed form

Real DiffusionLesson::steady(Index cell) const {
    if (!couette()) return 0;
    const Real share = (static_cast<Real>(lattice_.coordinates(cell)[0]) + 0.5) / static_cast<Real>(Index(resolution));
    return wall_low + (wall_high - wall_low) * share;
}

VecX DiffusionLesson::deviation(const VecX& u) const {
    if (!couette()) return u;
    return u - VecX::NullaryExpr(u.size(), [this](Index c) { return steady(c); });
}

std::optional<Real> DiffusionLesson::exact(Index cell, Real tau) const {
    const Counts<2> at = lattice_.coordinates(cell);
    return exact_at(static_cast<Real>(at[0]), static_cast<Real>(at[1]), tau);
}

std::optional<Real> DiffusionLesson::exact_at(Real s_x, Real s_y, Real tau) const {
    const Real share = (s_x + 0.5) / static_cast<Real>(Index(resolution));
    if (start == Start::zero) {
        const Real spread = tau / (length * length);
        return couette() ? couette_start_up(share, 1, wall_high, spread) + couette_start_up(1 - share, 1, wall_low, spread)
                         : Real{0};
    }
    if (start != Start::mode) return std::nullopt;
    const Real wave = modes_.shape(mode, s_x) * (dims() == 2 ? modes_.shape(mode, s_y) : 1);
    const Real rest = couette() ? wall_low + (wall_high - wall_low) * share : Real{0};
    return rest + wave * std::exp(-modes_.laplace_factor(mode) * tau / (dx() * dx()));
}

// --------------------------------------------------------------------------------------------------------------- lines

void DiffusionLesson::declare_lines() {
    lines = {
        {.name = "profile",
         .unit = "m/s",
         .position_name = "x",
         .position_unit = "m",
         .help = "u along the row of the selected cell, with the solution of the equation where it is known",
         .sample = [this](Curve& curve) { profile(curve); },
         .reference = [this](Curve& curve) { exact_profile(curve); },
         .value_name = "u"},
        {.name = "factors",
         .position_name = "mode m",
         .help =
             "by which a step multiplies each mode that the cells can hold: measured in the latest step where there is some of "
             "it, and as theory has it. Beyond ±1 a mode grows",
         .sample = [this](Curve& curve) { measured_factors(curve); },
         .reference = [this](Curve& curve) { theory_factors(curve, &DiffusionLesson::exact_factor); },
         .reference_name = "equation: exp(−ν|k|²Δt)",
         .value_name = "factor of a step",
         .others = {{"explicit: 1 − rΛ", [this](Curve& curve) { theory_factors(curve, &DiffusionLesson::explicit_factor); }},
                    {"implicit: 1/(1 + rΛ)", [this](Curve& curve) { theory_factors(curve, &DiffusionLesson::implicit_factor); }},
                    {"as on the slide",
                     [this](Curve& curve) {
                         if (literal()) theory_factors(curve, &DiffusionLesson::lecture_factor);
                     }},
                    {"watched mode",
                     [this](Curve& curve) {
                         curve = {};
                         if (modes_.vanishes(mode)) return;
                         curve.position = {static_cast<Real>(Index(mode))};
                         curve.value = {theory(mode)};
                     },
                     true}}}};
}

void DiffusionLesson::profile(Curve& curve) const {
    const Index n = resolution, row = selected()[1];
    curve.position.resize(static_cast<std::size_t>(n)), curve.value.resize(static_cast<std::size_t>(n));
    for (Index i = 0; i < n; ++i) {
        curve.position[static_cast<std::size_t>(i)] = (static_cast<Real>(i) + 0.5) * dx();
        curve.value[static_cast<std::size_t>(i)] = u_[lattice_.index({i, row})];
    }
}

// Between the cells too, so that a wave is seen that the cells take for another one.
void DiffusionLesson::exact_profile(Curve& curve) const {
    constexpr int points = 257;
    curve = {};
    if (!exact(0, 0)) return;
    for (int k = 0; k < points; ++k) {
        const Real share = static_cast<Real>(k) / (points - 1);
        curve.position.push_back(share * length);
        curve.value.push_back(
            *exact_at(share * static_cast<Real>(Index(resolution)) - 0.5, static_cast<Real>(selected()[1]), elapsed_[1]));
    }
}

void DiffusionLesson::measured_factors(Curve& curve) const {
    curve = {};
    if (elapsed_[0] == 0) return;
    const VecX before = modes_.amplitudes(deviation(previous_)), after = modes_.amplitudes(deviation(u_));
    const Real least = least_amplitude * before.lpNorm<Eigen::Infinity>();
    for (Index k = 0; k < before.size(); ++k) {
        if (!(std::abs(before[k]) > least)) continue;
        curve.position.push_back(static_cast<Real>(modes_.least() + k));
        curve.value.push_back(after[k] / before[k]);
    }
}

// The scheme that is not used must not squeeze the plot: its curve ends where it leaves ±1.5.
void DiffusionLesson::theory_factors(Curve& curve, Real (DiffusionLesson::*factor)(Index) const) const {
    constexpr Real outside = 1.5;
    curve = {};
    const bool whole = is_explicit() && !literal();
    for (Index m = modes_.least(); m <= modes_.greatest(); ++m) {
        const Real value = (this->*factor)(m);
        if (!whole && std::abs(value) > outside) break;
        curve.position.push_back(static_cast<Real>(m));
        curve.value.push_back(value);
    }
}

}  // namespace pliant::diffusion
