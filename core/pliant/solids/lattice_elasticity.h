// What a net of springs is as a material: elastic constants of infinite lattices, and static tests of finite pieces. All for
// small displacements about the shape at rest, in which no spring is under tension.
#pragma once
#include <pliant/mesh/spring_lattice.h>
#include <pliant/solids/springs.h>

#include <array>

namespace pliant {

using FamilyStiffness = std::array<Real, spring_families>;  // N/m, of every spring of a family

// Of an infinite lattice, in N/m^(dimension - 1): a sheet's per thickness. Central forces alone obey Cauchy's relation
// C12 = C44, so that the Poisson ratio of an isotropic one is 1/3 in 2D and 1/4 in 3D, whatever the stiffnesses [BornHuang1954
// §11].
struct LatticeConstants {
    int dimension = 3;
    Real c11 = 0, c12 = 0, c44 = 0;
    Real youngs_modulus() const;                                // along an axis; 0 without springs
    Real poisson_ratio() const;                                 // pulled along an axis; 0 where nothing is to narrow
    Real zener_ratio() const { return 2 * c44 / (c11 - c12); }  // 1 where isotropic
};

// Every node is a centre of symmetry, so that a homogeneous strain leaves it balanced: the constants are second derivatives of
// the energy of the springs of one node. edge: m.
LatticeConstants lattice_constants(LatticeKind kind, const FamilyStiffness& stiffness, Real edge);

// The springs of a piece; of a family of stiffness 0, none. shared: with stiffnesses weighted by SpringLattice::share.
std::vector<Spring> lattice_springs(const SpringLattice& lattice, const FamilyStiffness& stiffness, bool shared);

// Both end faces, at the smallest and largest y, are held by plates.
enum class BlockTest {
    stretch,  // moved apart along y; free to slide along the plates
    shear,    // moved along x, glued to the plates
    bend      // turned about z, each by half the angle; free to slide along the plates
};

struct BlockResponse {
    Real stiffness = 0;  // N/m, of bending N m/rad: force or moment per displacement or angle
    // Part of the energy that each family stores: that is d ln(stiffness)/d ln(k of the family), and they add up to 1.
    FamilyStiffness coupling{};
    // Of a stretch test, from the stiffness and the mean strain across [N/m^(dimension - 1), dimensionless].
    Real youngs_modulus = 0, poisson_ratio = 0;
    Points<3> displacement;  // per unit of displacement or angle, m
};

// The two alternating motions that the springs of a cubic_body lattice never resist, and nothing drives, are held still. Throws
// Diverged "singular: ... mechanisms unconstrained" where the springs leave the nodes free to move, and Refused for a
// chain that is not to be stretched or a piece without cells along an axis of its lattice.
BlockResponse test_block(const SpringLattice& lattice, const FamilyStiffness& stiffness, BlockTest test, bool shared = false);

}  // namespace pliant
