// Ways to deform a cube, each by one amount: a stretch s, a shear gamma, or a share t of a given deformation.
#pragma once
#include <pliant/continuum/energy_density.h>

#include <optional>

namespace pliant {

enum class PathKind {
    uniaxial,    // F = diag(s, a, a) with the width a at which nothing pulls across
    held,        // F = diag(s, 1, 1)
    volumetric,  // F = s I
    shear,       // F = I + gamma e_x e_y^T
    free         // F = I + t (F_given - I)
};

class DeformationPath {
public:
    // given: where the path `free` leads for t = 1.
    DeformationPath(PathKind path, const Mat<3>& given) : path_(path), given_(given) {}

    PathKind path() const { return path_; }
    bool stretches() const { return path_ == PathKind::uniaxial || path_ == PathKind::held || path_ == PathKind::volumetric; }

    // Empty where the energy is infinite, or where the path has no width (uniaxial.h).
    std::optional<Mat<3>> at(const EnergyDensity<3>& energy, Real amount) const;

    // The stress [Pa] that is plotted over the amount: P_xx, P_xy in shear, and dpsi/dt = P : (F_given - I) when free.
    Real stress(const Mat<3>& P) const;
    // Its change with the amount [Pa]; below 0 the material softens. F is that of the amount.
    Real stiffness(const EnergyDensity<3>& energy, const Mat<3>& F) const;

    // What a stretch is multiplied by in small strain: Young's modulus, lambda + 2 mu or 3 K; mu in shear [Pa]. 0 when free.
    Real modulus(const Lame& material) const;
    // Closed forms, where there is one.
    std::optional<Real> exact_stress(const EnergyDensity<3>&energy, Real amount) const,
        exact_psi(const EnergyDensity<3>&energy, Real amount) const;

private:
    PathKind path_;
    Mat<3> given_;
};

}  // namespace pliant
