// Elastic constants in the plane: closed forms, round trips, and what is no material.
#include <pliant/continuum/plane_moduli.h>
#include <pliant/math/error.h>

#include <Eigen/LU>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <limits>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("A thin plate keeps Y and nu, a held one is stiffer", "[moduli]") {
    const Real Y = 2e11, nu = GENERATE(-0.6, 0.0, 0.3, 0.45);
    const auto material = IsotropicModuli::from_young_poisson(Y, nu);
    const auto thin = PlaneModuli::of(material, Plane::stress), held = PlaneModuli::of(material, Plane::strain);
    CHECK_THAT(thin.youngs_modulus(), WithinRel(Y, 1e-13));
    CHECK_THAT(thin.poisson_ratio(), WithinAbs(nu, 1e-13));
    CHECK_THAT(held.youngs_modulus(), WithinRel(Y / (1 - nu * nu), 1e-13));
    CHECK_THAT(held.poisson_ratio(), WithinAbs(nu / (1 - nu), 1e-13));
    CHECK(thin.shear_modulus() == material.shear_modulus());
    CHECK(held.shear_modulus() == material.shear_modulus());

    // A pull along x in the plane, by the matrices of Hooke's law.
    for (const auto& [moduli, matrix] :
         {std::pair{thin, plane_stress_matrix(material)}, std::pair{held, plane_strain_matrix(material)}}) {
        const Vec<3> strain = matrix.inverse() * Vec<3>(1, 0, 0);
        CHECK_THAT(1 / strain[0], WithinRel(moduli.youngs_modulus(), 1e-12));
        CHECK_THAT(-strain[1] / strain[0], WithinAbs(moduli.poisson_ratio(), 1e-12));
        const Vec<3> squeezed = matrix.inverse() * Vec<3>(1, 1, 0);
        CHECK_THAT(1 / (squeezed[0] + squeezed[1]), WithinRel(moduli.bulk_modulus(), 1e-12));
    }
}

TEST_CASE("Pairs of constants in the plane go round, and back to the material", "[moduli]") {
    const Plane plane = GENERATE(Plane::strain, Plane::stress);
    const Real nu = GENERATE(-0.9, -0.3, 0.0, 0.3, 0.49);
    const auto material = IsotropicModuli::from_young_poisson(3e5, nu);
    const auto m = PlaneModuli::of(material, plane);
    for (const auto& other : {PlaneModuli::from_young_poisson(m.youngs_modulus(), m.poisson_ratio()),
                              PlaneModuli::from_lame(m.lame().lambda, m.lame().mu),
                              PlaneModuli::from_shear_bulk(m.shear_modulus(), m.bulk_modulus())}) {
        CHECK_THAT(other.bulk_modulus(), WithinRel(m.bulk_modulus(), 1e-11));
        CHECK_THAT(other.shear_modulus(), WithinRel(m.shear_modulus(), 1e-11));
        CHECK_THAT(other.material(plane).youngs_modulus(), WithinRel(3e5, 1e-11));
        CHECK_THAT(other.material(plane).poisson_ratio(), WithinAbs(nu, 1e-11));
    }
}

TEST_CASE("What is no material in the plane is refused by name", "[moduli]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN(), inf = std::numeric_limits<Real>::infinity();
    for (const Real bad : {0.0, -1.0, nan, inf}) {
        CHECK_THROWS_WITH(PlaneModuli::from_young_poisson(bad, 0.3), ContainsSubstring("youngs_modulus"));
        CHECK_THROWS_WITH(PlaneModuli::from_lame(1, bad), ContainsSubstring("mu"));
        CHECK_THROWS_WITH(PlaneModuli::from_shear_bulk(1, bad), ContainsSubstring("bulk_modulus"));
    }
    for (const Real bad : {1.0, -1.0, 1.2, nan})
        CHECK_THROWS_WITH(PlaneModuli::from_young_poisson(1, bad), ContainsSubstring("(-1, 1)"));
    CHECK_THROWS_WITH(PlaneModuli::from_lame(-1, 1), ContainsSubstring("lambda"));
    // Stable in the plane, but of no material in space.
    const auto wide = PlaneModuli::from_young_poisson(1, 0.7);
    CHECK_THROWS_AS(wide.material(Plane::stress), Refused);
    CHECK_NOTHROW(wide.material(Plane::strain));
}
