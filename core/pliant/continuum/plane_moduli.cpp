#include <pliant/continuum/plane_moduli.h>
#include <pliant/continuum/require.h>
#include <pliant/math/error.h>

#include <cmath>

namespace pliant {
PlaneModuli PlaneModuli::from_young_poisson(Real youngs_modulus, Real poisson_ratio) {
    require_positive_modulus("youngs_modulus", youngs_modulus);
    if (!(poisson_ratio > -1 && poisson_ratio < 1))
        throw Refused("poisson_ratio", poisson_ratio, "", "a value in (-1, 1) in the plane");
    return from_shear_bulk(youngs_modulus / (2 * (1 + poisson_ratio)), youngs_modulus / (2 * (1 - poisson_ratio)));
}

PlaneModuli PlaneModuli::from_lame(Real lambda, Real mu) {
    require_positive_modulus("mu", mu);
    const Real bulk = lambda + mu;
    if (!(bulk > 0) || !std::isfinite(bulk)) throw Refused("lambda", lambda, "Pa", "a finite value > -mu in the plane");
    return {{lambda, mu}, bulk};
}

PlaneModuli PlaneModuli::from_shear_bulk(Real shear_modulus, Real bulk_modulus) {
    require_positive_modulus("shear_modulus", shear_modulus);
    require_positive_modulus("bulk_modulus", bulk_modulus);
    return {{bulk_modulus - shear_modulus, shear_modulus}, bulk_modulus};
}

PlaneModuli PlaneModuli::of(const IsotropicModuli& material, Plane plane) {
    const auto [lambda, mu] = plane == Plane::strain ? material.lame() : material.plane_stress_lame();
    return from_lame(lambda, mu);
}

IsotropicModuli PlaneModuli::material(Plane plane) const {
    // A thin plate keeps Young's modulus and Poisson's ratio; a held one keeps Lamé's parameters.
    return plane == Plane::stress ? IsotropicModuli::from_young_poisson(youngs_modulus(), poisson_ratio())
                                  : IsotropicModuli::from_lame(lame_.lambda, lame_.mu);
}

}  // namespace pliant
