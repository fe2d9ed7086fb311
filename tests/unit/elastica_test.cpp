// The slender cantilever in closed form against the published table, and the manufactured solution against its own equation.
#include <pliant/math/error.h>
#include <pliant/solids/elastica.h>
#include <pliant/solids/manufactured_solution.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <limits>

using namespace pliant;
using Catch::Matchers::WithinAbs;

TEST_CASE("a slender cantilever bends as in the table of Bisshopp and Drucker", "[elastica]") {
    struct Row {
        Real a, deflection, reach, angle;
    };
    for (const auto& [a, deflection, reach, angle] :
         {Row{0.25, 0.0827459, 0.9958822, 0.1242924}, Row{1, 0.3017208, 0.9435668, 0.4613519},
          Row{2, 0.4934575, 0.8393583, 0.7817498}, Row{5, 0.7137915, 0.6123716, 1.2153681},
          Row{10, 0.8106090, 0.4450044, 1.4302855}}) {
        const Elastica found = elastica(a);
        CHECK_THAT(found.deflection, WithinAbs(deflection, 1e-7));
        CHECK_THAT(found.reach, WithinAbs(reach, 1e-7));
        CHECK_THAT(found.angle, WithinAbs(angle, 1e-7));
    }
    CHECK(elastica(0).deflection == 0);
    // Small loads: a third of the load number.
    CHECK_THAT(elastica(1e-4).deflection / 1e-4, WithinAbs(1.0 / 3, 1e-6));
    for (const Real bad : {-1.0, 101.0, std::numeric_limits<Real>::quiet_NaN()}) CHECK_THROWS_AS(elastica(bad), Refused);
}

TEST_CASE("the force of the manufactured solution is what its stress leaves", "[elastica]") {
    const Real lambda = 2, mu = 3, h = 1e-5;
    const auto stress = [=](const Vec<2>& X) {
        const Mat<2> H = manufactured::gradient(X), strain = (H + H.transpose()) / 2;
        return Mat<2>(lambda * strain.trace() * Mat<2>::Identity() + 2 * mu * strain);
    };
    for (const Vec<2>& X : {Vec<2>(0.3, 0.6), Vec<2>(0.81, 0.17)}) {
        Vec<2> divergence = Vec<2>::Zero();
        Mat<2> slope;
        for (int j = 0; j < 2; ++j) {
            Vec<2> step = Vec<2>::Zero();
            step[j] = h;
            divergence += (stress(X + step) - stress(X - step)).col(j) / (2 * h);
            slope.col(j) = (manufactured::displacement(X + step) - manufactured::displacement(X - step)) / (2 * h);
        }
        CHECK_THAT((slope - manufactured::gradient(X)).norm(), WithinAbs(0, 1e-8));
        const Vec<2> force = lambda * manufactured::force_of_lambda(X) + mu * manufactured::force_of_mu(X);
        CHECK_THAT((force + divergence).norm(), WithinAbs(0, 1e-6));
    }
    CHECK(manufactured::displacement({1, 0.4}).norm() < 1e-15);
}
