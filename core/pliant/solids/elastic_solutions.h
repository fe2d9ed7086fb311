// Elastic bodies whose displacements are known in closed form: what solvers are measured against.
#pragma once
#include <pliant/continuum/energy_density.h>

namespace pliant {

// A square from 0 to L along both axes, held all around, under the force per volume that makes
//   u = A L (sin(pi x/L) sin(pi y/L), 1/2 sin(pi x/L) sin(2 pi y/L))
// its displacement [m], whatever the energy: b = -div P(F).
struct SinesInSquare {
    Real length = 1;       // L, m
    Real amplitude = 0.1;  // A

    Vec<2> displacement(const Vec<2>& X) const;
    Mat<2> gradient(const Vec<2>& X) const;                                       // H(i, j) = du_i/dX_j
    Vec<2> force_density(const Vec<2>& X, const EnergyDensity<2>& energy) const;  // b, N/m^3
};

// A disc about the origin, free at its rim, under a force outwards that grows with the distance from its centre, as in a disc
// that spins: b = b_R X/R [N/m^3], with b_R = rho omega² R at the rim. Plane strain, small strains [TimoshenkoGoodier1970 §32].
struct SpinningDisc {
    Real radius = 1;     // R, m
    Real rim_force = 0;  // b_R, N/m^3
    Lame material;

    Vec<2> force_density(const Vec<2>& X) const { return rim_force / radius * X; }
    // u = X b_R/R ((2 lambda + 3 mu) R²/(8 (lambda + mu)(lambda + 2 mu)) - r²/(8 (lambda + 2 mu))), m
    Vec<2> displacement(const Vec<2>& X) const;
};

// A rod that is held at s = 0 and let go from a uniform strain: d'Alembert's solution, of period 4 L/c. Its free end follows a
// triangle wave.
struct ReleasedRod {
    Real length = 1, wave_speed = 1, strain = 0;  // L, c, strain at t = 0; m, m/s

    Real displacement(Real s, Real t) const;  // m
    Real strain_at(Real s, Real t) const;
    Real frequency(Index j) const;  // (2j - 1) c/(4 L), Hz, of mode j = 1, 2, ...

private:
    // How far the plateau stands out, in strains times lengths: falls from L to -L and comes back.
    Real plateau(Real t) const;
};

}  // namespace pliant
