#include <pliant/continuum/deformation.h>
#include <pliant/math/small_eigen.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace pliant {
namespace {

// Slope of q at its largest root f, over f^3: 64/27 at rest. Rounding in R grows as its inverse squared; here to 3e-13.
constexpr Real well_conditioned = 0.3;
// Of |F|^2: its fourth power still has all its digits.
constexpr Real smallest_square = 1e-60;

// The rotation U D V^T nearest to F = U Sigma V^T: D turns the direction that is stretched least where U V^T is a reflection.
Mat<3> rotation_by_svd(const Mat<3>& F) {
    SingularValues3 svd = singular_values(F);
    if (svd.U.determinant() * svd.V.determinant() < 0) svd.U.col(2) *= -1;
    return svd.U * svd.V.transpose();
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
Mat<3> rotation_of(const Mat<3>& F) {
    const Vec<3> a = F.col(0), b = F.col(1), c = F.col(2), bc = b.cross(c);
    const Real aa = a.dot(a), bb = b.dot(b), cc = c.dot(c), ab = a.dot(b), bc_ = b.dot(c), ca = c.dot(a);
    const Real I1 = aa + bb + cc, J = a.dot(bc);
    if (!(I1 > smallest_square && I1 < 1 / smallest_square)) {
        const Real size = F.cwiseAbs().maxCoeff();
        return size > 0 ? rotation_of(Mat<3>(F / size)) : Mat<3>::Identity();
    }
    const Real constant = 2 * (aa * aa + bb * bb + cc * cc) + 4 * (ab * ab + bc_ * bc_ + ca * ca) - I1 * I1;

    // Halley's method from above: f^2 = I1 + 2 i2 with i2 = s1 s2 + s2 s3 + s3 s1, whose square is at most 3 |cof F|^2. All roots
    // of q are real, so that each iterate is smaller than the one before, and above the root.
    Real f = std::sqrt(3 * I1), slope = 0;
    for (int k = 0; k < 20; ++k) {
        const Real f2 = f * f;
        slope = 4 * (f * (f2 - I1) - 2 * J);
        if (!(slope > well_conditioned * f * f2)) return rotation_by_svd(F);
        const Real value = f2 * (f2 - 2 * I1) - 8 * J * f + constant, bend = 12 * f2 - 4 * I1;
        const Real step = 2 * value * slope / (2 * slope * slope - value * bend);
        f -= step;
        if (!(step > 1e-6 * f)) break;  // the next one would be of the size of rounding
    }
    slope = f * (f * f - I1) - 2 * J;
    if (!(4 * slope > well_conditioned * f * f * f)) return rotation_by_svd(F);
    // ((f^2 + I1) F - 2 F C + 2 f cof F) / slope, two columns of it; they are orthonormal, and the third follows.
    const Real scale = 1 / slope, diagonal = (f * f + I1) * scale, mixed = -2 * scale, cofactors = 2 * f * scale;
    const Real off = mixed * ab;
    Mat<3> R;
    R.col(0) = (diagonal + mixed * aa) * a + off * b + (mixed * ca) * c + cofactors * bc;
    R.col(1) = off * a + (diagonal + mixed * bb) * b + (mixed * bc_) * c + cofactors * c.cross(a);
    R.col(2) = R.col(0).cross(R.col(1));
    return R;
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
        w = shortest_solution(A, axial);
    Mat<3> W;
    W << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
    return polar.R * W;
}

template <int Dim>
PrincipalStretches<Dim> principal_stretches(const Mat<Dim>& F) {
    const SymmetricEigen<Dim> eigen = symmetric_eigen<Dim>(polar_decomposition<Dim>(F).S);
    // Ascending; the one that an inversion makes negative is the least in size too.
    return {eigen.values.reverse(), eigen.vectors.rowwise().reverse()};
}

#define PLIANT_INSTANTIATE(Dim)                                            \
    template Mat<Dim> nearest_rotation(const Mat<Dim>&);                   \
    template PolarDecomposition<Dim> polar_decomposition(const Mat<Dim>&); \
    template PrincipalStretches<Dim> principal_stretches(const Mat<Dim>&)
PLIANT_INSTANTIATE(2);
PLIANT_INSTANTIATE(3);
#undef PLIANT_INSTANTIATE

}  // namespace pliant
