// How much a cube narrows when it is stretched, by Poisson's ratio: nu relates small changes of logarithmic strain.
#pragma once
#include <pliant/math/types.h>

#include <optional>

namespace pliant {

// dL'/L = 1 - (1 + dL/L)^-nu, for an axial strain above -1.
Real exact_contraction(Real nu, Real axial_strain);
// dL'/L = nu dL/L, the estimate for small strain.
Real linear_contraction(Real nu, Real axial_strain);
// V/V0 = (1 + dL/L)^(1 - 2 nu).
Real exact_volume_ratio(Real nu, Real axial_strain);
// Of the linear estimate, over the exact contraction; at nu = 0 its limit.
Real linear_overestimate(Real nu, Real axial_strain);

// The axial strain > 0 at which the estimate is too large by this share: 0.01 for 1 %. Empty where it is beyond 10^9, for nu near
// -1.
std::optional<Real> strain_of_overestimate(Real nu, Real share);

}  // namespace pliant
