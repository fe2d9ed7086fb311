// Elastic constants of an isotropic linear material, and Hooke's law [TimoshenkoGoodier1970 §6].
#pragma once
#include <pliant/math/types.h>

namespace pliant {

// First and second Lamé coefficient [Pa], the two numbers that Hooke's law needs.
struct Lame {
    Real lambda = 0, mu = 0;
};

// One isotropic material, valid by construction. Every factory throws Refused, naming the argument, when it is not a number
// or does not describe a stable material: shear and bulk modulus positive, so Young's modulus > 0 and -1 < Poisson's ratio < 1/2.
class IsotropicModuli {
public:
    static IsotropicModuli from_young_poisson(Real youngs_modulus, Real poisson_ratio);  // Pa, dimensionless
    static IsotropicModuli from_lame(Real lambda, Real mu);                              // Pa, Pa
    static IsotropicModuli from_shear_bulk(Real shear_modulus, Real bulk_modulus);       // Pa, Pa

    Real youngs_modulus() const { return youngs_modulus_; }  // Y [Pa]
    Real poisson_ratio() const { return poisson_ratio_; }    // nu
    Real shear_modulus() const { return lame_.mu; }          // G = mu [Pa]
    Real bulk_modulus() const { return bulk_modulus_; }      // K = lambda + 2/3 mu [Pa]
    Real lambda() const { return lame_.lambda; }             // Pa
    Real mu() const { return lame_.mu; }                     // Pa

    // The coefficients of three dimensions, which are also those of plane strain in two.
    Lame lame() const { return lame_; }
    // The coefficients for a thin plate that is free to change its thickness: lambda' = 2 lambda mu / (lambda + 2 mu).
    Lame plane_stress_lame() const;

private:
    IsotropicModuli(Real youngs_modulus, Real poisson_ratio, Lame lame, Real bulk_modulus);

    Real youngs_modulus_, poisson_ratio_;
    Lame lame_;
    Real bulk_modulus_;
};

// Hooke's law: stress [Pa] = lambda tr(strain) I + 2 mu strain.
template <int Dim>
Mat<Dim> hooke_stress(const Lame& material, const Mat<Dim>& strain) {
    return material.lambda * strain.trace() * Mat<Dim>::Identity() + 2 * material.mu * strain;
}

// Density of strain energy [J/m^3]: half of strain : stress.
template <int Dim>
Real hooke_energy_density(const Lame& material, const Mat<Dim>& strain) {
    const Real trace = strain.trace();
    return 0.5 * material.lambda * trace * trace + material.mu * strain.squaredNorm();
}

// Hooke's law as a matrix [Pa] on strains in Voigt form (strain.h): order xx, yy, zz, yz, xz, xy, engineering shear.
Mat<6> elasticity_matrix(const IsotropicModuli& material);
// The same in the plane, order xx, yy, xy: nothing stretches out of the plane, or nothing pulls out of it.
Mat<3> plane_strain_matrix(const IsotropicModuli& material);
Mat<3> plane_stress_matrix(const IsotropicModuli& material);

}  // namespace pliant
