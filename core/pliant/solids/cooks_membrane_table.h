// The deflection of Cook's membrane in plane strain, Y = 1 Pa, F = 1 N/m, at the middle of the loaded edge, converged.
#pragma once
#include <pliant/math/types.h>

#include <array>
#include <optional>

namespace pliant {

// By cubic triangles on 32 × 32 cells with an independent finite-element package [m].
struct ConvergedDeflection {
    Real nu, deflection;
};
inline constexpr std::array<ConvergedDeflection, 5> converged_membrane{
    {{0.3, 21.94}, {0.45, 19.55}, {0.49, 18.69}, {0.499, 18.48}, {0.4999, 18.46}}};

// Between them by the parabola through the first, the second and the last, which meets the others to the last digit; empty
// outside.
std::optional<Real> converged_deflection(Real nu);

}  // namespace pliant
