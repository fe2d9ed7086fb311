// What the lesson shows and measures: fields, probes, lines.
#include "diffusion.h"

#include <pliant/fluids/channel_flow.h>

#include <fmt/format.h>

#include <algorithm>

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
    fields = {scalar_field("u", "u", "m/s", On::cell, u_,
                           "what diffuses: a velocity component here, whose diffusion is viscosity; heat and dye do the same")
                  .of_both_signs()
                  .stops_at(largest),
              scalar_field("u_before", "u_b", "m/s", On::cell, previous_, "u as the latest step found it")
                  .of_both_signs()
                  .stops_at(largest),
              scalar_field("stencil", "s", "m/s", On::cell, stencil_, "sum of the neighbours less as many times u")
                  .of_both_signs()
                  .stops_at(largest_stencil)
                  .when(explicitly),
              scalar_field("laplacian", "∇²u", "1/(m s)", On::cell, laplacian_, "s/Δx²: how far u lies below its surroundings")
                  .of_both_signs()
                  .stops_at([this, largest_stencil] { return largest_stencil() / (dx() * dx()); })
                  .when(explicitly),
              // The first residual is a whole explicit step.
              scalar_field("residual", "ρ", "m/s", On::cell, residual_, "what the iterations have left of the implicit equation")
                  .of_both_signs()
                  .stops_at([this, largest_stencil] { return (1 + rate()) * largest_stencil(); })
                  .when([this] { return !is_explicit(); })};
}

// What changes in the time L²/ν, in which diffusion crosses the row, is a small part of the largest u.
bool DiffusionLesson::at_rest() const {
    constexpr Real part = 1e-4;
    if (elapsed_[0] == 0) return false;
    const Real cells = resolution.value();
    return (u_ - previous_).lpNorm<Eigen::Infinity>() * cells * cells <= part * scale() * rate();
}

// -------------------------------------------------------------------------------------------------------------- probes

void DiffusionLesson::declare_probes() {
    const auto seen = [this] { return !modes_.vanishes(mode); };
    probes = {
        probe_of(
            "amplitude", "A", "m/s",
            "of the watched mode: Σ u φ/Σ φ² over the cells, of u less its steady part; undefined of one that is 0 "
            "on every cell",
            [this] { return modes_.amplitude(deviation(u_), mode); }, [this] { return why_amplitude("u"); })
            .exactly([this](Real t) -> std::optional<Real> {
                const auto from = starting_amplitude();
                if (!from) return std::nullopt;
                return *from * std::exp(-modes_.laplace_factor(mode) * tau(t) / (dx() * dx()));
            })
            .when(seen),
        probe_of(
            "factor_measured", "G", "", "by which the latest step multiplied the watched mode",
            [this] { return measured_factor(); },
            [this]() -> Explanation {
                return {"G = A / A_b",
                        {Input::part("A", "m/s", why_amplitude("u")), Input::part("A_b", "m/s", why_amplitude("u_before"))}};
            })
            .exactly([this](Real) { return measured_factor() ? std::optional(theory(mode)) : std::nullopt; }),
        probe_of(
            "factor_theory", "G_r", "",
            "by which a step of this scheme multiplies the watched mode: explicit 1 − rΛ, implicit 1/(1 + rΛ), Λ "
            "= 4 sin²(κ/2) per axis, with κ the phase from cell to cell",
            [this] { return theory(mode); }, [this] { return why_theory(); })
            .when(seen),
        probe_of(
            "factor_exact", "G_ν", "", "by which ∂u/∂t = ν∇²u itself multiplies the watched mode in Δt: exp(−ν|k|²Δt)",
            [this] { return exact_factor(mode); },
            [this]() -> Explanation {
                return {dims() == 1 ? "G_ν = exp(−r κ²)" : "G_ν = exp(−2 r κ²)",
                        {why_rate(), Input::constant("κ", modes_.phase(mode), "rad", "k Δx: phase from one cell to the next")}};
            })
            .when(seen),
        probe_of(
            "max", "max u", "m/s", "diffusion makes no new maximum", [this] { return u_.maxCoeff(); },
            [this] { return why_extreme(true); }),
        probe_of(
            "min", "min u", "m/s", "diffusion makes no new minimum", [this] { return u_.minCoeff(); },
            [this] { return why_extreme(false); }),
        probe_of(
            "sum", "Σu", "m/s", "over all cells: what one cell loses its neighbour gains, so that it changes at walls alone",
            [this] { return u_.sum(); },
            [this] {
                std::vector<Input> terms;
                for (Index c = 0; c < u_.size(); ++c) terms.push_back(Input::now("u_" + std::to_string(c), "u", c));
                return sum_of("Σu = Σ_c u_c, over the cells", "u_c", std::move(terms));
            }),
        probe_of(
            "u_selected", "u_i", "m/s", "in the selected cell", [this] { return u_[selected_cell()]; },
            [this]() -> Explanation {
                return {fmt::format("u_i = u   (cell {})", selected_cell()), {Input::now("u", "u", selected_cell())}};
            })
            .exactly([this](Real t) { return exact(selected_cell(), tau(t)); }),
        probe_of(
            "error", "max|u − u_exact|", "m/s",
            "largest difference from the solution of ∂u/∂t = ν∇²u, where it is known: for one mode, and for a channel that "
            "starts from rest",
            [this] { return error_in(worst_cell()); },
            [this]() -> Explanation {
                const Index at = worst_cell();
                return {fmt::format("max|u − u_exact| = |u − u_x|   (largest in cell {})", at),
                        {Input::now("u", "u", at),
                         Input::constant("u_x", *exact(at, elapsed_[1]), "m/s", "solution of ∂u/∂t = ν∇²u")}};
            })
            .when([this] { return exact(0, 0).has_value(); }),
        probe_of(
            "time_step", "Δt", "s", "rΔx²/ν: half the cell size means a quarter of the time step", [this] { return time_step(); },
            [this] { return why_time_step(); }),
        probe_of("solver_iterations", "", "", "of the conjugate gradients in the latest implicit step", [this] {
            return static_cast<Real>(diffusion_->iterations());
        }).when([this] { return !is_explicit(); })};
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

Index DiffusionLesson::worst_cell() const {
    Index worst = 0;
    for (Index c = 1; c < u_.size(); ++c)
        if (error_in(c) > error_in(worst)) worst = c;
    return worst;
}

// --------------------------------------------------------------------------------------------- solutions in closed form

std::optional<Real> DiffusionLesson::exact_at(Real s_x, Real s_y, Real tau) const {
    const Real share = (s_x + 0.5) / resolution.value();
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
        line_of("profile", "m/s", "x", "m",
                "u along the row of the selected cell, with the solution of the equation where it is known",
                [this](Curve& curve) { profile(curve); })
            .against("exact", [this](Curve& curve) { exact_profile(curve); })
            .measures("u"),
        line_of(
            "factors", "", "mode m", "",
            "by which a step multiplies each mode that the cells can hold: measured in the latest step where there is some of "
            "it, and as theory has it. Beyond ±1 a mode grows",
            [this](Curve& curve) { measured_factors(curve); })
            .against("equation: exp(−ν|k|²Δt)", [this](Curve& curve) { theory_factors(curve, &DiffusionLesson::exact_factor); })
            .measures("factor of a step")
            .beside({{"explicit: 1 − rΛ", [this](Curve& curve) { theory_factors(curve, &DiffusionLesson::explicit_factor); }},
                     {"implicit: 1/(1 + rΛ)", [this](Curve& curve) { theory_factors(curve, &DiffusionLesson::implicit_factor); }},
                     {"as on the slide",
                      [this](Curve& curve) {
                          if (literal()) theory_factors(curve, &DiffusionLesson::lecture_factor);
                      }},
                     {"watched mode",
                      [this](Curve& curve) {
                          curve = {};
                          if (modes_.vanishes(mode)) return;
                          curve.position = {mode.value()};
                          curve.value = {theory(mode)};
                      },
                      true}})};
}

// Between the cells too, so that a wave is seen that the cells take for another one.
void DiffusionLesson::exact_profile(Curve& curve) const {
    constexpr int points = 257;
    curve = {};
    if (!exact(0, 0)) return;
    for (int k = 0; k < points; ++k) {
        const Real share = static_cast<Real>(k) / (points - 1);
        curve.position.push_back(share * length);
        curve.value.push_back(*exact_at(share * resolution.value() - 0.5, static_cast<Real>(selected()[1]), elapsed_[1]));
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
