// Masses of a second-order system whose mass matrix is diagonal, one number per degree of freedom.
#pragma once
#include <pliant/math/types.h>

#include <vector>

namespace pliant {

// Degrees of freedom as one long vector: x, y (, z) of point 0, then of point 1, ...
using Dofs = Eigen::Ref<VecX>;
using ConstDofs = const Eigen::Ref<const VecX>&;

class DiagonalMass {
public:
    DiagonalMass() = default;
    // node_mass: kg, one per node; fixed: nodes that no force moves (their velocity stays what it is), as if of infinite mass.
    // Throws Refused, naming the node, for a mass that is not positive and finite or a fixed node that does not exist.
    DiagonalMass(const VecX& node_mass, int dimension, const std::vector<Index>& fixed = {});
    // held: one flag for each degree of freedom, set where it is fixed: a roller holds one component of a node. Throws Refused as
    // above, or for another number of flags.
    static DiagonalMass with_held(const VecX& node_mass, int dimension, const std::vector<char>& held);

    Index size() const { return mass_.size(); }
    const VecX& mass() const { return mass_; }        // kg
    const VecX& inverse() const { return inverse_; }  // 1/kg, 0 where fixed
    bool fixed(Index dof) const { return inverse_[dof] == 0; }

private:
    VecX mass_, inverse_;
};

}  // namespace pliant
