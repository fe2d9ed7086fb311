#include <pliant/solids/cooks_membrane_table.h>

namespace pliant {

std::optional<Real> converged_deflection(Real nu) {
    const auto& [a, b, unused_1, unused_2, c] = converged_membrane;
    if (nu < a.nu || nu > c.nu) return std::nullopt;
    const Real first = (b.deflection - a.deflection) / (b.nu - a.nu), second = (c.deflection - b.deflection) / (c.nu - b.nu),
               bend = (second - first) / (c.nu - a.nu);
    return a.deflection + first * (nu - a.nu) + bend * (nu - a.nu) * (nu - b.nu);
}

}  // namespace pliant
