// Where in the plane of z = λ Δt one step of a scheme makes no motion larger.
#pragma once
#include <pliant/time/stability.h>

#include <array>
#include <complex>
#include <vector>

namespace pliant {

// The set of all z = omega dt (-zeta + i sqrt(1 - zeta^2)) whose amplification is at most 1, for -1 <= zeta <= 1.
struct StabilityRegion {
    using Point = std::array<Real, 2>;         // Re z, Im z
    std::vector<std::array<Point, 4>> pieces;  // of its inside, corner by corner
    std::vector<std::array<Point, 2>> border;
};

// The part of the plane that is looked at.
inline constexpr Real region_left = -4.2, region_right = 1.8, region_high = 3;

StabilityRegion stability_region(Scheme scheme);

// The growth of a motion with these roots.
Real growth_at(Scheme scheme, std::complex<Real> z);

}  // namespace pliant
