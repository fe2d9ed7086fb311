// Eigenvalues and singular values of small matrices as plain functions, so that Eigen's solvers are compiled once for all who use
// them. Of any size: dense_matrix.h.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

// A = vectors diag(values) vectorsᵀ, values ascending, vectors orthonormal in columns.
template <int Size>
struct SymmetricEigen {
    Vec<Size> values;
    Mat<Size> vectors;
};

// Of a symmetric matrix, whose lower triangle is read; Size is 2, 3, 4 or 9. Householder tridiagonalisation and implicit QR
// [Golub2013 §8.3].
template <int Size>
SymmetricEigen<Size> symmetric_eigen(const Mat<Size>& A);
template <int Size>
Vec<Size> symmetric_eigenvalues(const Mat<Size>& A);

// The nearest symmetric matrix without negative eigenvalues; A itself, to the bit, where it has none.
template <int Size>
Mat<Size> positive_part(const Mat<Size>& A) {
    const SymmetricEigen<Size> eigen = symmetric_eigen<Size>(A);
    if (eigen.values[0] >= 0) return A;
    return eigen.vectors * eigen.values.cwiseMax(0).asDiagonal() * eigen.vectors.transpose();
}

// F = U diag(sigma) Vᵀ, sigma descending and at least 0; U and V are orthogonal and may be reflections. Two-sided Jacobi
// [Golub2013 §8.6].
struct SingularValues3 {
    Mat<3> U, V;
    Vec<3> sigma;
};
SingularValues3 singular_values(const Mat<3>& F);

// The shortest x with the least |A x − b|, by singular values; those below rounding count as 0.
Vec<3> shortest_solution(const Mat<3>& A, const Vec<3>& b);

// Q of A = Q R by Householder reflections.
Mat<3> orthogonal_part(const Mat<3>& A);

}  // namespace pliant
