// An elastic rod that resists stretching and nothing else, discretised from its energy U = ∫₀ᴸ ½ EA ε² ds: x(s) is where the
// point lies that is s along the rod at rest, and ε = |∂x/∂s| − 1 its strain. Sample points s_i = i Δs, i = 0 ... N, make N
// segments of one length; x has one column per point, all else one per segment.
#pragma once
#include <pliant/solids/springs.h>

namespace pliant {

// ∂x/∂s ≈ (x_{i+1} − x_i)/Δs, dimensionless. segment: Δs, m.
void rod_slopes(Real segment, PointsIn<2> x, PointsOut<2> slope);

// ε = |∂x/∂s| − 1.
void rod_strains(PointsIn<2> slope, Eigen::Ref<VecX> strain);

// U ≈ Σ ½ EA ε² Δs, J. axial_stiffness: EA, N.
Real rod_energy(Real axial_stiffness, Real segment, const Eigen::Ref<const VecX>& strain);

// f_i −= ∂U/∂x_i of that sum, N: each segment pulls its ends together with EA ε along itself. A segment of no length has no
// direction and pulls with no force.
void add_rod_forces(Real axial_stiffness, PointsIn<2> slope, const Eigen::Ref<const VecX>& strain, PointsOut<2> f);

// The same energy, term by term, is that of springs: rest length Δs, stiffness EA/Δs. damping: N s/m of each.
Springs rod_springs(Index segments, Real segment, Real stiffness, Real damping = 0);

// A chain of springs along a line, held at its first point: the displacements that balance forces along it. Each spring takes
// up all that acts beyond it. stiffness: N/m, of N springs; force: N, of N + 1 points (that of the first is the support's).
// added_tension: N, of the springs; move: m, of the points.
void balance_chain(const Eigen::Ref<const VecX>& stiffness, const Eigen::Ref<const VecX>& force, VecX& added_tension, VecX& move);

// All angular frequencies of such a chain, rad/s, in rising order, from the tridiagonal matrix M^-1/2 K M^-1/2. mass: kg, of N +
// 1 points, of which the first does not move, nor the last if last_is_fixed.
VecX chain_frequencies(const Eigen::Ref<const VecX>& stiffness, const Eigen::Ref<const VecX>& mass, bool last_is_fixed);

}  // namespace pliant
