// An elastic body in motion, as the integrators see it. Degrees of freedom are the positions x = X + u of its nodes.
#pragma once
#include <pliant/math/node_blocks.h>
#include <pliant/solids/elastic_body.h>
#include <pliant/solids/external_load.h>
#include <pliant/solids/follower_pressure.h>
#include <pliant/solids/nodal_terms.h>
#include <pliant/time/implicit.h>

#include <optional>

namespace pliant {

// The matrix of one Newton iteration with a Dim × Dim block for every pair of nodes that share an element. The preconditioner
// inverts the blocks on the diagonal (block Jacobi).
template <int Dim>
class BlockTangent final : public LinearisedSystem {
public:
    // A symmetric matrix with the pattern of `blocks`; both outlive this. Throws Diverged, naming the node, where a block on the
    // diagonal is not positive definite.
    void set(const NodeBlocks<Dim>& blocks, const SparseMatrix& matrix);

    void multiply(const VecX& d, VecX& Hd) const override { blocks_->multiply(*matrix_, d, Hd); }
    void precondition(const VecX& r, VecX& z) const override;
    Real diagonal(Index dof) const override { return matrix_->coeff(dof, dof); }

private:
    const NodeBlocks<Dim>* blocks_ = nullptr;
    const SparseMatrix* matrix_ = nullptr;
    std::vector<Mat<Dim>> inverse_;
};

// M a = -f_int(x - X) - C v + what acts from outside, with Rayleigh's damping matrix C = alpha M + beta K
// [Hughes2000 §7.2]: K is that of rest for a linear body, else that of the place at which begin_step() freezes it, without
// negative eigenvalues.
template <int Dim>
class ElasticSystem final : public SecondOrderSystem {
public:
    // rest: X, Dim × nodes, m. Both and the mass outlive this. A mass that couples nodes has the body's pattern. Throws
    // Refused when their numbers of nodes differ.
    ElasticSystem(const ElasticBody<Dim>& body, const Points<Dim>& rest, const Mass& mass);

    Real mass_damping = 0;                          // alpha, 1/s, >= 0
    Real stiffness_damping = 0;                     // beta, s, >= 0
    ExternalLoad<Dim> load;                         // gravity, and a hand that pulls at a node
    std::optional<FollowerPressure<Dim>> pressure;  // its force is frozen by begin_step(), where its matrix need not be symmetric
    NodalTerms<Dim> terms;                          // constant forces on the nodes, drag, planes that nodes rest on

    const ElasticBody<Dim>& body() const { return body_; }
    const Points<Dim>& rest() const { return rest_; }
    const VecX& node_mass() const { return node_mass_; }  // kg, what gravity acts on: sums of the rows of M
    // x - X, m; valid until the next call.
    const Points<Dim>& displacement(ConstDofs x) const;

    void begin_step(ConstDofs x) override;
    bool damped() const override { return mass_damping > 0 || stiffness_damping > 0 || !terms.drag.empty(); }
    Real potential(ConstDofs x) const override;
    Real dissipation(ConstDofs v) const override;
    void force(ConstDofs x, ConstDofs v, Dofs f) const override;
    const SparseMatrix& stiffness(ConstDofs x, Real velocity_rate, Curvature curvature) override;
    const LinearisedSystem* linearise(ConstDofs x, Real velocity_rate, Real acceleration_rate, const Mass& mass) override;
    Real length_scale(ConstDofs) const override { return spacing_; }  // what lies between neighbours at rest, about

private:
    const SparseMatrix& damping_stiffness() const;
    void add_mass(Real rate, const Mass& mass);
    void multiply_damping_stiffness(ConstDofs v) const;

    const ElasticBody<Dim>& body_;
    const Points<Dim>& rest_;
    const Mass& mass_;
    NodeBlocks<Dim> blocks_;
    VecX node_mass_;
    Real spacing_ = 0;
    SparseMatrix matrix_;
    BlockTangent<Dim> tangent_;
    VecX start_;            // where begin_step() freezes K and the pressure, m
    Points<Dim> pressing_;  // N
    mutable Points<Dim> displacement_, internal_;
    mutable VecX velocity_, product_;
    mutable SparseMatrix frozen_;  // K of the damping, or of a linear body
    mutable bool frozen_known_ = false;
};

}  // namespace pliant
