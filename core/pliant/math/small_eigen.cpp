#include <pliant/math/small_eigen.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <limits>

namespace pliant {
namespace {

// One instantiation for all sizes: a solver unrolled for each takes longer to compile than half of the lessons.
using AtMost9 = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 9, 9>;

Eigen::SelfAdjointEigenSolver<AtMost9> solved(const AtMost9& A, int options) {
    return Eigen::SelfAdjointEigenSolver<AtMost9>(A, options);
}

}  // namespace

template <int Size>
SymmetricEigen<Size> symmetric_eigen(const Mat<Size>& A) {
    const auto solver = solved(A, Eigen::ComputeEigenvectors);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

template <int Size>
Vec<Size> symmetric_eigenvalues(const Mat<Size>& A) {
    return solved(A, Eigen::EigenvaluesOnly).eigenvalues();
}

#define PLIANT_INSTANTIATE(Size)                                           \
    template SymmetricEigen<Size> symmetric_eigen<Size>(const Mat<Size>&); \
    template Vec<Size> symmetric_eigenvalues<Size>(const Mat<Size>&)
PLIANT_INSTANTIATE(2);
PLIANT_INSTANTIATE(3);
PLIANT_INSTANTIATE(4);
PLIANT_INSTANTIATE(9);
#undef PLIANT_INSTANTIATE

SingularValues3 singular_values(const Mat<3>& F) {
    // A square matrix needs no QR decomposition first.
    const Eigen::JacobiSVD<Mat<3>, Eigen::NoQRPreconditioner> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {svd.matrixU(), svd.matrixV(), svd.singularValues()};
}

Vec<3> shortest_solution(const Mat<3>& A, const Vec<3>& b) {
    const SingularValues3 svd = singular_values(A);
    const Real zero = 3 * std::numeric_limits<Real>::epsilon() * svd.sigma[0];
    Vec<3> x = Vec<3>::Zero();
    for (int k = 0; k < 3; ++k)
        if (svd.sigma[k] > zero) x += svd.U.col(k).dot(b) / svd.sigma[k] * svd.V.col(k);
    return x;
}

Mat<3> orthogonal_part(const Mat<3>& A) {
    Mat<3> Q = Mat<3>::Identity();
    Q.applyOnTheLeft(Eigen::HouseholderQR<AtMost9>(A).householderQ());
    return Q;
}

}  // namespace pliant
