#include <pliant/math/constrained_system.h>
#include <pliant/math/error.h>
#include <pliant/math/sparse_cholesky.h>
#include <pliant/time/mass.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace pliant {

DiagonalMass::DiagonalMass(const VecX& node_mass, int dimension, const std::vector<Index>& fixed)
    : mass_(node_mass.size() * dimension) {
    for (Index n = 0; n < node_mass.size(); ++n) {
        if (!(node_mass[n] > 0) || !std::isfinite(node_mass[n]))
            throw Refused(fmt::format("mass[{}]", n), node_mass[n], "kg", "a finite mass > 0");
        mass_.segment(n * dimension, dimension).setConstant(node_mass[n]);
    }
    inverse_ = mass_.cwiseInverse();
    for (const Index n : fixed) {
        if (n < 0 || n >= node_mass.size())
            throw Refused(fmt::format("fixed node {} does not exist: there are {} nodes", n, node_mass.size()));
        inverse_.segment(n * dimension, dimension).setZero();
    }
}

namespace {

void require_flags(const std::vector<char>& held, Index size) {
    if (static_cast<Index>(held.size()) != size)
        throw Refused(fmt::format("{} flags of held degrees of freedom: there are {}", held.size(), size));
}

}  // namespace

DiagonalMass DiagonalMass::with_held(const VecX& node_mass, int dimension, const std::vector<char>& held) {
    DiagonalMass mass(node_mass, dimension);
    require_flags(held, mass.size());
    for (Index d = 0; d < mass.size(); ++d)
        if (held[static_cast<std::size_t>(d)]) mass.inverse_[d] = 0;
    return mass;
}

struct CoupledMass::Free {
    ConstrainedSystem system;
    SparseCholesky cholesky;
    VecX force, acceleration;
};

CoupledMass::CoupledMass(SparseMatrix matrix, const std::vector<char>& held) : matrix_(std::move(matrix)), held_(held) {
    if (held.empty()) held_.assign(static_cast<std::size_t>(matrix_.rows()), 0);
    require_flags(held_, matrix_.rows());
    diagonal_ = matrix_.diagonal();
    free_ = std::make_unique<Free>(ConstrainedSystem(matrix_, held_), SparseCholesky(), VecX(), VecX());
    free_->system.update(matrix_);
    free_->cholesky.factorize(free_->system.matrix());
    product_.setZero(matrix_.rows());
}

CoupledMass::~CoupledMass() = default;

Real CoupledMass::square(const VecX& d) const {
    product_.noalias() = matrix_ * d;
    return d.dot(product_);
}

void CoupledMass::accelerate(const VecX& force, VecX& a) const {
    a.setZero(force.size());
    free_->system.reduce(force, free_->force);
    free_->cholesky.solve(free_->force, free_->acceleration);
    free_->system.expand(free_->acceleration, a);
}

}  // namespace pliant
