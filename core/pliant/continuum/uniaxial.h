// A bar that is pulled along x and free across: what its width becomes, and the stress that the pull takes.
#pragma once
#include <pliant/continuum/energy_density.h>

#include <optional>

namespace pliant {

// The stretch a across, equal in y and z, at which F = diag(s, a, a) has no stress across: the branch that starts from a = 1 at
// the stretch s = 1. Empty where that branch has ended: neo-Hookean at s <= 0, and with lambda < 0 where no width is in
// equilibrium; corotated where its rotation is no longer unique (a <= 0 or s + a <= 0). StVK has become a line, a = 0, where
// nu (s^2 - 1) >= 1.
std::optional<Real> lateral_stretch(const EnergyDensity<3>& energy, Real s);

// P_xx [Pa] of that bar; empty where the width is.
std::optional<Real> uniaxial_stress(const EnergyDensity<3>& energy, Real s);

}  // namespace pliant
