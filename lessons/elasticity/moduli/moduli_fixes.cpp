// Which parameters would mend a test, and which make a finer one.
#include "moduli.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::moduli {

// The strain is proportional to the load.
std::optional<Fix> ModuliLesson::smaller_load() const {
    const Real scale = 0.8 * small_strain / strain_.cwiseAbs().maxCoeff();
    const Real smaller = std::copysign(rounded_down(scale * std::abs(applied()), 2), load);
    return Fix{fmt::format("σ = {}", format_quantity(smaller, "Pa")), {{"load", format_exact(smaller)}}};
}

std::optional<Fix> ModuliLesson::compressible() const { return Fix{"ν = 0.45", {{"poisson_ratio", "0.45"}}}; }

std::optional<Fix> ModuliLesson::more_iterations() const {
    if (solver_->status() != ConjugateGradients::Status::capped) return poisson_ratio > 0.45 ? compressible() : std::nullopt;
    const Real more = std::min(std::max(max_iterations.info.initial, 10 * max_iterations.value()), max_iterations.accepted().max);
    return Fix{fmt::format("max_iterations = {:.0f}", more), {{"max_iterations", format_exact(more)}}};
}

std::optional<Fix> ModuliLesson::fix(const Failure&) const {
    if (poisson_ratio > 0.45) return compressible();
    if (resolution == 1) return std::nullopt;
    const Index coarser = resolution / 2;
    return Fix{fmt::format("n = {}", coarser), {{"resolution", std::to_string(coarser)}}};
}

// A mesh of half the cell size, solved to the last digits.
std::vector<std::pair<std::string, std::string>> ModuliLesson::finer() const {
    const Index most = static_cast<Index>(resolution.accepted().max);
    return {{"resolution", std::to_string(std::min<Index>(2 * resolution, most))},
            {"tolerance", format_exact(std::min<Real>(tolerance, 1e-13))},
            {"max_iterations", format_exact(std::max(max_iterations.value(), max_iterations.info.initial))}};
}

}  // namespace pliant::moduli
