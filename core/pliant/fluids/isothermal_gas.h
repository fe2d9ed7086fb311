// A gas at one temperature in a straight tube: ρ_t + (ρu)_x = 0, (ρu)_t + (ρu² + c²ρ)_x = 0, where c is the speed of sound. It
// is compressible: its mass is conserved because its density changes. Conservative finite volumes [LeVeque2002 §4, §14]: what a
// cell loses its neighbour gains, to the bit, with the HLL flux [HartenLaxVanLeer1983].
#pragma once
#include <pliant/math/types.h>

#include <vector>

namespace pliant {

enum class TubeEnds { closed, periodic };

struct IsothermalGasInfo {
    Index cells = 1;          // at least 1
    Real dx = 1;              // m, > 0
    Real speed_of_sound = 1;  // m/s, > 0
    TubeEnds ends = TubeEnds::closed;
};

class IsothermalGas {
public:
    // At rest, with a density of 1 kg/m³. Throws Refused for numbers out of range.
    explicit IsothermalGas(IsothermalGasInfo info);

    const IsothermalGasInfo& info() const { return info_; }
    // Per cell: kg/m³, and kg/(m² s).
    VecX& density() { return density_; }
    VecX& momentum() { return momentum_; }
    const VecX& density() const { return density_; }
    const VecX& momentum() const { return momentum_; }

    // Of the tube per cross section, kg/m².
    Real mass() const { return density_.sum() * info_.dx; }
    // The largest time step for which a step is stable, Δx/max(|u| + c), s.
    Real stable_step() const;

    // One explicit step. Throws Refused, naming the limit, for a step beyond stable_step(), or one that is not above 0.
    void step(Real dt);

private:
    struct Flux {
        Real mass, momentum;
    };
    Flux flux_between(Index left, Index right) const;

    IsothermalGasInfo info_;
    VecX density_, momentum_;
    std::vector<Flux> fluxes_;  // face i lies below cell i
};

// What stands between a left and a right state after a diaphragm has been taken away: the density and the velocity between the
// two waves, each a shock or a rarefaction [LeVeque2002]. Densities > 0.
struct GasState {
    Real density, velocity;
};
GasState between_waves(const GasState& left, const GasState& right, Real speed_of_sound);

}  // namespace pliant
