// Direct solution of sparse symmetric positive definite systems.
#pragma once
#include <pliant/math/types.h>

#include <memory>

namespace pliant {

// A = P^T L D L^T P with a fill-reducing order P [Davis2006 §4]. The order is found when the pattern is first seen; a new matrix
// of the same pattern only needs factorize().
class SparseCholesky {
public:
    SparseCholesky();
    ~SparseCholesky();
    SparseCholesky(SparseCholesky&&) noexcept;
    SparseCholesky& operator=(SparseCholesky&&) noexcept;

    void analyze(const SparseMatrix& pattern);
    // Throws Diverged, naming the unknown, when the matrix is singular to rounding or not positive definite.
    void factorize(const SparseMatrix& matrix);
    // Throws Diverged when the solution is not finite.
    void solve(const VecX& right_side, VecX& x) const;

    Index factor_entries() const;  // non-zeros of L, a measure of cost
    // Multiplications and additions of the factorisation: the squares of the entries of each column of L below its diagonal,
    // summed.
    Real operations() const;

private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

}  // namespace pliant
