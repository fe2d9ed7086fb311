// Measures of strain, made from the displacement gradient H(i, j) = du_i/dX_j (dimensionless) [Bonet2008 §4.5].
#pragma once
#include <pliant/math/types.h>

#include <type_traits>

namespace pliant {

// The measures may be evaluated in another type of number, one that counts operations for example: cauchy_strain<3, Number>(H).
template <class Scalar, int Dim>
using MatOf = std::type_identity_t<Eigen::Matrix<Scalar, Dim, Dim>>;

// Cauchy (small) strain: (H + H^T) / 2. It is linear in the displacement, and not zero for a finite rotation.
template <int Dim, class Scalar = Real>
Eigen::Matrix<Scalar, Dim, Dim> cauchy_strain(const MatOf<Scalar, Dim>& displacement_gradient) {
    return Scalar(0.5) * (displacement_gradient + displacement_gradient.transpose());
}

// Green-Lagrange strain: (H + H^T + H^T H) / 2 = (F^T F - I) / 2. It is 0 exactly for rigid motions.
template <int Dim, class Scalar = Real>
Eigen::Matrix<Scalar, Dim, Dim> green_strain(const MatOf<Scalar, Dim>& displacement_gradient) {
    return Scalar(0.5) * (displacement_gradient + displacement_gradient.transpose() +
                          displacement_gradient.transpose() * displacement_gradient);
}

// Right Cauchy-Green tensor C = F^T F, with F = I + H: the squared stretch of a unit direction v at rest is v^T C v.
template <int Dim, class Scalar = Real>
Eigen::Matrix<Scalar, Dim, Dim> right_cauchy_green(const MatOf<Scalar, Dim>& deformation_gradient) {
    return deformation_gradient.transpose() * deformation_gradient;
}

// Number of different components of a symmetric tensor: 3 in the plane, 6 in space.
template <int Dim>
inline constexpr int voigt_size = Dim*(Dim + 1) / 2;

// A strain as a column, order xx, yy, xy or xx, yy, zz, yz, xz, xy, with engineering shear gamma = 2 strain_ij.
template <int Dim>
Vec<voigt_size<Dim>> voigt_strain(const Mat<Dim>& strain) {
    if constexpr (Dim == 2)
        return {strain(0, 0), strain(1, 1), 2 * strain(0, 1)};
    else
        return {strain(0, 0), strain(1, 1), strain(2, 2), 2 * strain(1, 2), 2 * strain(0, 2), 2 * strain(0, 1)};
}

// The stress tensor of a Voigt column in the same order (without the factor 2).
template <int Dim>
Mat<Dim> tensor_from_voigt_stress(const Vec<voigt_size<Dim>>& s) {
    Mat<Dim> stress;
    if constexpr (Dim == 2)
        stress << s[0], s[2], s[2], s[1];
    else
        stress << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
    return stress;
}

// A tensor per element: Dim × Dim numbers per column.
template <int Dim>
using Tensors = Eigen::Matrix<Real, Dim * Dim, Eigen::Dynamic>;
template <int Dim>
Eigen::Map<Mat<Dim>> tensor(Tensors<Dim>& tensors, Index i) {
    return Eigen::Map<Mat<Dim>>(tensors.col(i).data());
}
template <int Dim>
Eigen::Map<const Mat<Dim>> tensor(const Tensors<Dim>& tensors, Index i) {
    return Eigen::Map<const Mat<Dim>>(tensors.col(i).data());
}

}  // namespace pliant
