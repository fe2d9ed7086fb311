// Natural frequencies and modes of a small spring net.
#pragma once
#include <pliant/solids/springs.h>
#include <pliant/time/mass.h>

namespace pliant {

// More free degrees of freedom than this would take minutes: the eigenproblem is dense.
inline constexpr Index most_mode_dofs = 1500;

struct SpringModes {
    VecX omega_squared;  // rad^2/s^2, ascending; 0 of rigid motions and mechanisms, negative where a compressed net buckles
    MatX shape;          // dofs x modes: 0 where fixed, with shape^T M shape = I (1/sqrt(kg))

    Index size() const { return omega_squared.size(); }
    // rad/s; 0 of a mode that does not swing.
    Real omega(Index mode) const;
    // Modes with |omega| at most `part` of the largest: rigid motions and mechanisms.
    Index without_stiffness(Real part = 1e-6) const;
};

// Of small motions about positions x, without damping: K phi = omega^2 M phi on the nodes that are not fixed [Hughes2000 §7].
// Throws Refused when there are more than most_mode_dofs free degrees of freedom.
template <int Dim>
SpringModes spring_modes(const Springs& springs, const DiagonalMass& mass, PointsIn<Dim> x);

}  // namespace pliant
