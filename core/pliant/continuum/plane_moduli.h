// Elastic constants of an isotropic material as they act in a plane: of the material itself, with its thickness held or free.
#pragma once
#include <pliant/continuum/moduli.h>

namespace pliant {

enum class Plane {
    strain,  // nothing stretches across the plane: a long dam, a slice of a pipe
    stress   // nothing pulls across it: a thin plate
};

// Valid by construction. With the constants of the plane Hooke's law reads sigma = lambda tr(eps) I + 2 mu eps over 2 × 2
// tensors; a pull along one axis gives Y eps and narrows the other by nu eps; an equal stress on all sides changes the area by
// stress / K. Every factory throws Refused, naming the argument, unless G > 0 and K > 0: Y > 0 and -1 < nu < 1, mu > 0 and lambda
// + mu > 0.
class PlaneModuli {
public:
    static PlaneModuli from_young_poisson(Real youngs_modulus, Real poisson_ratio);  // Pa, dimensionless
    static PlaneModuli from_lame(Real lambda, Real mu);                              // Pa, Pa
    static PlaneModuli from_shear_bulk(Real shear_modulus, Real bulk_modulus);       // Pa, Pa
    static PlaneModuli of(const IsotropicModuli& material, Plane plane);

    Real youngs_modulus() const { return 4 * bulk_ * (lame_.mu / (bulk_ + lame_.mu)); }  // Pa
    Real poisson_ratio() const { return (bulk_ - lame_.mu) / (bulk_ + lame_.mu); }       // nu
    Real shear_modulus() const { return lame_.mu; }                                      // Pa
    Real bulk_modulus() const { return bulk_; }                                          // Pa
    Lame lame() const { return lame_; }

    // The material that acts so. Throws Refused when there is none: a Poisson's ratio of 1/2 or more in plane stress, or 1 in
    // plane strain.
    IsotropicModuli material(Plane plane) const;

private:
    PlaneModuli(Lame lame, Real bulk) : lame_(lame), bulk_(bulk) {}

    Lame lame_;
    Real bulk_;  // lambda + mu
};

}  // namespace pliant
