#include <pliant/math/error.h>
#include <pliant/math/sparse_cholesky.h>

#include <Eigen/SparseCholesky>
#include <limits>

#include <fmt/format.h>

namespace pliant {

struct SparseCholesky::Factor {
    Eigen::SimplicialLDLT<SparseMatrix> ldlt;
    bool analyzed = false;
};

SparseCholesky::SparseCholesky() : factor_(std::make_unique<Factor>()) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

void SparseCholesky::analyze(const SparseMatrix& pattern) {
    factor_->ldlt.analyzePattern(pattern);
    factor_->analyzed = true;
}

void SparseCholesky::factorize(const SparseMatrix& matrix) {
    if (!factor_->analyzed) analyze(matrix);
    if (matrix.rows() == 0) return;
    factor_->ldlt.factorize(matrix);

    // A pivot that cancels to rounding, measured against its own diagonal entry, belongs to a singular matrix. In the order of
    // elimination, since the factorisation stops at a pivot of zero.
    const auto& original = factor_->ldlt.permutationPinv();
    const VecX pivots = factor_->ldlt.vectorD();
    const Real smallest = 4 * std::numeric_limits<Real>::epsilon();
    for (Index k = 0; k < matrix.rows(); ++k) {
        const Index i = original.size() > 0 ? original.indices()[k] : k;
        const Real diagonal = matrix.coeff(i, i);
        if (diagonal > 0 && pivots[k] > smallest * diagonal) continue;
        Failure failure;
        failure.kind = FailureKind::not_converged;
        failure.index = i;
        failure.what = fmt::format(
            "the matrix is singular or not positive definite: pivot {:.3g} for unknown {}, whose diagonal entry is {:.3g}",
            pivots[k], i, diagonal);
        throw Diverged(failure);
    }
}

void SparseCholesky::solve(const VecX& right_side, VecX& x) const {
    if (right_side.size() == 0) {
        x.resize(0);
        return;
    }
    x = factor_->ldlt.solve(right_side);
    if (x.allFinite()) return;
    Failure failure;
    failure.kind = FailureKind::not_converged;
    failure.what = "the solution of the linear system is not finite";
    throw Diverged(failure);
}

Index SparseCholesky::factor_entries() const { return factor_->ldlt.matrixL().nestedExpression().nonZeros(); }

Real SparseCholesky::operations() const {
    const auto& L = factor_->ldlt.matrixL().nestedExpression();
    Real sum = 0;
    for (Index k = 0; k < L.outerSize(); ++k) {
        const auto entries = static_cast<Real>(L.outerIndexPtr()[k + 1] - L.outerIndexPtr()[k]);
        sum += entries * entries;
    }
    return sum;
}

}  // namespace pliant
