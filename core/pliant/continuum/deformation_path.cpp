#include <pliant/continuum/deformation_path.h>

#include <pliant/continuum/uniaxial.h>

#include <cmath>

namespace pliant {

std::optional<Mat<3>> DeformationPath::at(const EnergyDensity<3>& energy, Real amount) const {
    Mat<3> F = Mat<3>::Identity();
    switch (path_) {
        case PathKind::uniaxial: {
            const auto a = lateral_stretch(energy, amount);
            if (!a) return std::nullopt;
            F = Vec<3>(amount, *a, *a).asDiagonal();
            break;
        }
        case PathKind::held:
            F(0, 0) = amount;
            break;
        case PathKind::volumetric:
            F *= amount;
            break;
        case PathKind::shear:
            F(0, 1) = amount;
            break;
        case PathKind::free:
            F += amount * (given_ - Mat<3>::Identity());
            break;
    }
    if (!energy.admits(F)) return std::nullopt;
    return F;
}

Real DeformationPath::stress(const Mat<3>& P) const {
    if (path_ == PathKind::free) return P.cwiseProduct(given_ - Mat<3>::Identity()).sum();
    return path_ == PathKind::shear ? P(0, 1) : P(0, 0);
}

Real DeformationPath::stiffness(const EnergyDensity<3>& energy, const Mat<3>& F) const {
    Mat<3> along = Mat<3>::Zero(), across = Mat<3>::Zero();
    switch (path_) {
        case PathKind::uniaxial:
        case PathKind::held:
            along(0, 0) = 1;
            break;
        case PathKind::volumetric:
            along.setIdentity();
            break;
        case PathKind::shear:
            along(0, 1) = 1;
            break;
        case PathKind::free:
            along = given_ - Mat<3>::Identity();
            break;
    }
    Mat<3> change = energy.differential(F, along);
    if (path_ == PathKind::uniaxial) {
        // The width follows so that the stress across stays 0.
        across(1, 1) = across(2, 2) = 1;
        const Mat<3> of_width = energy.differential(F, across);
        if (of_width(1, 1) != 0) change -= change(1, 1) / of_width(1, 1) * of_width;
    }
    return stress(change);
}

Real DeformationPath::modulus(const Lame& material) const {
    const auto [lambda, mu] = material;
    switch (path_) {
        case PathKind::uniaxial:
            return mu * (3 * lambda + 2 * mu) / (lambda + mu);
        case PathKind::held:
            return lambda + 2 * mu;
        case PathKind::volumetric:
            return 3 * lambda + 2 * mu;
        case PathKind::shear:
            return mu;
        case PathKind::free:
            break;
    }
    return 0;
}

std::optional<Real> DeformationPath::exact_stress(const EnergyDensity<3>& energy, Real s) const {
    const auto [lambda, mu] = energy.material();
    const Real M = modulus(energy.material());
    if (path_ == PathKind::free || !at(energy, s)) return std::nullopt;
    switch (energy.energy()) {
        case Energy::linear:
            return path_ == PathKind::shear ? M * s : M * (s - 1);
        case Energy::stvk:
            if (path_ == PathKind::shear) return mu * s + s * s * s * (mu + lambda / 2);
            if (path_ == PathKind::uniaxial && *lateral_stretch(energy, s) == 0) return std::nullopt;
            return M * s * (s * s - 1) / 2;
        case Energy::corotated:
            // Without a rotation it is the linear energy.
            if (path_ == PathKind::shear || (path_ == PathKind::volumetric && s <= 0)) return std::nullopt;
            return M * (s - 1);
        case Energy::neo_hookean:
            if (path_ == PathKind::shear) return mu * s;
            if (path_ == PathKind::held) return mu * (s - 1 / s) + lambda * std::log(s) / s;
            if (path_ == PathKind::volumetric) return mu * (s - 1 / s) + 3 * lambda * std::log(s) / s;
            return std::nullopt;
    }
    return std::nullopt;
}

std::optional<Real> DeformationPath::exact_psi(const EnergyDensity<3>& energy, Real s) const {
    if (!stretches() || energy.energy() == Energy::neo_hookean || !exact_stress(energy, s)) return std::nullopt;
    // Three sides do the work when the volume changes alike in all directions.
    const Real M = modulus(energy.material()) * (path_ == PathKind::volumetric ? 3 : 1);
    const Real strain = energy.energy() == Energy::stvk ? (s * s - 1) / 2 : s - 1;
    return 0.5 * M * strain * strain;
}

}  // namespace pliant
