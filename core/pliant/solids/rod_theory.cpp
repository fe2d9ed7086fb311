#include <pliant/solids/rod_theory.h>

#include <cmath>
#include <numbers>

namespace pliant {

using std::numbers::pi;

Real UniformRod::wave_speed() const { return std::sqrt(axial_stiffness * length / mass); }

Real UniformRod::hanging_displacement(Real s, Real gravity) const {
    return mass * gravity / axial_stiffness * (s - 0.5 * s * s / length);
}

Real UniformRod::hanging_strain(Real s, Real gravity) const { return mass * gravity / axial_stiffness * (1 - s / length); }

Real UniformRod::hanging_energy(Real gravity) const { return mass * gravity * mass * gravity * length / (6 * axial_stiffness); }

// About its rest: u − u_rest starts at −u_rest, continued odd about the support and even about the free end.
Real UniformRod::released_displacement(Real s, Real t, Real gravity) const {
    const auto continued = [&](Real xi) {
        const Real turns = std::floor(xi / (2 * length)), inside = xi - 2 * length * turns;
        return (std::fmod(std::abs(turns), 2) == 0 ? 1 : -1) * hanging_displacement(inside, gravity);
    };
    const Real travelled = wave_speed() * t;
    return hanging_displacement(s, gravity) - 0.5 * (continued(s - travelled) + continued(s + travelled));
}

Real UniformRod::wave_number(Index j, RodEnd end) const {
    return (static_cast<Real>(j) - (end == RodEnd::free ? 0.5 : 0)) * pi / length;
}

// F(ξ) or F′(ξ), where u = F(s − ct) − F(−s − ct) and F(ξ) = ∓F(ξ − 2L) at a free or a fixed end.
Real RunningPulse::image(Real xi, bool slope) const {
    const Real nearest = std::round((xi - start) / (2 * length)), reach = 1 + std::ceil(3 * width / length);
    Real sum = 0;
    for (Real m = nearest - reach; m <= nearest + reach; ++m) {
        const Real off = (xi - start - 2 * length * m) / width;
        const Real value = amplitude * std::exp(-off * off) * (slope ? -2 * off / width : 1);
        sum += end == RodEnd::free && std::fmod(std::abs(m), 2) == 1 ? -value : value;
    }
    return sum;
}

Real RunningPulse::displacement(Real s, Real t) const { return image(s - speed * t, false) - image(-s - speed * t, false); }

Real RunningPulse::velocity(Real s, Real t) const { return speed * (image(-s - speed * t, true) - image(s - speed * t, true)); }

Real RunningPulse::strain(Real s, Real t) const { return image(s - speed * t, true) + image(-s - speed * t, true); }

Real MassChain::hanging_tip(Real gravity) const {
    const auto n = static_cast<Real>(springs);
    return mass * gravity * n * (n + 1) / (2 * stiffness);
}

Real MassChain::phase(Index j, RodEnd end) const {
    const auto n = static_cast<Real>(springs), k = static_cast<Real>(j);
    return end == RodEnd::free ? (2 * k - 1) * pi / (2 * n + 1) : k * pi / n;
}

Real MassChain::frequency(Index j, RodEnd end) const { return 2 * std::sqrt(stiffness / mass) * std::sin(0.5 * phase(j, end)); }

}  // namespace pliant
