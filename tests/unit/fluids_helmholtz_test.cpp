// A velocity as the sum of a gradient, a field without divergence, and a drift.
#include "fluids_grids.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/helmholtz.h>
#include <pliant/fluids/pressure_gradient.h>
#include <pliant/math/error.h>

#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace pliant;
using namespace pliant::test;

namespace {

template <int Dim>
void check_parts(const StaggeredGridInfo<Dim>& info) {
    const StaggeredGrid<Dim> grid(info);
    const FaceField<Dim> u = random_velocity(grid);
    const HelmholtzParts<Dim> parts = helmholtz_parts(grid, u);
    FaceField<Dim> drift = grid.zero_velocity();
    for (int a = 0; a < Dim; ++a) {
        drift[a].setConstant(parts.drift[a]);
        CHECK((parts.gradient[a] + parts.solenoidal[a] + drift[a] - u[a]).cwiseAbs().maxCoeff() < 1e-14);
        if (!grid.periodic(a)) CHECK(parts.drift[a] == 0);
    }
    CHECK(max_divergence(grid, parts.solenoidal) <= 1e-11 * max_divergence(grid, u));

    // Orthogonal, so that the energies add up.
    const Real size = 2 * kinetic_energy(grid, u);
    CHECK(std::abs(inner_product(grid, parts.gradient, parts.solenoidal)) < 1e-11 * size);
    CHECK(std::abs(inner_product(grid, parts.gradient, drift)) < 1e-11 * size);
    CHECK(std::abs(inner_product(grid, parts.solenoidal, drift)) < 1e-11 * size);
    const Real sum = kinetic_energy(grid, parts.gradient) + kinetic_energy(grid, parts.solenoidal) + kinetic_energy(grid, drift);
    CHECK(std::abs(sum - kinetic_energy(grid, u)) < 1e-11 * size);

    // Each part is its own: taken apart again it is found whole.
    const HelmholtzParts<Dim> of_gradient = helmholtz_parts(grid, parts.gradient);
    const HelmholtzParts<Dim> of_rest = helmholtz_parts(grid, parts.solenoidal);
    CHECK(max_speed(of_gradient.solenoidal) < 1e-10);
    CHECK(max_speed(of_rest.gradient) < 1e-10);
    CHECK((of_gradient.potential - parts.potential).cwiseAbs().maxCoeff() < 1e-9);
}

}  // namespace

TEST_CASE("a velocity falls apart into orthogonal parts", "[fluids][helmholtz]") {
    check_parts(box<2>({20, 13}));
    check_parts(box<2>({16, 15}, true, 0.2));
    StaggeredGridInfo<2> channel = box<2>({12, 9});
    channel.periodic[1] = true;
    check_parts(channel);
    check_parts(drawn({"..........", "...####...", "...#..#...", "...####...", ".........."}));
    check_parts(box<3>({6, 5, 4}));
    check_parts(box<3>({4, 5, 6}, true));
}

TEST_CASE("a free surface has no Helmholtz parts", "[fluids][helmholtz]") {
    StaggeredGridInfo<2> info = box<2>({4, 4});
    info.types.assign(16, CellType::fluid);
    info.types[15] = CellType::air;
    const StaggeredGrid<2> grid(info);
    CHECK_THROWS_AS(helmholtz_parts(grid, grid.zero_velocity(), VecX(VecX::Zero(16))), Refused);
}

TEST_CASE("the mean of a periodic flow is its harmonic part", "[fluids][helmholtz]") {
    const StaggeredGrid<2> grid(box<2>({8, 8}, true));
    FaceField<2> u = grid.zero_velocity();
    u[0].setConstant(0.7);
    u[1].setConstant(-0.2);
    const HelmholtzParts<2> parts = helmholtz_parts(grid, u);
    CHECK(std::abs(parts.drift[0] - 0.7) < 1e-15);
    CHECK(std::abs(parts.drift[1] + 0.2) < 1e-15);
    CHECK(max_speed(parts.gradient) == 0);
    CHECK(max_speed(parts.solenoidal) < 1e-15);
}

TEST_CASE("the inner product agrees with the kinetic energy", "[fluids][helmholtz]") {
    const StaggeredGrid<2> grid(drawn({"....", ".##.", "...."}));
    const FaceField<2> u = random_velocity(grid, 1), v = random_velocity(grid, 2);
    FaceField<2> sum = u;
    for (int a = 0; a < 2; ++a) sum[a] += v[a];
    CHECK(std::abs(kinetic_energy(grid, sum) - kinetic_energy(grid, u) - kinetic_energy(grid, v) - inner_product(grid, u, v)) <
          1e-13);
}
