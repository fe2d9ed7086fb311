#include <pliant/time/bounded_quadratic.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <utility>

namespace pliant {

// Held sets settle in a few passes; a set that does not is one that flips variables whose bound hardly matters.
constexpr int most_passes = 30;

struct BoundedQuadratic::Factor {
    Eigen::SimplicialLDLT<SparseMatrix> ldlt;
    VecX values;  // of the matrix that is factorised

    bool holds(const SparseMatrix& matrix) const {
        return values.size() == matrix.nonZeros() && (values.array() == matrix.coeffs()).all();
    }
};

BoundedQuadratic::BoundedQuadratic(std::vector<char> fixed)
    : fixed_(std::move(fixed)), held_(fixed_), factor_(std::make_unique<Factor>()) {}
BoundedQuadratic::~BoundedQuadratic() = default;
BoundedQuadratic::BoundedQuadratic(BoundedQuadratic&&) noexcept = default;

void BoundedQuadratic::set_matrix(const SparseMatrix& matrix) {
    if (diagonal_.empty()) {
        matrix_ = reduced_ = matrix;
        for (Index column = 0; column < matrix.cols(); ++column)
            for (Index n = matrix.outerIndexPtr()[column]; n < matrix.outerIndexPtr()[column + 1]; ++n)
                if (matrix.innerIndexPtr()[n] == column) diagonal_.push_back(n);
        factor_->ldlt.analyzePattern(matrix_);
    }
    matrix_.coeffs() = matrix.coeffs();
}

void BoundedQuadratic::add_diagonal(Real factor, const VecX& values) {
    for (Index d = 0; d < matrix_.cols(); ++d) matrix_.valuePtr()[diagonal_[static_cast<std::size_t>(d)]] += factor * values[d];
}

bool BoundedQuadratic::minimise(const VecX& gradient, const VecX& lower, VecX& d) {
    for (Index n = 0; n < gradient.size(); ++n)
        held_[static_cast<std::size_t>(n)] = fixed(n) || (lower.size() > 0 && lower[n] >= 0 && gradient[n] > 0);
    for (int pass = 0; pass < most_passes; ++pass) {
        if (!solve_with_held(gradient, lower, d)) return false;
        if (lower.size() == 0 || !update_held(gradient, lower, d)) break;
    }
    multiplier_.setZero(d.size());
    for (Index n = 0; n < d.size() && lower.size() > 0; ++n) {
        d[n] = fixed(n) ? 0 : std::max(d[n], lower[n]);
        if (held(n) && !fixed(n)) multiplier_[n] = std::max(gradient[n] + product_[n], Real(0));
    }
    return true;
}

bool BoundedQuadratic::solve_with_held(const VecX& gradient, const VecX& lower, VecX& d) {
    // What the held variables' moves mean for the others.
    d.setZero(gradient.size());
    for (Index n = 0; n < d.size(); ++n)
        if (held(n) && !fixed(n)) d[n] = lower[n];
    product_ = matrix_ * d;

    // A held variable keeps its diagonal alone, and so is solved for by itself.
    reduced_.coeffs() = matrix_.coeffs();
    for (Index column = 0; column < reduced_.cols(); ++column)
        for (Index n = reduced_.outerIndexPtr()[column]; n < reduced_.outerIndexPtr()[column + 1]; ++n) {
            const Index row = reduced_.innerIndexPtr()[n];
            if (row == column ? held(row) : held(row) || held(column)) reduced_.valuePtr()[n] = row == column ? 1 : 0;
        }
    right_side_ = -(gradient + product_);
    for (Index n = 0; n < d.size(); ++n)
        if (held(n)) right_side_[n] = d[n];

    if (!factor_->holds(reduced_)) {
        factor_->ldlt.factorize(reduced_);
        factor_->values = reduced_.coeffs();
        ++factorisations_;
    }
    if (factor_->ldlt.info() != Eigen::Success || (d.size() > 0 && !(factor_->ldlt.vectorD().minCoeff() > 0))) return false;
    d = factor_->ldlt.solve(right_side_);
    return true;
}

bool BoundedQuadratic::update_held(const VecX& gradient, const VecX& lower, const VecX& d) {
    bool changed = false;
    product_ = matrix_ * d;
    for (Index n = 0; n < d.size(); ++n) {
        if (fixed(n)) continue;
        const bool hold = held(n) ? gradient[n] + product_[n] > 0 : d[n] < lower[n];
        changed = changed || hold != held(n);
        held_[static_cast<std::size_t>(n)] = hold;
    }
    return changed;
}

}  // namespace pliant
