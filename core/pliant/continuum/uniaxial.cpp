#include <pliant/continuum/uniaxial.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

// b = a^2 solves g(c) = mu (e^c - 1) + lambda (ln s + c) = 0 with c = ln b, and g is convex where it rises: Newton's method from
// a point where g >= 0 comes down to the root without passing it.
std::optional<Real> neo_hookean_width(const Lame& material, Real s) {
    if (!(s > 0)) return std::nullopt;
    const Real lambda = material.lambda, mu = material.mu, ln_s = std::log(s);
    const auto g = [&](Real c) { return mu * std::expm1(c) + lambda * (ln_s + c); };
    // With lambda < 0 it rises only beyond its minimum.
    if (lambda < 0) {
        const Real lowest = std::log(-lambda / mu);
        if (g(lowest) > 0) return std::nullopt;
    }
    Real c = std::max(Real{0}, -ln_s);
    while (g(c) < 0) c = 2 * c + 1;
    for (int i = 0; i < 200; ++i) {
        const Real step = g(c) / (mu * std::exp(c) + lambda);
        c -= step;
        if (!(std::abs(step) > 1e-15 * (1 + std::abs(c)))) break;
    }
    return std::exp(0.5 * c);
}

}  // namespace

std::optional<Real> lateral_stretch(const EnergyDensity<3>& energy, Real s) {
    const auto [lambda, mu] = energy.material();
    const Real nu = lambda / (2 * (lambda + mu));
    switch (energy.energy()) {
        case Energy::linear:
            return 1 - nu * (s - 1);
        case Energy::stvk:
            return std::sqrt(std::max(Real{0}, 1 - nu * (s * s - 1)));
        case Energy::corotated: {
            const Real a = 1 - nu * (s - 1);
            if (a > 0 && s + a > 0) return a;
            return std::nullopt;
        }
        case Energy::neo_hookean:
            return neo_hookean_width(energy.material(), s);
    }
    return std::nullopt;
}

std::optional<Real> uniaxial_stress(const EnergyDensity<3>& energy, Real s) {
    const std::optional<Real> a = lateral_stretch(energy, s);
    if (!a) return std::nullopt;
    return energy.P(Vec<3>(s, *a, *a).asDiagonal().toDenseMatrix())(0, 0);
}

}  // namespace pliant
