// What would mend a deformation that an energy does not bear.
#include "energy_density.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant::energies {

// Half of the way back to rest, or a stretch that every energy bears.
Fix EnergyDensityLesson::towards_rest() const {
    if (way().stretches()) return {"s = 0.8", {{"stretch", "0.8"}}};
    if (is(Path::shear)) return {"γ = 0.5", {{"shear", "0.5"}}};
    Fix fix{"F = I", {}};
    for (const std::string_view key : {"F12", "F13", "F21", "F23", "F31", "F32"}) fix.assign.emplace_back(key, "0");
    for (const std::string_view key : {"F11", "F22", "F33"}) fix.assign.emplace_back(key, "1");
    return fix;
}

// Neo-Hookean does not go to s <= 0: the stretch is then mended with it.
Fix EnergyDensityLesson::another_energy(Energy better) const {
    Fix fix = better == Energy::neo_hookean ? Fix{"neo-Hookean", {{"energy", "neo_hookean"}}}
                                            : Fix{"corotated", {{"energy", "corotated"}}};
    if (way().at(density(better), amount())) return fix;
    const Fix back = towards_rest();
    fix.label += fmt::format(", {}", back.label);
    fix.assign.insert(fix.assign.end(), back.assign.begin(), back.assign.end());
    return fix;
}

std::optional<Fix> EnergyDensityLesson::fix(const Failure&) const { return towards_rest(); }

std::string EnergyDensityLesson::blow_up_hint() const {
    return fmt::format(
        "det F = {}: the neo-Hookean energy grows without bound as the cube becomes flat. Take a stretch nearer to 1",
        format_quantity(J_[0], ""));
}

}  // namespace pliant::energies
