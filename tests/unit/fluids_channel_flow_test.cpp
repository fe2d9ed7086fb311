// Closed forms of the flow between two plates, and the solver against them.
#include "channel_grid.h"

#include <pliant/fluids/channel_flow.h>
#include <pliant/fluids/diffusion.h>
#include <pliant/fluids/forces.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("channel flow: the start of Couette's flow has the tabulated values", "[fluids]") {
    CHECK_THAT(couette_start_up(0.5, 1, 1, 0.1 * 0.2), WithinAbs(0.01241933, 5e-9));
    CHECK_THAT(couette_start_up(0.5, 1, 1, 0.1 * 0.5), WithinAbs(0.11384420, 5e-9));
    CHECK_THAT(couette_start_up(0.5, 1, 1, 0.1 * 1), WithinAbs(0.26275627, 5e-9));
    CHECK_THAT(couette_start_up(0.75, 1, 2, 1e3), WithinRel(1.5, 1e-12));
    CHECK(couette_start_up(0.9, 1, 2, 0) == 0);
    CHECK(couette_start_up(1, 1, 2, 0) == 2);
}

TEST_CASE("channel flow: the series for early and for late times meet", "[fluids]") {
    for (const Real y : {0.0, 0.1, 0.5, 0.8, 1.0}) {
        const Real before = 0.05 * (1 - 1e-13), after = 0.05 * (1 + 1e-13);
        CHECK_THAT(couette_start_up(y, 1, 1, before), WithinAbs(couette_start_up(y, 1, 1, after), 1e-11));
        CHECK_THAT(poiseuille_start_up(y, 1, 1, 1, before), WithinAbs(poiseuille_start_up(y, 1, 1, 1, after), 1e-11));
    }
    CHECK_THAT(poiseuille_start_up(0.5, 1, 3, 1e-9, 2), WithinRel(6.0, 1e-12));  // no plate is felt yet
    CHECK(poiseuille_start_up(0.5, 1, 3, 0, 2) == 6);
    CHECK_THAT(poiseuille_start_up(0.3, 2, 3, 0.5, 1e3), WithinRel(poiseuille_speed(0.3, 2, 3, 0.5), 1e-12));
}

TEST_CASE("channel flow: viscosity between plates tends to both closed forms, at second order in the cells", "[fluids]") {
    const auto error_of_poiseuille = [](Index n) {
        const auto grid = channel(n, 0);
        FaceField<2> u = grid.zero_velocity();
        Viscosity<2> viscosity(grid);
        for (int k = 0; k < 40; ++k) {
            add_uniform_force<2>(grid, u, 10, {1, 0});
            viscosity.diffuse_implicitly(u, 0.1, 10, {.tolerance = 1e-13});
        }
        const Index middle = n / 2;
        return std::abs(u[0][4 * middle] - poiseuille_speed((static_cast<Real>(middle) + 0.5) / static_cast<Real>(n), 1, 1, 0.1));
    };
    const Real coarse = error_of_poiseuille(8), fine = error_of_poiseuille(16);
    CHECK(fine < 0.01);
    CHECK_THAT(std::log2(coarse / fine), WithinAbs(2, 0.05));

    // Δt falls as Δx², so that the first order in time shows as the second in space.
    const auto error_of_couette = [](Index n) {
        const auto grid = channel(n, 1);
        FaceField<2> u = grid.zero_velocity();
        Viscosity<2> viscosity(grid);
        const Index steps = n * n / 8;
        for (Index k = 0; k < steps; ++k)
            viscosity.diffuse_implicitly(u, 0.1, 0.5 / static_cast<Real>(steps), {.tolerance = 1e-12});
        Real largest = 0;
        for (Index j = 0; j < n; ++j) {
            const Real y = (static_cast<Real>(j) + 0.5) / static_cast<Real>(n);
            largest = std::max(largest, std::abs(u[0][4 * j] - couette_start_up(y, 1, 1, 0.05)));
        }
        return largest;
    };
    CHECK_THAT(std::log2(error_of_couette(16) / error_of_couette(32)), WithinAbs(2, 0.2));
}
