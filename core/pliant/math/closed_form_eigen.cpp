#include <pliant/math/closed_form_eigen.h>
#include <Eigen/Eigenvalues>

namespace pliant {

SymmetricEigen<3> symmetric_eigen_closed_form(const Mat<3>& A) {
    Eigen::SelfAdjointEigenSolver<Mat<3>> solver;
    solver.computeDirect(A);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace pliant
