// Static tests of the block: what it is as a material, how its families of springs couple, and a continuum beside it.
#pragma once
#include <pliant/solids/lattice_elasticity.h>

#include <optional>
#include <vector>

namespace pliant {

// Stiffness of a solid block of an isotropic material in the same test, by linear finite elements on the same cells: N/m, of
// bending N m/rad. A sheet is in plane stress, as thick as its edges are long; a triangular lattice has the rectangle of its
// lengths. displacement: per unit of displacement or angle, at the corners of the cells in their order. Throws Refused for a
// chain and for a Poisson ratio that no stable material has.
struct ContinuumResponse {
    Real stiffness = 0;
    Points<3> displacement;
};
ContinuumResponse test_continuum(const SpringLattice& lattice, Real youngs_modulus, Real poisson_ratio, BlockTest test);

// Everything that the static scene shows, computed when what it depends on has changed.
class StaticTests {
public:
    struct Key {
        LatticeKind kind = LatticeKind::cubic_face;
        std::array<Index, 3> cells{};
        Real edge = 0;
        FamilyStiffness stiffness{};
        bool shared = false;
        Real poisson_ratio = 0;
        BlockTest test = BlockTest::stretch;
        bool operator==(const Key&) const = default;
    };

    bool knows(const Key& key) const { return key_ == key; }
    // Throws Diverged, with the mechanisms, where the net cannot bear the test of the key.
    void run(const SpringLattice& lattice, const Key& key);

    const BlockResponse& response() const { return response_; }  // of the test of the key
    // Empty for a chain, and where the elements of the solid cannot bear its Poisson ratio.
    const std::optional<ContinuumResponse>& continuum() const { return continuum_; }
    // Rows: stretch, shear, bend; columns: families. Rows of tests that a chain cannot be put to, or that a mechanism spoils, are
    // 0.
    const Mat<3>& coupling() const { return coupling_; }
    // Young's modulus of pieces with 1, 2, ... cells along each axis over that of the endless lattice; none of a chain, nor where
    // a mechanism spoils it. Measured when first asked for.
    static constexpr Index most_cells = 5;
    const std::vector<Real>& modulus_by_cells() const;

    // Young's modulus in Pa: that of a sheet, in N/m, divided by its edge.
    Real modulus_in_pascal(Real modulus, const SpringLattice& lattice) const;

private:
    static std::optional<ContinuumResponse> continuum_beside(const SpringLattice& lattice, Real youngs_modulus, const Key& key);

    std::optional<Key> key_;
    BlockResponse response_;
    std::optional<ContinuumResponse> continuum_;
    Mat<3> coupling_ = Mat<3>::Zero();
    mutable std::optional<Key> measured_key_;
    mutable std::vector<Real> modulus_by_cells_;
};

}  // namespace pliant
