// A small block of tetrahedra that is pulled to a stretch and free across, under any energy: what the cube does, done by many
// elements and Newton's method.
#pragma once
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/hyperelastic_fem.h>
#include <pliant/solids/newton_equilibrium.h>

#include <memory>

namespace pliant {

enum class BlockEnds {
    sliding,  // the ends may narrow: the strain is uniform, as in the cube
    glued     // the ends keep their shape
};

class StretchedBlock {
public:
    static constexpr Real width_at_rest = 0.5;  // m; it is 1 m long
    // Beyond these an iteration has lost its way: of displacements and steps [m], and of forces over moduli [m^2].
    static constexpr Real farthest = 1e6, strongest = 1e15;

    StretchedBlock(Energy energy, const Lame& material, BlockEnds ends, Real stretch);
    StretchedBlock(const StretchedBlock&) = delete;
    StretchedBlock& operator=(const StretchedBlock&) = delete;

    const SimplexMesh<3>& mesh() const { return mesh_; }
    const HyperelasticFem<3>& body() const { return body_; }
    const DisplacementConstraints<3>& supports() const { return supports_; }

    // From rest; then an iteration at a time. One that fails is undone, and is the last: it never throws, since the block is only
    // shown beside the cube.
    void begin(), iterate();
    bool running() const { return newton_.running() && !failed_; }
    // No direction could be found, by a tangent that no factorisation takes or in numbers that mean nothing any more.
    bool failed() const { return failed_; }
    const NewtonEquilibrium<3>& newton() const { return newton_; }
    // The displacements [m] and what no force balances yet [N], after the latest iteration.
    const Points<3>& displacement() const { return displacement_; }
    const Points<3>& unbalanced() const { return unbalanced_; }
    // Largest unbalanced force over the largest force; 1 while the ends are not where they shall be.
    Real residual() const { return residual_; }
    // Newton's direction of the latest iteration [m]; 0 when it failed.
    const Points<3>& direction() const { return failed_ ? nothing_ : newton_.step(); }
    // Share of Newton's step that the latest iteration took; 0 when it took none.
    Real step_length() const { return step_length_; }
    // The displacements [m] that the latest iteration began with.
    const Points<3>& before() const { return before_; }

    // Pull over the area at rest [Pa], and the width of the middle section over that at rest.
    Real stress(const Points<3>&u) const, width(const Points<3>&u) const;
    // Nodes of the middle section on the side z = max or z = 0.
    std::vector<Index> middle(bool upper) const;

private:
    void advance();
    bool is_sound() const;

    SimplexMesh<3> mesh_;
    HyperelasticFem<3> body_;
    DisplacementConstraints<3> supports_;
    NewtonEquilibrium<3> newton_;
    Points<3> before_, displacement_, unbalanced_, nothing_;
    Real step_length_ = 0, residual_ = 0;
    bool failed_ = false;
};

}  // namespace pliant
