#include <pliant/continuum/moduli.h>
#include <pliant/continuum/require.h>
#include <pliant/math/error.h>

#include <cmath>

namespace pliant {
namespace {

// Matrix with lambda + 2 mu on the normal diagonal, lambda beside it and mu for each shear component.
template <int Dim>
Mat<Dim*(Dim + 1) / 2> voigt_matrix(const Lame& material) {
    Mat<Dim*(Dim + 1) / 2> matrix = Mat<Dim*(Dim + 1) / 2>::Zero();
    matrix.diagonal().setConstant(material.mu);
    matrix.template topLeftCorner<Dim, Dim>().setConstant(material.lambda);
    matrix.diagonal().template head<Dim>().setConstant(material.lambda + 2 * material.mu);
    return matrix;
}

}  // namespace

IsotropicModuli::IsotropicModuli(Real youngs_modulus, Real poisson_ratio, Lame lame, Real bulk_modulus)
    : youngs_modulus_(youngs_modulus), poisson_ratio_(poisson_ratio), lame_(lame), bulk_modulus_(bulk_modulus) {}

IsotropicModuli IsotropicModuli::from_young_poisson(Real youngs_modulus, Real poisson_ratio) {
    require_positive_modulus("youngs_modulus", youngs_modulus);
    const Real nu = poisson_ratio;
    if (!(nu > -1 && nu < 0.5)) throw Refused("poisson_ratio", nu, "", "a value in (-1, 0.5)");

    const Real mu = youngs_modulus / (2 * (1 + nu));
    const Real bulk = youngs_modulus / (3 * (1 - 2 * nu));
    const Real lambda = 3 * bulk * (nu / (1 + nu));
    if (!std::isfinite(mu) || !std::isfinite(bulk) || !(mu > 0) || !(bulk > 0))
        throw Refused("youngs_modulus", youngs_modulus, "Pa", "a value whose shear and bulk modulus are finite and > 0");
    return {youngs_modulus, nu, {lambda, mu}, bulk};
}

IsotropicModuli IsotropicModuli::from_lame(Real lambda, Real mu) {
    require_positive_modulus("mu", mu);
    const Real bulk = lambda + 2 * mu / 3;
    if (!(bulk > 0) || !std::isfinite(bulk)) throw Refused("lambda", lambda, "Pa", "a finite value > -2/3 mu");
    return {3 * bulk * (mu / (lambda + mu)), 0.5 * lambda / (lambda + mu), {lambda, mu}, bulk};
}

IsotropicModuli IsotropicModuli::from_shear_bulk(Real shear_modulus, Real bulk_modulus) {
    require_positive_modulus("shear_modulus", shear_modulus);
    require_positive_modulus("bulk_modulus", bulk_modulus);
    const Real G = shear_modulus, K = bulk_modulus, sum = 3 * K + G;
    return {9 * K * (G / sum), (1.5 * K - G) / sum, {K - 2 * G / 3, G}, K};
}

Lame IsotropicModuli::plane_stress_lame() const {
    const auto [lambda, mu] = lame_;
    return {2 * mu * (lambda / (lambda + 2 * mu)), mu};
}

Mat<6> elasticity_matrix(const IsotropicModuli& material) { return voigt_matrix<3>(material.lame()); }
Mat<3> plane_strain_matrix(const IsotropicModuli& material) { return voigt_matrix<2>(material.lame()); }
Mat<3> plane_stress_matrix(const IsotropicModuli& material) { return voigt_matrix<2>(material.plane_stress_lame()); }

}  // namespace pliant
