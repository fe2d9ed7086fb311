// Energy densities psi(F) of isotropic elastic materials [J/m^3], the stress P = dpsi/dF that each one means (first
// Piola-Kirchhoff, force per rest area [Pa]) and its tangent dP/dF [Pa], with F(i, j) = dx_i/dX_j. In the plane: plane strain,
// per metre of thickness.
//
//   linear          mu eps : eps + lambda/2 tr(eps)^2        eps = (F + F^T)/2 - I
//   StVK            mu E : E + lambda/2 tr(E)^2              E = (F^T F - I)/2 (St. Venant-Kirchhoff)
//   corotated       mu |F - R|^2 + lambda/2 tr(S - I)^2      F = R S
//   neo-Hookean     mu/2 (tr F^T F - Dim) - mu ln J + lambda/2 (ln J)^2       J = det F
// [Bonet2008 §6, Sifakis2012 §3]
#pragma once
#include <pliant/continuum/moduli.h>
#include <pliant/math/types.h>

namespace pliant {

enum class Energy { linear, stvk, corotated, neo_hookean };

template <int Dim>
class EnergyDensity {
public:
    EnergyDensity(Energy energy, const Lame& material) : energy_(energy), material_(material) {}

    Energy energy() const { return energy_; }
    const Lame& material() const { return material_; }

    // Whether psi is finite at F: always, save for neo-Hookean where det F <= 0.
    bool admits(const Mat<Dim>& F) const;

    // Infinite where F is not admitted.
    Real psi(const Mat<Dim>& F) const;
    // Both throw Diverged, with det F, where F is not admitted.
    Mat<Dim> P(const Mat<Dim>& F) const;
    // dP/dF as a matrix on F in columns: row i + Dim j is P(i, j), column k + Dim l is F(k, l). Symmetric.
    Mat<Dim * Dim> tangent(const Mat<Dim>& F) const;

    // The change of P for a change dF: the tangent times dF.
    Mat<Dim> differential(const Mat<Dim>& F, const Mat<Dim>& dF) const;

private:
    Energy energy_;
    Lame material_;
};

}  // namespace pliant
