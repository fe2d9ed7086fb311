// The start of a flow between two walls: a fluid at rest whose walls begin to move [Batchelor1967 §4.3].
#pragma once
#include <pliant/math/types.h>

namespace pliant::diffusion {

// The velocity [m/s] at the share x of the way from the wall that moves at `low` to the one that moves at `high` [m/s], after
// τ = ∫ν dt/H² (dimensionless), from the series Σ sin(mπx) exp(−m²π²τ).
Real couette_startup(Real x, Real tau, Real low, Real high);

}  // namespace pliant::diffusion
