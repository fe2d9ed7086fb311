// Bodies that are tested, loaded and stretched, against closed forms, without a lesson.
#include <pliant/continuum/contraction_law.h>
#include <pliant/continuum/deformation_path.h>
#include <pliant/continuum/strain_cost.h>
#include <pliant/mesh/body_grid.h>
#include <pliant/solids/cooks_membrane_table.h>
#include <pliant/solids/loaded_body.h>
#include <pliant/solids/specimen.h>
#include <pliant/solids/stretched_block.h>
#include <pliant/solids/stretched_cube.h>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>

using namespace pliant;
using Catch::Approx;

namespace {

const IsotropicModuli rubber = IsotropicModuli::from_young_poisson(1e6, 0.3);

}  // namespace

TEST_CASE("a specimen reads its modulus off the exact displacements", "[bodies]") {
    for (const MaterialTest test : {MaterialTest::tension, MaterialTest::shear, MaterialTest::pressure}) {
        const Specimen specimen(test, rubber, {.length = 0.2, .width = 0.1, .resolution = 2});
        const Points<3>& X = specimen.mesh().points();
        Points<3> u(3, X.cols()), reaction;
        const Real stress = 1000;
        for (Index n = 0; n < X.cols(); ++n) u.col(n) = specimen.exact_displacement(stress, X.col(n));
        specimen.problem().reaction(u, stress * specimen.unit_load(), reaction);
        CHECK(specimen.strain(u) == Approx(specimen.exact_strain(stress)).epsilon(1e-12));
        CHECK(specimen.volume_change(u) + 1 == Approx(specimen.exact_volume_change(stress) + 1).epsilon(1e-12));
        CHECK(std::abs(specimen.support_force(reaction)) == Approx(stress * specimen.exact_area()).epsilon(1e-9));
        CHECK(specimen.area() == Approx(specimen.exact_area()).epsilon(1e-12));
        CHECK(specimen.body().strain_energy(u) == Approx(specimen.exact_energy(stress)).epsilon(1e-9));
        Real sum = 0;
        for (const auto& [node, weight] : specimen.mean_weights("x_max")) sum += weight;
        CHECK(sum == Approx(1).epsilon(1e-12));
    }
}

TEST_CASE("the loaded faces of a body have their whole area", "[bodies]") {
    const LoadedBodySize size{.radius = 0.1, .length = 0.2, .width = 0.1, .resolution = 4};
    const LoadedBody disc(LoadCase::disc, rubber, size), rod(LoadCase::rod, rubber, size), block(LoadCase::cut, rubber, size);
    CHECK(disc.loaded_area().row(1).sum() == Approx(std::numbers::pi * 0.01).epsilon(1e-9));
    CHECK(rod.loaded_area().row(0).sum() == Approx(0.01).epsilon(1e-12));
    // Faces lie opposite each other.
    CHECK(block.loaded_area().rowwise().sum().norm() < 1e-15);
    CHECK(disc.support_area() == Approx(std::numbers::pi * 0.01).epsilon(1e-9));
}

TEST_CASE("a cube that is stretched in ever smaller steps comes to the law of its contraction", "[bodies]") {
    const auto error = [](int steps) {
        StretchedCube cube(0.3, 0.1, 1);
        Points<3> u = Points<3>::Zero(3, cube.rest().node_count());
        for (int k = 0; k < steps; ++k) {
            cube.begin(u);
            u += cube.increment(0.05 / steps);
        }
        CHECK(cube.axial_strain(u) == Approx(0.5).epsilon(1e-12));
        return std::abs(cube.contraction(u) - exact_contraction(0.3, 0.5));
    };
    const Real coarse = error(10), fine = error(20);
    CHECK(fine < 0.003);
    CHECK(coarse / fine == Approx(2).epsilon(0.1));
}

TEST_CASE("the law of contraction: its estimate, its volume, and where the two part", "[bodies]") {
    CHECK(exact_contraction(0.5, 0.21) == Approx(1 - 1 / 1.1).epsilon(1e-12));
    CHECK(exact_volume_ratio(0.5, 3) == Approx(1).epsilon(1e-12));
    CHECK(exact_volume_ratio(0, 0.25) == Approx(1.25).epsilon(1e-12));
    for (const Real nu : {0., 0.3, 0.49})
        CHECK(linear_overestimate(nu, strain_of_overestimate(nu, 0.05).value()) == Approx(0.05).epsilon(1e-9));
    CHECK_FALSE(strain_of_overestimate(-0.9999, 0.5));
}

TEST_CASE("the converged deflections of the membrane: the table, what lies between, and nothing outside", "[bodies]") {
    for (const auto& [nu, deflection] : converged_membrane)
        CHECK(converged_deflection(nu).value() == Approx(deflection).margin(0.006));
    CHECK(converged_deflection(0.4).value() < 21.94);
    CHECK_FALSE(converged_deflection(0.2));
}

TEST_CASE("a block whose ends slide does what one deformation gradient says", "[bodies]") {
    for (const Energy energy : {Energy::linear, Energy::stvk, Energy::corotated, Energy::neo_hookean}) {
        StretchedBlock block(energy, rubber.lame(), BlockEnds::sliding, 1.3);
        while (block.running()) block.iterate();
        REQUIRE_FALSE(block.failed());
        CHECK(block.residual() < 1e-6);
        const DeformationPath path(PathKind::uniaxial, Mat<3>::Identity());
        const EnergyDensity<3> density(energy, rubber.lame());
        const Mat<3> F = path.at(density, 1.3).value();
        CHECK(block.width(block.displacement()) == Approx(F(1, 1)).epsilon(1e-7));
        CHECK(block.stress(block.displacement()) == Approx(density.P(F)(0, 0)).epsilon(1e-7));
        if (const auto exact = path.exact_stress(density, 1.3)) CHECK(density.P(F)(0, 0) == Approx(*exact).epsilon(1e-9));
    }
}

TEST_CASE("a grid of a body has the corners of its surface, and a strain its count of operations", "[bodies]") {
    const BodyGrid grid({1, 0.6, 0.4}, {3, 2, 1});
    CHECK(grid.points().cols() == 4 * 3 * 2);
    CHECK(grid.points().rowwise().maxCoeff().isApprox(grid.half()));
    CHECK(grid.faces().size() == 2 * (3 * 2 + 2 * 1 + 3 * 1));
    const OperationCounts counts = count_operations();
    CHECK(counts.cauchy < counts.green);
    CHECK(counts.right_cauchy_green > 0);
}
