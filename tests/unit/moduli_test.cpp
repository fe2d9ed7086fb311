// Elastic constants: textbook values, round trips, and what is refused.
#include <pliant/continuum/moduli.h>
#include <pliant/continuum/strain.h>
#include <pliant/math/error.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <limits>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinRel;

TEST_CASE("Constants of steel have their textbook values", "[moduli]") {
    const auto steel = IsotropicModuli::from_young_poisson(200e9, 0.3);
    CHECK_THAT(steel.shear_modulus(), WithinRel(200e9 / 2.6, 1e-15));
    CHECK_THAT(steel.shear_modulus(), WithinRel(76.923e9, 1e-5));
    CHECK_THAT(steel.bulk_modulus(), WithinRel(166.667e9, 1e-5));
    CHECK_THAT(steel.lambda(), WithinRel(115.385e9, 1e-5));
}

TEST_CASE("Any pair of constants gives back the others", "[moduli]") {
    const Real nu = GENERATE(-0.9, -0.5, 0.0, 0.1, 0.3, 0.45, 0.4999);
    const Real youngs_modulus = GENERATE(1e-3, 1e6, 200e9);
    const auto m = IsotropicModuli::from_young_poisson(youngs_modulus, nu);
    // Digits are lost where 1 - 2 nu or 1 + nu come from a difference. Poisson's ratio itself may vanish, 1 + nu may not.
    const Real tolerance = 1e-14 / ((1 - 2 * nu) * (1 + nu));
    for (const auto& other : {IsotropicModuli::from_lame(m.lambda(), m.mu()),
                              IsotropicModuli::from_shear_bulk(m.shear_modulus(), m.bulk_modulus())}) {
        CHECK_THAT(other.youngs_modulus(), WithinRel(youngs_modulus, tolerance));
        CHECK_THAT(1 + other.poisson_ratio(), WithinRel(1 + nu, tolerance));
        CHECK_THAT(other.bulk_modulus(), WithinRel(m.bulk_modulus(), tolerance));
        CHECK_THAT(other.shear_modulus(), WithinRel(m.shear_modulus(), tolerance));
    }
}

TEST_CASE("Extreme but legal Poisson's ratios have their closed forms", "[moduli]") {
    const auto auxetic = IsotropicModuli::from_young_poisson(1e6, -0.9);
    CHECK_THAT(auxetic.lambda(), WithinRel(-3.2142857142857e6, 1e-12));
    CHECK_THAT(auxetic.shear_modulus(), WithinRel(5e6, 1e-14));
    CHECK_THAT(auxetic.bulk_modulus(), WithinRel(1e6 / 8.4, 1e-14));
    const auto rubber = IsotropicModuli::from_young_poisson(1e6, 0.4999);
    CHECK_THAT(rubber.bulk_modulus() / rubber.shear_modulus(), WithinRel(4999.67, 1e-6));
}

TEST_CASE("What is no material is refused by name", "[moduli]") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN(), inf = std::numeric_limits<Real>::infinity();
    for (const Real bad : {0.0, -1.0, nan, inf, -inf, 1e308 * 2})
        CHECK_THROWS_WITH(IsotropicModuli::from_young_poisson(bad, 0.3), ContainsSubstring("youngs_modulus"));
    for (const Real bad : {0.5, 0.6, -1.0, -1.2, nan, inf, -inf})
        CHECK_THROWS_WITH(IsotropicModuli::from_young_poisson(1e6, bad),
                          ContainsSubstring("poisson_ratio") && ContainsSubstring("(-1, 0.5)"));
    CHECK_THROWS_WITH(IsotropicModuli::from_lame(1.0, 0.0), ContainsSubstring("mu"));
    CHECK_THROWS_WITH(IsotropicModuli::from_lame(-0.7, 1.0), ContainsSubstring("lambda"));
    CHECK_THROWS_WITH(IsotropicModuli::from_lame(nan, 1.0), ContainsSubstring("lambda"));
    CHECK_THROWS_WITH(IsotropicModuli::from_shear_bulk(-1.0, 1.0), ContainsSubstring("shear_modulus"));
    CHECK_THROWS_WITH(IsotropicModuli::from_shear_bulk(1.0, 0.0), ContainsSubstring("bulk_modulus"));
    // A bulk modulus beyond what a number can hold.
    CHECK_THROWS_AS(IsotropicModuli::from_young_poisson(1e308, 0.5 - 1e-12), Refused);
}

TEST_CASE("Hooke's law as a matrix equals the tensor form", "[moduli]") {
    const auto m = IsotropicModuli::from_young_poisson(3e5, 0.37);
    Mat<3> strain;
    strain << 0.02, 0.003, -0.004, 0.003, -0.01, 0.005, -0.004, 0.005, 0.007;
    const Mat<3> stress = hooke_stress<3>(m.lame(), strain);
    const Mat<3> by_matrix = tensor_from_voigt_stress<3>(elasticity_matrix(m) * voigt_strain<3>(strain));
    CHECK((stress - by_matrix).norm() < 1e-14 * stress.norm());

    // Work of both forms: half stress : strain.
    const Real density = hooke_energy_density<3>(m.lame(), strain);
    CHECK_THAT(density, WithinRel(0.5 * (stress.cwiseProduct(strain)).sum(), 1e-14));
    CHECK_THAT(density, WithinRel(0.5 * voigt_strain<3>(strain).dot(elasticity_matrix(m) * voigt_strain<3>(strain)), 1e-13));
}

TEST_CASE("The plane laws are the law of space with the thickness held or free", "[moduli]") {
    const auto m = IsotropicModuli::from_young_poisson(3e5, 0.37);
    Mat<2> plane;
    plane << 0.02, 0.003, 0.003, -0.01;
    Mat<3> strain = Mat<3>::Zero();
    strain.topLeftCorner<2, 2>() = plane;

    const Mat<2> held = tensor_from_voigt_stress<2>(plane_strain_matrix(m) * voigt_strain<2>(plane));
    CHECK((held - hooke_stress<3>(m.lame(), strain).topLeftCorner<2, 2>()).norm() < 1e-14 * held.norm());

    // The thickness changes until nothing pulls on it: strain_zz = -lambda (strain_xx + strain_yy) / (lambda + 2 mu).
    strain(2, 2) = -m.lambda() * plane.trace() / (m.lambda() + 2 * m.mu());
    const Mat<3> stress = hooke_stress<3>(m.lame(), strain);
    const Mat<2> free = tensor_from_voigt_stress<2>(plane_stress_matrix(m) * voigt_strain<2>(plane));
    CHECK(std::abs(stress(2, 2)) < 1e-14 * stress.norm());
    CHECK((free - stress.topLeftCorner<2, 2>()).norm() < 1e-14 * free.norm());
    CHECK((free - hooke_stress<2>(m.plane_stress_lame(), plane)).norm() < 1e-14 * free.norm());
    // The textbook form Y / (1 - nu^2) on the diagonal.
    CHECK_THAT(plane_stress_matrix(m)(0, 0), WithinRel(3e5 / (1 - 0.37 * 0.37), 1e-14));
}

TEST_CASE("Cauchy strain is blind to small rotations and linear in the displacement", "[moduli]") {
    Mat<3> spin;
    spin << 0, -0.2, 0.1, 0.2, 0, -0.3, -0.1, 0.3, 0;
    CHECK(cauchy_strain<3>(spin).isZero(0));
    // A finite rotation by 30 degrees gives the spurious strain cos 30° - 1.
    const Real angle = 3.14159265358979323846 / 6;
    Mat<2> turn;
    turn << std::cos(angle) - 1, -std::sin(angle), std::sin(angle), std::cos(angle) - 1;
    CHECK_THAT(cauchy_strain<2>(turn)(0, 0), WithinRel(-0.1339746, 1e-6));
}
