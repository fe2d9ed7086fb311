// Local deformation, made from the deformation gradient F(i, j) = dx_i/dX_j or the displacement gradient H = F - I (both
// dimensionless) [Bonet2008 §4].
#pragma once
#include <pliant/continuum/strain.h>
#include <pliant/math/types.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace pliant {

template <int Dim>
Mat<Dim> deformation_gradient(const Mat<Dim>& displacement_gradient) {
    return Mat<Dim>::Identity() + displacement_gradient;
}
template <int Dim>
Mat<Dim> displacement_gradient(const Mat<Dim>& F) {
    return F - Mat<Dim>::Identity();
}

// Transposed cofactors: det(F) F^-T, also where F has no inverse. It is the derivative of det F.
template <int Dim>
Mat<Dim> cofactor(const Mat<Dim>& F) {
    Mat<Dim> c;
    if constexpr (Dim == 2) {
        c << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
    } else {
        c.col(0) = F.col(1).cross(F.col(2));
        c.col(1) = F.col(2).cross(F.col(0));
        c.col(2) = F.col(0).cross(F.col(1));
    }
    return c;
}

// Volume now over volume at rest, J = det F; negative where the body is turned inside out.
template <int Dim>
Real volume_ratio(const Mat<Dim>& F) {
    return F.determinant();
}

// Area now over area at rest of a surface with the unit normal N at rest (in the plane: length of a line): |cof(F) N|
// [Bonet2008 §4.7, Nanson's formula].
template <int Dim>
Real area_ratio(const Mat<Dim>& F, const Vec<Dim>& N) {
    return (cofactor<Dim>(F) * N).norm();
}

// F = R S with a proper rotation R (det R = 1) and a symmetric S [Bonet2008 §4.6]. R is the rotation nearest to F, so S has no
// negative eigenvalue unless F is inverted, and then one. Where several rotations are equally near, one of them is taken, the
// same each time.
template <int Dim>
struct PolarDecomposition {
    Mat<Dim> R, S;
};

// For every finite F, singular and inverted ones included. In 3D R is the derivative of tr S, found from the invariants of F
// [Lin2022]; near its singularities from a singular value decomposition.
template <int Dim>
PolarDecomposition<Dim> polar_decomposition(const Mat<Dim>& F);
template <int Dim>
Mat<Dim> nearest_rotation(const Mat<Dim>& F);

// Change of the nearest rotation when F changes by dF: R [w] with (tr(S) I - S) w the axial vector of R^T dF - dF^T R. Where R is
// not unique, what is left undetermined is 0.
template <int Dim>
Mat<Dim> rotation_differential(const PolarDecomposition<Dim>& polar, const Mat<Dim>& dF);

// Stretches along the principal directions, descending: the singular values of F, the last one negative where F is inverted; and
// the directions at rest as columns, F v_i = stretch_i R v_i.
template <int Dim>
struct PrincipalStretches {
    Vec<Dim> stretches;
    Mat<Dim> directions;
};
template <int Dim>
PrincipalStretches<Dim> principal_stretches(const Mat<Dim>& F);

}  // namespace pliant
