#include <pliant/fluids/channel_flow.h>

#include <cmath>
#include <numbers>

namespace pliant {
namespace {

using std::numbers::pi;

// Above this ∫ν dt/H² a few Fourier modes are left; below it the plates do not feel each other much, and a few images do.
constexpr Real late = 0.05;
constexpr int modes = 24, images = 4;

// The second integral of erfc from x to infinity, times 4.
Real twice_integrated_erfc(Real x) { return (1 + 2 * x * x) * std::erfc(x) - 2 * x / std::sqrt(pi) * std::exp(-x * x); }

}  // namespace

Real poiseuille_speed(Real y, Real height, Real acceleration, Real viscosity) {
    return acceleration * y * (height - y) / (2 * viscosity);
}

Real poiseuille_start_up(Real y, Real height, Real acceleration, Real viscosity, Real time) {
    const Real viscous_time = viscosity * time;
    if (viscous_time == 0) return acceleration * time;
    if (viscous_time >= late * height * height) {
        Real u = poiseuille_speed(y, height, acceleration, viscosity);
        for (int n = 1; n < 2 * modes; n += 2) {
            const Real k = n * pi / height;
            u -= 4 * acceleration / (viscosity * height * k * k * k) * std::sin(k * y) * std::exp(-k * k * viscous_time);
        }
        return u;
    }
    const Real scale = 2 * std::sqrt(viscous_time);
    Real kept = 1;
    for (int m = 0; m < images; ++m)
        kept -= (m % 2 ? -1 : 1) *
                (twice_integrated_erfc((m * height + y) / scale) + twice_integrated_erfc(((m + 1) * height - y) / scale));
    return acceleration * time * kept;
}

Real couette_start_up(Real y, Real height, Real speed, Real viscous_time) {
    if (viscous_time >= late * height * height) {
        Real u = y / height;
        for (int n = 1; n <= modes; ++n) {
            const Real k = n * pi / height;
            u += (n % 2 ? -2 : 2) / (n * pi) * std::sin(k * y) * std::exp(-k * k * viscous_time);
        }
        return speed * u;
    }
    if (viscous_time == 0) return y < height ? 0 : speed;
    const Real scale = 2 * std::sqrt(viscous_time);
    Real u = 0;
    for (int m = 0; m < images; ++m)
        u += std::erfc(((2 * m + 1) * height - y) / scale) - std::erfc(((2 * m + 1) * height + y) / scale);
    return speed * u;
}

}  // namespace pliant
