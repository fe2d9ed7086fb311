// Chosen maps x = phi(X) that deform a body, each with its analytic gradient: what a chain of approximations can be measured
// against [Bonet2008 §4.2].
#pragma once
#include <pliant/math/types.h>

#include <optional>

namespace pliant {

// The homogeneous ones, whose gradient is the same everywhere, come first.
enum class MapKind { translation, rotation, stretch, shear, free, bend, twist };

// What is not of the kind is not used, save the translation, by which every map moves the body in the end.
//
//   rotation   by the angle about an axis of coordinates, right-handed
//   stretch    x_i = s_i X_i
//   shear      x_1 = X_1 + gamma X_2
//   free       x = F X
//   bend       lines along x become circles of curvature kappa / (1 - kappa X_2), cross-sections stay plane:
//              x_1 = (1/kappa - X_2) sin(kappa X_1), x_2 = 1/kappa - (1/kappa - X_2) cos(kappa X_1)
//   twist      cross-sections turn about the x axis by tau X_1
struct DeformationMap {
    MapKind kind = MapKind::translation;
    Vec<3> translation = Vec<3>::Zero();   // m
    Real angle = 0;                        // rad
    int axis = 2;                          // 0, 1, 2 for x, y, z
    Vec<3> stretches = Vec<3>::Ones();     // dimensionless
    Real shear = 0;                        // gamma, dimensionless
    Real curvature = 0;                    // kappa, 1/m
    Real twist = 0;                        // tau, rad/m
    Mat<3> gradient = Mat<3>::Identity();  // F of the free map

    bool homogeneous() const { return kind < MapKind::bend; }

    // Position [m] of the material point X [m].
    Vec<3> position(const Vec<3>& X) const;
    Vec<3> displacement(const Vec<3>& X) const { return position(X) - X; }
    // H(i, j) = du_i/dX_j; where a map changes little, without the rounding of F - I.
    Mat<3> displacement_gradient(const Vec<3>& X) const;
    // F(i, j) = dx_i/dX_j.
    Mat<3> deformation_gradient(const Vec<3>& X) const;

    // Closed forms at X, from the parameters alone; empty where there is none.
    Real volume_ratio(const Vec<3>& X) const;                          // det F
    std::optional<Vec<3>> principal_stretches(const Vec<3>& X) const;  // descending by magnitude; none for free
    std::optional<Real> rotation_angle(const Vec<3>& X)
        const;  // of R in F = R S, in [0, pi]; none for free and twist, nor where the body has no volume or is inverted
    std::optional<Mat<3>> right_cauchy_green(const Vec<3>& X) const;  // none for free
};

}  // namespace pliant
