#include <fmt/format.h>
#include <pliant/fluids/isothermal_gas.h>
#include <pliant/math/error.h>

#include <algorithm>
#include <cmath>

namespace pliant {

IsothermalGas::IsothermalGas(IsothermalGasInfo info) : info_(info) {
    if (info.cells < 1) throw Refused("cells", static_cast<Real>(info.cells), "", "at least 1");
    if (!(info.dx > 0) || !std::isfinite(info.dx)) throw Refused("dx", info.dx, "m", "a finite length above 0");
    if (!(info.speed_of_sound > 0) || !std::isfinite(info.speed_of_sound))
        throw Refused("speed_of_sound", info.speed_of_sound, "m/s", "a finite speed above 0");
    density_ = VecX::Ones(info.cells);
    momentum_ = VecX::Zero(info.cells);
    fluxes_.resize(static_cast<std::size_t>(info.cells) + 1);
}

Real IsothermalGas::stable_step() const {
    const Real fastest = (momentum_.array() / density_.array()).abs().maxCoeff() + info_.speed_of_sound;
    return info_.dx / fastest;
}

// The HLL flux between two cells: exact for the slowest and the fastest wave, a mean between them.
IsothermalGas::Flux IsothermalGas::flux_between(Index left, Index right) const {
    const Real c = info_.speed_of_sound;
    const Real rho_l = density_[left], m_l = momentum_[left], u_l = m_l / rho_l;
    const Real rho_r = density_[right], m_r = momentum_[right], u_r = m_r / rho_r;
    const Flux low{m_l, m_l * u_l + c * c * rho_l}, high{m_r, m_r * u_r + c * c * rho_r};
    const Real slowest = std::min(u_l, u_r) - c, fastest = std::max(u_l, u_r) + c;
    if (slowest >= 0) return low;
    if (fastest <= 0) return high;
    const auto between = [&](Real f_l, Real f_r, Real q_l, Real q_r) {
        return (fastest * f_l - slowest * f_r + fastest * slowest * (q_r - q_l)) / (fastest - slowest);
    };
    return {between(low.mass, high.mass, rho_l, rho_r), between(low.momentum, high.momentum, m_l, m_r)};
}

void IsothermalGas::step(Real dt) {
    const Real limit = stable_step();
    if (!(dt > 0) || dt > limit * (1 + 1e-12))
        throw Refused("time_step", dt, "s", fmt::format("above 0 and at most Δx/max(|u| + c) = {:.6g} s", limit));
    const Index n = info_.cells;
    for (Index i = 1; i < n; ++i) fluxes_[static_cast<std::size_t>(i)] = flux_between(i - 1, i);
    const Real c2 = info_.speed_of_sound * info_.speed_of_sound;
    Flux &first = fluxes_.front(), &last = fluxes_.back();
    if (info_.ends == TubeEnds::periodic) {
        first = last = flux_between(n - 1, 0);
    } else {
        // Nothing passes an end; the gas presses against it.
        first = {0, c2 * density_[0]};
        last = {0, c2 * density_[n - 1]};
    }
    const Real ratio = dt / info_.dx;
    for (Index i = 0; i < n; ++i) {
        const Flux &below = fluxes_[static_cast<std::size_t>(i)], &above = fluxes_[static_cast<std::size_t>(i) + 1];
        density_[i] -= ratio * (above.mass - below.mass);
        momentum_[i] -= ratio * (above.momentum - below.momentum);
    }
}

// Through the density between the waves each side prescribes a velocity; the two meet at one density.
GasState between_waves(const GasState& left, const GasState& right, Real speed_of_sound) {
    // How much the velocity changes across a wave from `beside` to a density.
    const auto change = [&](Real density, Real beside) {
        return speed_of_sound *
               (density > beside ? (density - beside) / std::sqrt(density * beside) : std::log(density / beside));
    };
    const auto excess = [&](Real density) {
        return (left.velocity - change(density, left.density)) - (right.velocity + change(density, right.density));
    };
    Real low = std::min(left.density, right.density), high = std::max(left.density, right.density);
    while (excess(low) < 0) low /= 2;
    while (excess(high) > 0) high *= 2;
    for (int k = 0; k < 200; ++k) {
        const Real middle = low + (high - low) / 2;
        (excess(middle) > 0 ? low : high) = middle;
    }
    return {low, left.velocity - change(low, left.density)};
}

}  // namespace pliant
