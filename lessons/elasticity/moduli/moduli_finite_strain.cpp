// What the same tests measure of a material that knows finite strain, to lay beside the straight line of the linear one.
#include <pliant/continuum/uniaxial.h>

#include "moduli.h"

#include <algorithm>
#include <cmath>

namespace pliant::moduli {
namespace {

// Of the drawn range of strains, as a multiple of that of the linear test; and the least range, where a curve shows as one.
constexpr Real beyond = 2, least_range = 0.06;
constexpr int samples = 40;

// Force over area at rest [Pa] that holds the block at this strain; empty where the material cannot be held there.
std::optional<Real> stress_at(Test test, const EnergyDensity<3>& energy, Real strain) {
    switch (test) {
        case Test::tension:
            return uniaxial_stress(energy, 1 + strain);
        case Test::shear: {
            Mat<3> F = Mat<3>::Identity();
            F(0, 1) = strain;
            return energy.P(F)(0, 1);
        }
        case Test::pressure: {
            // The strain is the change of volume.
            if (strain <= -1) return std::nullopt;
            return -energy.P(std::cbrt(1 + strain) * Mat<3>::Identity())(0, 0);
        }
    }
    return std::nullopt;
}

}  // namespace

void ModuliLesson::finite_strain_curve(Energy energy, Curve& curve) const {
    curve.position.clear(), curve.value.clear();
    const EnergyDensity<3> density(energy, material().lame());
    const Real full = specimen_->exact_strain(load);
    if (full == 0) return;
    const Real end = std::copysign(std::clamp(beyond * std::abs(full), least_range, Real{0.9}), full);
    for (int k = 0; k <= samples; ++k) {
        const Real strain = end * k / samples;
        const auto stress = stress_at(test, density, strain);
        if (!stress || !std::isfinite(*stress)) return;
        curve.position.push_back(strain), curve.value.push_back(*stress);
    }
}

}  // namespace pliant::moduli
