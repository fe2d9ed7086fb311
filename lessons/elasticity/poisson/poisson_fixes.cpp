// Where the laws of the cube and the elements of the panel hold, and what mends a run.
#include "poisson.h"

#include "contraction_law.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::poisson {
namespace {

// Of the narrowing, that an estimate may be off.
constexpr Real accurate = 0.05;
// Linear triangles and tetrahedra lock above it wherever the strain is not uniform.
constexpr Real locking_ratio = 0.49;

}  // namespace

void PoissonLesson::declare_checks() {
    const auto small_strain = [this]() -> std::optional<Fix> {
        const auto limit = strain_of_overestimate(std::max<Real>(poisson_ratio, -0.5), accurate);
        const Real strain = std::copysign(rounded_down(0.9 * limit.value_or(0.05), 2), axial_strain.value());
        return Fix{fmt::format("ΔL/L = {}", format_quantity(strain, "")), {{"axial_strain", format_exact(strain)}}};
    };
    assumptions = {
        {.name = "estimate good enough",
         .value = [this] { return std::abs(overestimate(poisson_ratio, reached())); },
         .limit = [] { return accurate; },
         .formula = "|ν s / (1 − (1 + s)^(−ν)) − 1| ≤ 5 %",
         .broken = "ν ΔL/L is meant for small strain: it overestimates the narrowing of a pulled cube, and underestimates the "
                   "widening of a pushed one",
         .used = [this] { return !bends() && done() > 0; },
         .fix = small_strain},
        {.name = "enough steps",
         .value =
             [this] {
                 const Real law = exact_contraction(poisson_ratio, reached());
                 return law == 0 ? Real{0} : std::abs(contractions_[done()] / law - 1);
             },
         .limit = [] { return accurate; },
         .formula = "|ΔL′/L − exact| ≤ 5 % of it",
         .broken = "each step takes the strain over the length at its start: the error is of first order in the step",
         .used = [this] { return !bends() && done() > 0; },
         .fix = [this]() -> std::optional<Fix> {
             const Index more = std::min<Index>(std::max<Index>(20, 4 * increments), 1000);
             return Fix{fmt::format("incremental, N = {}", more),
                        {{"method", "incremental"}, {"increments", std::to_string(more)}}};
         }},
        {.name = "no locking",
         .value = [this] { return Real(poisson_ratio); },
         .limit = [] { return locking_ratio; },
         .formula = "ν ≤ 0.49",
         .broken =
             "linear triangles and tetrahedra cannot bend without changing their volume, so near ν = ½ they hardly bend at all; "
             "the stretched cube, whose strain is uniform, stays right",
         .fix = []() -> std::optional<Fix> {
             return Fix{"ν = 0.45", {{"poisson_ratio", "0.45"}}};
         }}};
}

std::optional<Fix> PoissonLesson::fix(const Failure&) const { return Fix{"ν = 0.3", {{"poisson_ratio", "0.3"}}}; }

std::vector<std::pair<std::string, std::string>> PoissonLesson::finer() const {
    if (bends()) return {{"membrane_cells", std::to_string(std::min<Index>(2 * membrane_cells, 32))}};
    return {{"method", "incremental"}, {"increments", std::to_string(std::min<Index>(4 * increments, 1000))}};
}

}  // namespace pliant::poisson
