// Energy densities: stress and tangent against differences of the energy, known values, and what each energy admits.
#include <pliant/continuum/deformation.h>
#include <pliant/continuum/uniaxial.h>
#include <pliant/math/error.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

using namespace pliant;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr Energy all_energies[]{Energy::linear, Energy::stvk, Energy::corotated, Energy::neo_hookean};

Lame rubber(Real nu = 0.3) { return IsotropicModuli::from_young_poisson(1e6, nu).lame(); }

template <int Dim>
Mat<Dim> random_matrix(std::mt19937& random, Real size) {
    std::uniform_real_distribution<Real> any(-size, size);
    return Mat<Dim>::NullaryExpr([&] { return any(random); });
}

template <int Dim>
Mat<Dim> difference_stress(const EnergyDensity<Dim>& energy, const Mat<Dim>& F, Real h) {
    Mat<Dim> P;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) {
            Mat<Dim> up = F, down = F;
            up(i, j) += h, down(i, j) -= h;
            P(i, j) = (energy.psi(up) - energy.psi(down)) / (2 * h);
        }
    return P;
}

// The corotated energy has kinks where two stretches add up to 0: differences must stay away from them.
template <int Dim>
Real distance_from_kinks(const Mat<Dim>& F) {
    const Vec<Dim> s = principal_stretches<Dim>(F).stretches;
    return s[Dim - 2] + s[Dim - 1];
}

template <int Dim>
void check_derivatives(Energy kind, int trials, Real size, Real floor) {
    std::mt19937 random(7);
    const EnergyDensity<Dim> energy(kind, rubber());
    int checked = 0, inverted = 0;
    for (int k = 0; k < trials; ++k) {
        const Mat<Dim> F = Mat<Dim>::Identity() + random_matrix<Dim>(random, size);
        if (kind == Energy::neo_hookean && F.determinant() < floor) continue;
        if (kind == Energy::corotated && distance_from_kinks<Dim>(F) < floor) continue;
        ++checked, inverted += F.determinant() < 0;
        INFO("energy " << static_cast<int>(kind) << " F\n" << F);
        const Real h = kind == Energy::neo_hookean ? 1e-6 : 1e-5;
        const Mat<Dim> P = energy.P(F);
        const Real scale = P.cwiseAbs().maxCoeff() + 1e4;
        CHECK((P - difference_stress<Dim>(energy, F, h)).cwiseAbs().maxCoeff() < 1e-6 * scale);

        const Mat<Dim* Dim> T = energy.tangent(F);
        CHECK((T - T.transpose()).cwiseAbs().maxCoeff() <= 1e-11 * T.cwiseAbs().maxCoeff());
        const Mat<Dim> dF = random_matrix<Dim>(random, 1);
        const Mat<Dim> dP = (energy.P(F + h * dF) - energy.P(F - h * dF)) / (2 * h);
        CHECK((energy.differential(F, dF) - dP).cwiseAbs().maxCoeff() < 1e-5 * (dP.cwiseAbs().maxCoeff() + 1e5));
        CHECK((T * dF.reshaped() - energy.differential(F, dF).reshaped()).norm() < 1e-11 * T.norm());
    }
    CHECK(checked > trials / 4);
    if (kind != Energy::neo_hookean && size >= 1.5) CHECK(inverted > trials / 20);
}

Mat<3> case_of_the_catalogue() {
    Mat<3> F;
    F << 1.2, 0.3, 0, 0, 0.9, 0.1, 0.05, 0, 1.1;
    return F;
}

Mat<3> diagonal(Real s, Real a, Real b) { return Vec<3>(s, a, b).asDiagonal(); }

}  // namespace

TEST_CASE("P is the derivative of psi and the tangent that of P, near rest, far from it and inverted", "[energy]") {
    for (const Energy kind : all_energies) {
        check_derivatives<3>(kind, 200, 0.3, 0.1);
        check_derivatives<3>(kind, 400, 1.5, 0.1);
        check_derivatives<2>(kind, 200, 1.5, 0.1);
    }
}

TEST_CASE("Where F flattens a body, the energies that admit it have a stress and a tangent, symmetric and finite", "[energy]") {
    for (const Energy kind : {Energy::linear, Energy::stvk, Energy::corotated}) {
        const EnergyDensity<3> energy(kind, rubber());
        for (const Mat<3>& F : {diagonal(1, 1, 0), diagonal(1, 1, 1e-12), diagonal(1, 0, 0), diagonal(0, 0, 0),
                                diagonal(1, 1, -0.5), diagonal(1, -1e-9, 1e-9)}) {
            INFO("energy " << static_cast<int>(kind) << " F\n" << F);
            CHECK(energy.admits(F));
            CHECK(std::isfinite(energy.psi(F)));
            CHECK(energy.P(F).allFinite());
            const Mat<9> T = energy.tangent(F);
            CHECK(T.allFinite());
            CHECK((T - T.transpose()).cwiseAbs().maxCoeff() <= 1e-9 * T.cwiseAbs().maxCoeff());
        }
    }
}

TEST_CASE("Neo-Hookean is infinite where a body is flat or inverted, and resists near it", "[energy]") {
    const EnergyDensity<3> energy(Energy::neo_hookean, rubber());
    for (const Mat<3>& F : {diagonal(1, 1, 0), diagonal(1, 1, -0.1), diagonal(-1, -1, -1)}) {
        CHECK(!energy.admits(F));
        CHECK(energy.psi(F) == HUGE_VAL);
        CHECK_THROWS_AS(energy.P(F), Diverged);
        CHECK_THROWS_AS(energy.tangent(F), Diverged);
    }
    // Turned about twice: a rotation, no inversion.
    CHECK(energy.admits(diagonal(1, -1, -1)));
    Real last = 0;
    for (const Real s : {1e-1, 1e-2, 1e-4, 1e-8}) {
        const Real P = *uniaxial_stress(energy, s);
        CHECK(P < 3 * last - 1);
        last = P;
    }
}

TEST_CASE("Turning a deformed body turns its stress; the linear energy takes rotation for strain", "[energy]") {
    std::mt19937 random(3);
    for (const Energy kind : all_energies) {
        const EnergyDensity<3> energy(kind, rubber());
        for (int k = 0; k < 50; ++k) {
            const Mat<3> F = Mat<3>::Identity() + random_matrix<3>(random, 0.3);
            const Mat<3> Q = nearest_rotation<3>(random_matrix<3>(random, 1));
            const Real changed = std::abs(energy.psi(Q * F) - energy.psi(F));
            const Real scale = 1e6;
            if (kind == Energy::linear) {
                if (Q.trace() < 2) CHECK(changed > 1e-3 * scale);
                continue;
            }
            CHECK(changed < 1e-11 * scale);
            CHECK((energy.P(Q * F) - Q * energy.P(F)).norm() < 1e-10 * scale);
            CHECK((energy.P(F * Q) - energy.P(F) * Q).norm() < 1e-10 * scale);
        }
    }
}

TEST_CASE("A rotation by 90 and by 30 degrees has no stress but in the linear energy", "[energy]") {
    for (const Real degrees : {90.0, 30.0}) {
        const Real angle = degrees * std::numbers::pi / 180;
        const Mat<3> F = Eigen::AngleAxis<Real>(angle, Vec<3>::UnitZ()).toRotationMatrix();
        for (const Energy kind : {Energy::stvk, Energy::corotated, Energy::neo_hookean}) {
            const EnergyDensity<3> energy(kind, rubber());
            CHECK(energy.psi(F) < 1e-9);
            CHECK(energy.P(F).norm() < 1e-8);
        }
        const Mat<3> strain = cauchy_strain<3>(F - Mat<3>::Identity());
        CHECK_THAT(strain(0, 0), WithinAbs(std::cos(angle) - 1, 1e-15));
        CHECK_THAT(strain(1, 1), WithinAbs(degrees == 90 ? -1 : -0.1339746, 1e-7));
        CHECK(EnergyDensity<3>(Energy::linear, rubber()).P(F).norm() > 1e5);
    }
}

TEST_CASE("Stress and energy of a general deformation", "[energy]") {
    const Mat<3> F = case_of_the_catalogue();
    struct Known {
        Energy energy;
        Vec<3> row;
        Real psi;
    };
    for (const auto& [kind, row, psi] : {Known{Energy::stvk, {440480.769, 203293.269, 35769.231}, 74323.1671},
                                         Known{Energy::corotated, {290365.966, 139190.233, 15482.497}, 57948.6062},
                                         Known{Energy::neo_hookean, {224753.963, 114188.734, 10762.932}, 50116.2458}}) {
        const EnergyDensity<3> energy(kind, rubber());
        CHECK_THAT(energy.psi(F), WithinAbs(psi, 0.6e-4));
        for (int j = 0; j < 3; ++j) CHECK_THAT(energy.P(F)(0, j), WithinAbs(row[j], 0.6e-3));
        CHECK((energy.P(F) - difference_stress<3>(energy, F, 1e-5)).norm() < 1e-8 * energy.P(F).norm());
    }
    const Mat<3> R = nearest_rotation<3>(F);
    CHECK_THAT(R(0, 0), WithinAbs(0.989396739, 1e-9));
    CHECK_THAT(R(0, 1), WithinAbs(0.143205931, 1e-9));
    CHECK_THAT(R(0, 2), WithinAbs(-0.024210632, 1e-9));
}

TEST_CASE("A bar that is free across follows its closed form", "[energy]") {
    const EnergyDensity<3> stvk(Energy::stvk, rubber()), neo(Energy::neo_hookean, rubber()),
        corotated(Energy::corotated, rubber());
    CHECK_THAT(*uniaxial_stress(stvk, 1.3), WithinRel(448500.0, 1e-12));
    CHECK_THAT(*lateral_stretch(stvk, 1.3), WithinAbs(0.890505474, 1e-9));
    const Real softest = 1 / std::sqrt(3.0);
    CHECK_THAT(*uniaxial_stress(stvk, softest), WithinRel(-1e6 / (3 * std::sqrt(3.0)), 1e-12));
    CHECK_THAT(*uniaxial_stress(neo, 0.5), WithinAbs(-935352.06, 0.006));
    CHECK_THAT(*lateral_stretch(neo, 0.5), WithinAbs(1.2107674, 6e-8));
    CHECK_THAT(*uniaxial_stress(neo, 0.7), WithinAbs(-405230.42, 0.006));
    CHECK_THAT(*uniaxial_stress(neo, 1.5), WithinAbs(378280.18, 0.006));
    CHECK_THAT(*uniaxial_stress(neo, 2), WithinAbs(646744.66, 0.006));
    for (const Real s : {0.4, 1.0, 1.8}) CHECK_THAT(*uniaxial_stress(corotated, s), WithinAbs(1e6 * (s - 1), 1e-8));
}

TEST_CASE("Across a free bar there is no stress, and widths that do not exist are told", "[energy]") {
    for (const Energy kind : all_energies)
        for (const Real nu : {-0.9, -0.3, 0.0, 0.3, 0.4999})
            for (const Real s : {-0.3, 0.0, 1e-6, 0.05, 0.5, 0.95, 1.0, 1.05, 1.5, 2.5, 40.0}) {
                const EnergyDensity<3> energy(kind, rubber(nu));
                const auto a = lateral_stretch(energy, s);
                INFO("energy " << static_cast<int>(kind) << " nu " << nu << " s " << s);
                if (kind == Energy::linear || kind == Energy::stvk) CHECK(a);
                if (kind == Energy::neo_hookean && s <= 0) CHECK(!a);
                if (!a) continue;
                const Mat<3> P = energy.P(diagonal(s, *a, *a));
                const Real scale = P.cwiseAbs().maxCoeff() + energy.material().mu + std::abs(energy.material().lambda);
                CHECK(std::abs(P(1, 1)) < 1e-9 * scale * std::max(s, 1.0));
                CHECK(std::abs(P(2, 2)) < 1e-9 * scale * std::max(s, 1.0));
            }
    CHECK(!lateral_stretch(EnergyDensity<3>(Energy::neo_hookean, rubber(-0.9)), 0.5));
    CHECK(*lateral_stretch(EnergyDensity<3>(Energy::stvk, rubber()), 2.2) == 0);
}

TEST_CASE("Shear and volume change follow their closed forms", "[energy]") {
    const Lame m = rubber();
    const Real K = m.lambda + 2 * m.mu / 3;
    for (const Real gamma : {-0.7, 0.2, 1.5}) {
        Mat<3> F = Mat<3>::Identity();
        F(0, 1) = gamma;
        CHECK_THAT(EnergyDensity<3>(Energy::neo_hookean, m).P(F)(0, 1), WithinRel(m.mu * gamma, 1e-12));
        CHECK_THAT(EnergyDensity<3>(Energy::stvk, m).P(F)(0, 1),
                   WithinRel(m.mu * gamma + gamma * gamma * gamma * (m.mu + m.lambda / 2), 1e-12));
    }
    for (const Real s : {0.4, 0.9, 1.7}) {
        const Mat<3> F = s * Mat<3>::Identity();
        CHECK_THAT(EnergyDensity<3>(Energy::stvk, m).P(F)(1, 1), WithinRel(3 * K * s * (s * s - 1) / 2, 1e-12));
        CHECK_THAT(EnergyDensity<3>(Energy::corotated, m).P(F)(1, 1), WithinRel(3 * K * (s - 1), 1e-12));
        CHECK_THAT(EnergyDensity<3>(Energy::neo_hookean, m).P(F)(1, 1),
                   WithinRel(m.mu * (s - 1 / s) + 3 * m.lambda * std::log(s) / s, 1e-12));
    }
}

TEST_CASE("All energies agree to second order near rest", "[energy]") {
    std::mt19937 random(11);
    for (int k = 0; k < 10; ++k) {
        const Mat<3> H = random_matrix<3>(random, 1), strain = 0.5 * (H + H.transpose());
        for (const Energy kind : all_energies) {
            const EnergyDensity<3> energy(kind, rubber());
            // What is left is of third order. The linear energy is that order itself for a symmetric H.
            const auto off = [&](Real t) {
                const Mat<3> F = Mat<3>::Identity() + t * strain;
                return std::abs(energy.psi(F) - hooke_energy_density<3>(rubber(), t * strain));
            };
            for (const Real t : {1e-2, 1e-3}) CHECK(off(t) < 1e7 * t * t * t);  // of second order it would be above 10⁵ t²
            CHECK(energy.psi(Mat<3>::Identity()) == 0);
            CHECK(energy.P(Mat<3>::Identity()).norm() == 0);
            const Mat<3> hooke = hooke_stress<3>(rubber(), strain);
            CHECK((energy.differential(Mat<3>::Identity(), H) - hooke).norm() < 1e-12 * hooke.norm());
        }
    }
}

TEST_CASE("The plane is plane strain", "[energy]") {
    std::mt19937 random(5);
    for (const Energy kind : all_energies)
        for (int k = 0; k < 30; ++k) {
            const Mat<2> F = Mat<2>::Identity() + random_matrix<2>(random, 0.4);
            if (F.determinant() <= 0.05) continue;
            Mat<3> F3 = Mat<3>::Identity();
            F3.topLeftCorner<2, 2>() = F;
            const EnergyDensity<2> flat(kind, rubber());
            const EnergyDensity<3> solid(kind, rubber());
            CHECK_THAT(flat.psi(F), WithinRel(solid.psi(F3), 1e-10));
            CHECK((flat.P(F) - solid.P(F3).topLeftCorner<2, 2>()).norm() < 1e-10 * (1e5 + flat.P(F).norm()));
        }
}
