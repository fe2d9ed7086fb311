// Decompositions of dense matrices of any size as plain functions, so that Eigen's solvers are compiled once for all who use
// them.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

// A = vectors diag(values) vectorsᵀ of a symmetric matrix, whose lower triangle is read: values ascending, vectors orthonormal in
// columns. Householder tridiagonalisation and implicit QR [Golub2013 §8.3].
struct DenseEigen {
    VecX values;
    MatX vectors;
};
DenseEigen dense_eigen(const MatX& A);

// Ascending, of the symmetric matrix with this diagonal, N numbers, and N - 1 beside it.
VecX tridiagonal_eigenvalues(const VecX& diagonal, const VecX& beside);

// Rank by pivoted QR; pivots below `part` of the largest count as 0.
Index rank(const MatX& A, Real part);
// An x with the least |A x − b|, by pivoted QR; pivots below `part` of the largest count as 0.
VecX least_squares(const MatX& A, const VecX& b, Real part);

}  // namespace pliant
