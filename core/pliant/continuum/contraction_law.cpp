#include <pliant/continuum/contraction_law.h>

#include <cmath>

namespace pliant {
namespace {

constexpr Real largest_strain = 1e9;

}  // namespace

Real exact_contraction(Real nu, Real s) { return -std::expm1(-nu * std::log1p(s)); }

Real linear_contraction(Real nu, Real s) { return nu * s; }

Real exact_volume_ratio(Real nu, Real s) { return std::exp((1 - 2 * nu) * std::log1p(s)); }

Real linear_overestimate(Real nu, Real s) {
    const Real ratio = std::abs(nu) < 1e-12 ? s / std::log1p(s) : linear_contraction(nu, s) / exact_contraction(nu, s);
    return ratio - 1;
}

std::optional<Real> strain_of_overestimate(Real nu, Real share) {
    if (linear_overestimate(nu, largest_strain) < share) return std::nullopt;
    // It grows with the strain, from 0 at rest: halving on a logarithmic scale.
    Real low = 1e-9, high = largest_strain;
    for (int i = 0; i < 200 && high / low > 1 + 1e-15; ++i) {
        const Real middle = std::sqrt(low * high);
        (linear_overestimate(nu, middle) < share ? low : high) = middle;
    }
    return high;
}

}  // namespace pliant
