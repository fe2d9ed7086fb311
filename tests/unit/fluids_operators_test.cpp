// The operators that the solvers of the grid fluids are made of: Laplacians, transfers between grids, and Newton's direction.
#include "fluids_grids.h"

#include <pliant/fluids/box_laplacian.h>
#include <pliant/fluids/grid_transfer.h>
#include <pliant/fluids/poisson_operator.h>
#include <pliant/time/lu_direction.h>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Approx;

namespace {

template <int Dim>
Lattice<Dim> cells_of(const Counts<Dim>& count, Beyond beyond, Real value = 0) {
    Lattice<Dim> lattice{.count = count};
    lattice.offset.fill(0.5);
    for (auto& axis : lattice.sides) axis.fill({beyond, value});
    return lattice;
}

template <class Operator>
VecX product(const Operator& A, const VecX& x) {
    VecX y(x.size());
    const Real energy = A.apply(x, y);
    CHECK(energy == Approx(x.dot(y)).margin(1e-13));
    return y;
}

}  // namespace

TEST_CASE("box Laplacians: waves that fit into the box are their eigenvectors", "[operators]") {
    using std::numbers::pi;
    const Index n = 12, m = 7;
    for (const Beyond beyond : {Beyond::zero_gradient, Beyond::wall_value, Beyond::periodic}) {
        const Lattice<2> lattice = cells_of<2>({n, m}, beyond);
        const BoxLaplacian<2> A(lattice);
        const Real periods = beyond == Beyond::periodic ? 2 : 1;
        const Real kx = periods * pi * 2 / Real(n), ky = periods * pi * 3 / Real(m);
        const auto wave = [&](Real phase) { return beyond == Beyond::wall_value ? std::sin(phase) : std::cos(phase); };
        VecX x(lattice.size()), y(lattice.size());
        for (Index i = 0; i < x.size(); ++i) {
            const auto at = lattice.coordinates(i);
            x[i] = wave(kx * (Real(at[0]) + 0.5)) * wave(ky * (Real(at[1]) + 0.5));
        }
        const Real eigenvalue = 4 * std::pow(std::sin(kx / 2), 2) + 4 * std::pow(std::sin(ky / 2), 2);
        A.apply(x, 0, 1, y);
        CHECK((y - eigenvalue * x).norm() < 1e-12 * x.norm());
        A.apply(x, 0.3, 2, y);
        CHECK((y - (0.3 + 2 * eigenvalue) * x).norm() < 1e-12 * x.norm());
    }
}

TEST_CASE("box Laplacians: symmetric, and the values of walls belong to the right side", "[operators]") {
    std::srand(3);
    const BoxLaplacian<3> A(cells_of<3>({5, 4, 3}, Beyond::wall_value, 2.5));
    const VecX x = VecX::Random(60), y = VecX::Random(60);
    VecX Ax(60), Ay(60), r(60), walls = VecX::Zero(60);
    A.apply(x, 0.1, 1.5, Ax), A.apply(y, 0.1, 1.5, Ay);
    CHECK(x.dot(Ay) == Approx(y.dot(Ax)));
    A.residual(y, x, 0.1, 1.5, r);
    CHECK((r - (y - Ax)).norm() < 1e-13);
    // A quantity that is everywhere what the walls hold has no Laplacian.
    const VecX level = VecX::Constant(60, 2.5);
    A.apply(level, 0, 1, Ax), A.add_wall_terms(1, walls);
    CHECK((Ax - walls).norm() < 1e-13);
}

TEST_CASE("box Laplacians: sweeps forward and backward come to the solution", "[operators]") {
    std::srand(4);
    const BoxLaplacian<2> A(cells_of<2>({8, 6}, Beyond::wall_value));
    const VecX solution = VecX::Random(48);
    VecX b(48), x = VecX::Zero(48), r(48);
    A.apply(solution, 0, 1, b);
    Real energy = (x - solution).dot(b);
    for (int k = 0; k < 200; ++k) {
        A.relax(b, 1, x, k % 2 ? SweepOrder::backward : SweepOrder::forward);
        // Gauss–Seidel lowers the energy of the error in every sweep.
        VecX e = x - solution, Ae(48);
        A.apply(e, 0, 1, Ae);
        if (k > 0 && energy > 1e-20) CHECK(e.dot(Ae) < energy);
        energy = e.dot(Ae);
    }
    CHECK((x - solution).norm() < 1e-9);
}

TEST_CASE("pressure operators: with weights of 1 the same as the uniform one, with solids symmetric", "[operators]") {
    std::srand(5);
    const Lattice<2> cells = cells_of<2>({6, 5}, Beyond::zero_gradient);
    LowFaceWeights<2> weights;
    for (int axis = 0; axis < 2; ++axis) {
        weights[axis] = VecX::Ones(30);
        for (Index c = 0; c < 30; ++c)
            if (cells.coordinates(c)[static_cast<std::size_t>(axis)] == 0) weights[axis][c] = 0;
    }
    const UniformPoisson<2> uniform(cells, 1);
    const WeightedPoisson<2> weighted(cells, weights);
    const VecX x = VecX::Random(30);
    CHECK((product(uniform, x) - product(weighted, x)).norm() < 1e-13);
    CHECK(product(weighted, VecX::Ones(30)).norm() < 1e-13);

    const StaggeredGrid<2> grid(drawn({"......", ".##...", ".##...", "......"}));
    const auto A = pressure_operator<2>(grid);
    const VecX a = VecX::Random(24), b = VecX::Random(24);
    CHECK(a.dot(product(*A, b)) == Approx(b.dot(product(*A, a))));
    CHECK(a.dot(product(*A, a)) >= 0);
    CHECK(product(*A, VecX::Ones(24)).norm() < 1e-13);
    const VecX diagonal = pressure_diagonal<2>(grid);
    for (Index c = 0; c < 24; ++c) CHECK(product(*A, VecX::Unit(24, c))[c] == Approx(diagonal[c]).margin(1e-15));
}

TEST_CASE("transfers between grids: interpolation keeps constants, its transpose keeps sums", "[operators]") {
    std::srand(6);
    const auto check = [](const auto& fine, Index coarse_size) {
        GridTransfer transfer(fine);
        CHECK(coarsened(fine).size() == coarse_size);
        VecX level = VecX::Zero(fine.size());
        transfer.add_interpolated(VecX::Ones(coarse_size), level);
        CHECK((level - VecX::Ones(fine.size())).norm() < 1e-13);
        const VecX f = VecX::Random(fine.size()), c = VecX::Random(coarse_size);
        VecX up = VecX::Zero(fine.size()), down(coarse_size);
        transfer.add_interpolated(c, up);
        transfer.restrict_to(f, down);
        CHECK(f.dot(up) == Approx(c.dot(down)));
        CHECK(down.sum() == Approx(f.sum()));
    };
    check(cells_of<2>({8, 6}, Beyond::zero_gradient), 12);
    check(cells_of<2>({7, 5}, Beyond::zero_gradient), 12);
    check(cells_of<2>({8, 4}, Beyond::periodic), 8);
    check(cells_of<3>({4, 6, 5}, Beyond::zero_gradient), 18);
}

TEST_CASE("transfers between grids: slopes are kept away from the walls", "[operators]") {
    const Lattice<2> fine = cells_of<2>({12, 8}, Beyond::zero_gradient), coarse = coarsened(fine);
    VecX from(coarse.size()), to = VecX::Zero(fine.size());
    for (Index i = 0; i < from.size(); ++i) {
        const auto at = coarse.coordinates(i);
        from[i] = 2 * (2 * Real(at[0]) + 1) - 3 * (2 * Real(at[1]) + 1);
    }
    GridTransfer(fine).add_interpolated(from, to);
    for (Index i = 0; i < to.size(); ++i) {
        const auto at = fine.coordinates(i);
        if (at[0] < 1 || at[0] > 10 || at[1] < 1 || at[1] > 6) continue;
        CHECK(to[i] == Approx(2 * (Real(at[0]) + 0.5) - 3 * (Real(at[1]) + 0.5)).margin(1e-12));
    }
}

TEST_CASE("Newton's direction by LU: it solves what is not symmetric, leaves what is fixed, and tells what is singular",
          "[operators]") {
    MatX K(4, 4);
    K << 5, 1, 0, -2, 3, 6, 1, 0, 0, -1, 4, 2, 1, 0, 3, 7;
    const SparseMatrix stiffness = K.sparseView();
    const DiagonalMass mass(VecX::LinSpaced(2, 1, 2), 2), held(VecX::LinSpaced(2, 1, 2), 2, {1});
    const VecX r = VecX::LinSpaced(4, -1, 2);
    VecX d;
    LuDirection direction;
    REQUIRE(direction.solve(stiffness, 3, mass, r, d));
    const MatX J = K + 3 * MatX(mass.mass().asDiagonal());
    CHECK((J * d + r).norm() < 1e-13);
    REQUIRE(direction.solve(stiffness, 3, held, r, d));
    CHECK(d.tail(2).norm() == 0);
    CHECK((J.topLeftCorner(2, 2) * d.head(2) + r.head(2)).norm() < 1e-13);
    const SparseMatrix nothing = MatX::Ones(4, 4).sparseView();
    CHECK_FALSE(LuDirection().solve(nothing, 0, mass, r, d));
}
