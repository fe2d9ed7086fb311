#include <pliant/continuum/deformation_map.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant {
namespace {

// cos(a) - 1 and sin(a)/a without cancellation.
Real cosine_less_one(Real a) {
    const Real s = std::sin(a / 2);
    return -2 * s * s;
}
Real sine_over(Real a) { return a == 0 ? 1 : std::sin(a) / a; }
// (1 - cos(a)) / a.
Real versine_over(Real a) { return std::sin(a / 2) * sine_over(a / 2); }

// Rotation less the identity, about an axis of coordinates.
Mat<3> turn_less_identity(int axis, Real angle) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    Mat<3> H = Mat<3>::Zero();
    H(i, i) = H(j, j) = cosine_less_one(angle);
    H(j, i) = std::sin(angle);
    H(i, j) = -H(j, i);
    return H;
}

// The larger principal stretch of a simple shear; the smaller one is its inverse.
Real shear_stretch(Real gamma) { return std::hypot(gamma / 2, 1) + std::abs(gamma) / 2; }

}  // namespace

Vec<3> DeformationMap::position(const Vec<3>& X) const {
    if (homogeneous()) return X + displacement_gradient(X) * X + translation;
    if (kind == MapKind::bend) {
        const Real a = curvature * X[0], s = std::sin(a), c = std::cos(a);
        return Vec<3>(X[0] * sine_over(a) - X[1] * s, X[0] * versine_over(a) + X[1] * c, X[2]) + translation;
    }
    const Real a = twist * X[0], s = std::sin(a), c = std::cos(a);
    return Vec<3>(X[0], X[1] * c - X[2] * s, X[1] * s + X[2] * c) + translation;
}

Mat<3> DeformationMap::displacement_gradient(const Vec<3>& X) const {
    Mat<3> H = Mat<3>::Zero();
    switch (kind) {
        case MapKind::translation:
            break;
        case MapKind::rotation:
            return turn_less_identity(axis, angle);
        case MapKind::stretch:
            H.diagonal() = stretches - Vec<3>::Ones();
            break;
        case MapKind::shear:
            H(0, 1) = shear;
            break;
        case MapKind::free:
            return gradient - Mat<3>::Identity();
        case MapKind::bend: {
            const Real a = curvature * X[0];
            H = turn_less_identity(2, a);
            H(0, 0) -= curvature * X[1] * std::cos(a);
            H(1, 0) -= curvature * X[1] * std::sin(a);
            break;
        }
        case MapKind::twist: {
            const Real a = twist * X[0], s = std::sin(a), c = std::cos(a);
            H = turn_less_identity(0, a);
            H(1, 0) = -twist * (X[1] * s + X[2] * c);
            H(2, 0) = twist * (X[1] * c - X[2] * s);
            break;
        }
    }
    return H;
}

Mat<3> DeformationMap::deformation_gradient(const Vec<3>& X) const {
    if (kind == MapKind::free) return gradient;
    return Mat<3>::Identity() + displacement_gradient(X);
}

Real DeformationMap::volume_ratio(const Vec<3>& X) const {
    switch (kind) {
        case MapKind::stretch:
            return stretches.prod();
        case MapKind::free:
            return gradient.determinant();
        case MapKind::bend:
            return 1 - curvature * X[1];
        default:
            return 1;
    }
}

std::optional<Vec<3>> DeformationMap::principal_stretches(const Vec<3>& X) const {
    const auto of_shear = [](Real gamma) {
        const Real s = shear_stretch(gamma);
        return Vec<3>(s, 1, 1 / s);
    };
    Vec<3> s = Vec<3>::Ones();
    switch (kind) {
        case MapKind::free:
            return std::nullopt;
        case MapKind::shear:
            return of_shear(shear);
        case MapKind::twist:
            return of_shear(twist * std::hypot(X[1], X[2]));
        case MapKind::stretch:
            s = stretches;
            break;
        case MapKind::bend:
            s[0] = 1 - curvature * X[1];
            break;
        default:
            break;
    }
    // S has only positive eigenvalues, or, of an inverted body, one that is negative: the least.
    const bool inverted = s.prod() < 0;
    s = s.cwiseAbs();
    std::sort(s.begin(), s.end(), std::greater<>());
    if (inverted) s[2] = -s[2];
    return s;
}

std::optional<Real> DeformationMap::rotation_angle(const Vec<3>& X) const {
    const auto within_half_turn = [](Real a) { return std::abs(std::remainder(a, 2 * std::numbers::pi)); };
    switch (kind) {
        case MapKind::translation:
            return 0;
        case MapKind::rotation:
            return within_half_turn(angle);
        case MapKind::stretch:
            // Two negative stretches are a half turn.
            if (!(stretches.prod() > 0)) return std::nullopt;
            return stretches.minCoeff() < 0 ? std::numbers::pi : 0;
        case MapKind::shear:
            return std::atan(std::abs(shear) / 2);
        case MapKind::bend:
            if (!(curvature * X[1] < 1)) return std::nullopt;
            return within_half_turn(curvature * X[0]);
        default:
            return std::nullopt;
    }
}

std::optional<Mat<3>> DeformationMap::right_cauchy_green(const Vec<3>& X) const {
    Mat<3> C = Mat<3>::Identity();
    switch (kind) {
        case MapKind::free:
            return std::nullopt;
        case MapKind::stretch:
            C.diagonal() = stretches.cwiseAbs2();
            break;
        case MapKind::shear:
            C(0, 1) = C(1, 0) = shear;
            C(1, 1) += shear * shear;
            break;
        case MapKind::bend:
            C(0, 0) = std::pow(1 - curvature * X[1], 2);
            break;
        case MapKind::twist:
            C(0, 1) = C(1, 0) = -twist * X[2];
            C(0, 2) = C(2, 0) = twist * X[1];
            C(0, 0) += twist * twist * (X[1] * X[1] + X[2] * X[2]);
            break;
        default:
            break;
    }
    return C;
}

}  // namespace pliant
