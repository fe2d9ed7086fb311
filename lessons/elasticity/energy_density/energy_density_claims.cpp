// E14: what the lecture says of energy densities, measured along a pulled and pressed bar.
#include <pliant/continuum/uniaxial.h>
#include <pliant/study/claims.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant::energy_density {
namespace {

constexpr Real Y = 1e6;

EnergyDensity<3> rubber(Energy energy, Real poisson_ratio = 0.3) {
    return {energy, IsotropicModuli::from_young_poisson(Y, poisson_ratio).lame()};
}

// Stretch at which the stress of a pressed bar is least, by golden section; the stress has one minimum in (0.3, 0.9).
Real stretch_of_least_stress(const EnergyDensity<3>& energy) {
    const Real golden = (std::sqrt(5.0) - 1) / 2;
    Real low = 0.3, high = 0.9;
    while (high - low > 1e-9) {
        const Real a = high - golden * (high - low), b = low + golden * (high - low);
        if (*uniaxial_stress(energy, a) < *uniaxial_stress(energy, b))
            high = b;
        else
            low = a;
    }
    return (low + high) / 2;
}

// Volume ratio of a bar that is pressed to this stretch.
Real volume_of_bar(const EnergyDensity<3>& energy, Real s) {
    const Real a = *lateral_stretch(energy, s);
    return s * a * a;
}

Finding energies_differ() {
    const EnergyDensity<3> stvk = rubber(Energy::stvk), neo = rubber(Energy::neo_hookean);
    const Real softest = stretch_of_least_stress(stvk), least = *uniaxial_stress(stvk, softest);
    const Real flat = *uniaxial_stress(stvk, 0.01), inverted = *uniaxial_stress(stvk, -0.1);
    const Real half = *uniaxial_stress(neo, 0.5), tenth = *uniaxial_stress(neo, 0.1), hundredth = *uniaxial_stress(neo, 0.01);
    const Real kept = volume_of_bar(rubber(Energy::neo_hookean, 0.4999), 0.5), lost = volume_of_bar(neo, 0.5);
    const bool softens = std::abs(least + Y / (3 * std::sqrt(3.0))) < 1e-6 * Y && flat > 0.1 * least && inverted > 0;
    const bool resists = half > tenth && tenth > hundredth && hundredth < -10 * Y && std::abs(kept - 1) < 1e-3;
    const Real miss = std::abs(softest - 1 / std::sqrt(3.0));
    return {
        .figure = miss,
        .verdict = softens && resists && miss <= 1e-6 ? Verdict::reproduced : Verdict::refuted,
        .text = fmt::format("Pressed, StVK pushes back most at s = {} with {}, then gives way: {} at s = 0.01, and beyond zero "
                            "it pulls through. Neo-Hookean pushes with {}, {}, {} at s = 0.5, 0.1, 0.01. At s = 0.5 its "
                            "volume is {} at ν = 0.4999, {} at ν = 0.3.",
                            format_quantity(softest, "", 5), format_quantity(least, "Pa", 4), format_quantity(flat, "Pa", 3),
                            format_quantity(half, "Pa", 3), format_quantity(tenth, "Pa", 3), format_quantity(hundredth, "Pa", 3),
                            format_quantity(kept, "", 4), format_quantity(lost, "", 3))};
}

const ClaimRegistration e14{"E14", energies_differ};

}  // namespace
}  // namespace pliant::energy_density
