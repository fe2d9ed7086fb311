// Under which conditions the result can be trusted, what a run must obey, and which parameters mend what does not.
#include "diffusion.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace pliant::diffusion {
namespace {

constexpr Real most_decay = 0.5;          // νk²Δt: there an implicit step errs by a tenth
constexpr Real most_waves = Real(1) / 8;  // per cell: there the stencil's decay errs by 5 %
constexpr Index finest = 256;

}  // namespace

void DiffusionLesson::declare_checks() {
    const auto careful = [this] { return is_explicit() && !literal(); };
    assumptions = {
        assumption_of(
            "explicit limit", "", [this] { return rate(); }, [this] { return limit(); }, "νΔt/Δx² ≤ 1/2 in 1D, 1/4 in 2D",
            "the shortest wave overshoots: each step turns its sign and makes it larger, until nothing else is seen")
            .when(careful)
            .mended_by([this] { return stable_again(); }),
        assumption_of(
            "the slide's formula is complete", "", [] { return Real{2}; }, [] { return Real{0}; },
            "terms left out: the old u, and 1/Δx²",
            "u ← νΔt Σ keeps only the increment, and of that not the 1/Δx²: the first step leaves almost nothing of u")
            .when([this] { return literal(); })
            .mended_by(Fix{"form = careful", {{"form", "careful"}}}),
        assumption_of(
            "mode resolved in time", "", [this] { return rate() * modes_.laplace_factor(mode); }, [] { return most_decay; },
            "ν|k|²Δt ≤ 0.5, of the watched mode",
            "it decays by much within one step: the factor of the scheme is not exp(−ν|k|²Δt), stable or not")
            .mended_by([this] { return fix_by(diffusion_number, rounded_down(0.8 * most_decay / modes_.laplace_factor(mode))); }),
        assumption_of(
            "mode resolved in space", "", [this] { return modes_.phase(mode) / (2 * std::numbers::pi); },
            [] { return most_waves; }, "at least 8 cells per wave",
            "the stencil lets a short wave live too long; with fewer than 2 cells per wave the cells show another wave")
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
            "The slide's formula multiplies the shortest wave by −{}νΔt/(1 m²) = {} in every step: set form to careful", shortest,
            format_quantity(-shortest * rate() * dx() * dx(), "", 3));
    if (!is_explicit()) return "An implicit step has no limit of stability: lower diffusion_number below 1e6, or raise tolerance";
    return fmt::format(
        "r = νΔt/Δx² = {} is above the limit of the explicit stencil, {}: the shortest wave is multiplied by 1 − {}r = {} in "
        "every "
        "step. Lower diffusion_number to {} or less, or set scheme to implicit",
        format_quantity(rate(), "", 3), limit_text, shortest, format_quantity(1 - shortest * rate(), "", 3), limit());
}

// With r as it is, half the cell size means a quarter of the time step: both errors fall alike.
std::vector<std::pair<std::string, std::string>> DiffusionLesson::finer() const {
    if (start == Start::random || start == Start::checkerboard || start == Start::spike || resolution == finest) return {};
    return {{"resolution", std::to_string(std::min<Index>(2 * resolution, finest))}};
}

}  // namespace pliant::diffusion
