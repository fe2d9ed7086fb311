// Masses of a second-order system: a symmetric positive definite matrix over its degrees of freedom, diagonal or not.
#pragma once
#include <pliant/math/types.h>

#include <memory>
#include <vector>

namespace pliant {

// Degrees of freedom as one long vector: x, y (, z) of point 0, then of point 1, ...
using Dofs = Eigen::Ref<VecX>;
using ConstDofs = const Eigen::Ref<const VecX>&;

// M, kg, and the degrees of freedom that no force moves: their velocity stays what it is, as if their mass were infinite.
class Mass {
public:
    virtual ~Mass() = default;

    virtual Index size() const = 0;
    virtual bool fixed(Index dof) const = 0;
    virtual void multiply(ConstDofs a, VecX& Ma) const = 0;
    virtual Real square(const VecX& d) const = 0;  // d . M d
    // a with M a = f over those that are not fixed; 0 where fixed.
    virtual void accelerate(const VecX& force, VecX& a) const = 0;
    virtual const VecX& diagonal() const = 0;
    // M where it is not diagonal, both triangles stored, with every diagonal entry; else null.
    virtual const SparseMatrix* matrix() const { return nullptr; }
};

class DiagonalMass final : public Mass {
public:
    DiagonalMass() = default;
    // node_mass: kg, one per node; fixed: nodes that no force moves. Throws Refused, naming the node, for a mass that is not
    // positive and finite or a fixed node that does not exist.
    DiagonalMass(const VecX& node_mass, int dimension, const std::vector<Index>& fixed = {});
    // held: one flag for each degree of freedom, set where it is fixed: a roller holds one component of a node. Throws Refused as
    // above, or for another number of flags.
    static DiagonalMass with_held(const VecX& node_mass, int dimension, const std::vector<char>& held);

    const VecX& mass() const { return mass_; }        // kg
    const VecX& inverse() const { return inverse_; }  // 1/kg, 0 where fixed

    Index size() const override { return mass_.size(); }
    bool fixed(Index dof) const override { return inverse_[dof] == 0; }
    void multiply(ConstDofs a, VecX& Ma) const override { Ma = mass_.cwiseProduct(a); }
    Real square(const VecX& d) const override { return d.cwiseAbs2().dot(mass_); }
    void accelerate(const VecX& force, VecX& a) const override { a = inverse_.cwiseProduct(force); }
    const VecX& diagonal() const override { return mass_; }

private:
    VecX mass_, inverse_;
};

// A mass matrix that couples degrees of freedom, such as the consistent one of finite elements. It is factorised once.
class CoupledMass final : public Mass {
public:
    // matrix: symmetric, both triangles stored, with every diagonal entry; implicit schemes need the pattern of the system's
    // stiffness. held: one flag for each degree of freedom, or none at all. Throws Refused for another number of flags, Diverged
    // where the matrix is not positive definite.
    explicit CoupledMass(SparseMatrix matrix, const std::vector<char>& held = {});
    ~CoupledMass() override;

    Index size() const override { return matrix_.rows(); }
    bool fixed(Index dof) const override { return held_[static_cast<std::size_t>(dof)] != 0; }
    void multiply(ConstDofs a, VecX& Ma) const override { Ma.noalias() = matrix_ * a; }
    Real square(const VecX& d) const override;
    void accelerate(const VecX& force, VecX& a) const override;
    const VecX& diagonal() const override { return diagonal_; }
    const SparseMatrix* matrix() const override { return &matrix_; }

private:
    SparseMatrix matrix_;
    std::vector<char> held_;
    VecX diagonal_;
    struct Free;  // the degrees of freedom that are not held
    std::unique_ptr<Free> free_;
    mutable VecX product_;
};

}  // namespace pliant
