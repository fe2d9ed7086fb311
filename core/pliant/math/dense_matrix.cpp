#include <pliant/math/dense_matrix.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace pliant {

DenseEigen dense_eigen(const MatX& A) {
    const Eigen::SelfAdjointEigenSolver<MatX> solver(A);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

VecX tridiagonal_eigenvalues(const VecX& diagonal, const VecX& beside) {
    Eigen::SelfAdjointEigenSolver<MatX> solver;
    solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
    return solver.eigenvalues();
}

Index rank(const MatX& A, Real part) {
    Eigen::ColPivHouseholderQR<MatX> qr(A);
    qr.setThreshold(part);
    return qr.rank();
}

VecX least_squares(const MatX& A, const VecX& b, Real part) {
    Eigen::ColPivHouseholderQR<MatX> qr(A);
    qr.setThreshold(part);
    return qr.solve(b);
}

}  // namespace pliant
