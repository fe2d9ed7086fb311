#include <pliant/continuum/deformation.h>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <cmath>

namespace pliant {
namespace {

// The slope of q at its largest root f, over f^3. Rounding in R grows as its inverse squared: here to less than 1e-12.
constexpr Real well_conditioned = 0.2;

// The rotation U D V^T nearest to F = U Sigma V^T: D turns the direction that is stretched least where U V^T is a reflection.
template <int Dim>
Mat<Dim> rotation_by_svd(const Mat<Dim>& F) {
    const Eigen::JacobiSVD<Mat<Dim>> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat<Dim> U = svd.matrixU();
    if (U.determinant() * svd.matrixV().determinant() < 0) U.col(Dim - 1) *= -1;
    return U * svd.matrixV().transpose();
}

Mat<2> rotation_of(const Mat<2>& F) {
    Vec<2> direction(F(0, 0) + F(1, 1), F(1, 0) - F(0, 1));
    const Real length = direction.stableNorm();
    if (length == 0) return Mat<2>::Identity();
    direction /= length;
    Mat<2> R;
    R << direction[0], -direction[1], direction[1], direction[0];
    return R;
}

// The trace f of S is the largest root of q(f) = f^4 - 2 |F|^2 f^2 - 8 det(F) f + 2 |F^T F|^2 - |F|^4, and R = df/dF.
Mat<3> rotation_of(const Mat<3>& given) {
    const Real size = given.cwiseAbs().maxCoeff();
    if (!(size > 0)) return Mat<3>::Identity();
    const Mat<3> F = given * (1 / size), C = F.transpose() * F, cofactors = cofactor<3>(F);
    const Real I1 = C.trace(), J = F.col(0).dot(cofactors.col(0)), constant = 2 * C.squaredNorm() - I1 * I1;

    // Newton's method from above, where q is convex and rises: each iterate is smaller than the one before.
    Real f = std::sqrt(3 * I1), slope = 0;
    for (int k = 0; k < 30; ++k) {
        const Real f2 = f * f;
        slope = 4 * (f * (f2 - I1) - 2 * J);
        const Real value = f2 * (f2 - 2 * I1) - 8 * J * f + constant;
        if (!(slope > well_conditioned * f * f2)) return rotation_by_svd<3>(F);
        const Real step = value / slope;
        f -= step;
        if (!(step > 1e-9 * f)) break;  // the next one would be of the size of rounding
    }
    slope = 4 * (f * (f * f - I1) - 2 * J);
    if (!(slope > well_conditioned * f * f * f)) return rotation_by_svd<3>(F);
    return (4 / slope) * ((f * f + I1) * F + 2 * f * cofactors - 2 * F * C);
}

}  // namespace

template <int Dim>
Mat<Dim> nearest_rotation(const Mat<Dim>& F) {
    return rotation_of(F);
}

template <int Dim>
PolarDecomposition<Dim> polar_decomposition(const Mat<Dim>& F) {
    const Mat<Dim> R = rotation_of(F), product = R.transpose() * F;
    return {R, 0.5 * (product + product.transpose())};
}

template <>
Mat<2> rotation_differential<2>(const PolarDecomposition<2>& polar, const Mat<2>& dF) {
    const Mat<2> turned = polar.R.transpose() * dF;
    const Real trace = polar.S.trace(), spin = trace == 0 ? 0 : (turned(1, 0) - turned(0, 1)) / trace;
    Mat<2> W;
    W << 0, -spin, spin, 0;
    return polar.R * W;
}

template <>
Mat<3> rotation_differential<3>(const PolarDecomposition<3>& polar, const Mat<3>& dF) {
    const Mat<3> turned = polar.R.transpose() * dF;
    const Vec<3> axial(turned(2, 1) - turned(1, 2), turned(0, 2) - turned(2, 0), turned(1, 0) - turned(0, 1));
    const Mat<3> A = polar.S.trace() * Mat<3>::Identity() - polar.S;
    const Real size = A.cwiseAbs().maxCoeff();
    Vec<3> w = Vec<3>::Zero();
    if (std::abs(A.determinant()) > 1e-12 * size * size * size)
        w = A.inverse() * axial;
    else if (size > 0)
        w = A.completeOrthogonalDecomposition().solve(axial);
    Mat<3> W;
    W << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
    return polar.R * W;
}

template <int Dim>
PrincipalStretches<Dim> principal_stretches(const Mat<Dim>& F) {
    const Eigen::SelfAdjointEigenSolver<Mat<Dim>> eigen(polar_decomposition<Dim>(F).S);
    // Ascending; the one that an inversion makes negative is the least in size too.
    return {eigen.eigenvalues().reverse(), eigen.eigenvectors().rowwise().reverse()};
}

#define PLIANT_INSTANTIATE(Dim)                                            \
    template Mat<Dim> nearest_rotation(const Mat<Dim>&);                   \
    template PolarDecomposition<Dim> polar_decomposition(const Mat<Dim>&); \
    template PrincipalStretches<Dim> principal_stretches(const Mat<Dim>&)
PLIANT_INSTANTIATE(2);
PLIANT_INSTANTIATE(3);
#undef PLIANT_INSTANTIATE

}  // namespace pliant
