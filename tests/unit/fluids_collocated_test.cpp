// Velocity and pressure at the same place: what central differences do not see.
#include "fluids_grids.h"

#include <pliant/fluids/collocated.h>
#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/projection.h>
#include <pliant/math/error.h>
#include <pliant/math/null_dimension.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

template <int Dim>
Lattice<Dim> cells(const Counts<Dim>& count, bool periodic) {
    return StaggeredGrid<Dim>(box<Dim>(count, periodic)).cells();
}

Index staggered_null(const StaggeredGridInfo<2>& info) {
    const StaggeredGrid<2> grid(info);
    const auto op = pressure_operator(grid);
    return null_dimension(grid.cells().size(), [&](const VecX& x, VecX& y) { op->apply(x, y); });
}
Index collocated_null(const Lattice<2>& lattice) {
    const CollocatedProjection<2> projection(lattice, 1);
    return null_dimension(lattice.size(), [&](const VecX& x, VecX& y) { projection.multiply(x, y); });
}

VecX checkerboard(const Lattice<2>& lattice) {
    VecX p(lattice.size());
    for (Index c = 0; c < p.size(); ++c) {
        const Counts<2> at = lattice.coordinates(c);
        p[c] = (at[0] + at[1]) % 2 == 0 ? 1 : -1;
    }
    return p;
}

}  // namespace

TEST_CASE("central differences leave four pressures unseen where the staggered grid leaves one", "[fluids][collocated]") {
    CHECK(staggered_null(box<2>({8, 8}, true)) == 1);
    CHECK(collocated_null(cells<2>({8, 8}, true)) == 4);
    // The count of invisible_pressures() is that of the rank, on all kinds of boxes.
    CHECK(collocated_null(cells<2>({8, 7}, true)) == 2);
    CHECK(collocated_null(cells<2>({7, 5}, true)) == 1);
    CHECK(collocated_null(cells<2>({8, 6}, false)) == 1);
    CHECK(invisible_pressures(cells<2>({8, 8}, true)).size() == 4);
    CHECK(invisible_pressures(cells<2>({8, 7}, true)).size() == 2);
    CHECK(invisible_pressures(cells<2>({8, 6}, false)).size() == 1);
    CHECK(invisible_pressures(cells<3>({4, 4, 6}, true)).size() == 8);
}

TEST_CASE("a checkerboard has no central gradient on a periodic grid, and one at walls alone in a box", "[fluids][collocated]") {
    Points<2> gradient;
    const Lattice<2> torus = cells<2>({8, 6}, true), closed = cells<2>({8, 6}, false);
    central_gradient(torus, 0.5, checkerboard(torus), gradient);
    CHECK(gradient.isZero(0));
    for (const VecX& pattern : invisible_pressures(torus)) {
        central_gradient(torus, 0.5, pattern, gradient);
        CHECK(gradient.isZero(0));
    }
    central_gradient(closed, 0.5, checkerboard(closed), gradient);
    for (Index c = 0; c < closed.size(); ++c) {
        const Counts<2> at = closed.coordinates(c);
        CHECK((std::abs(gradient(0, c)) == 2) == (at[0] == 0 || at[0] == 7));
        CHECK((std::abs(gradient(1, c)) == 2) == (at[1] == 0 || at[1] == 5));
    }
    // The staggered gradient of the same pressure is as large as it can be.
    const StaggeredGrid<2> grid(box<2>({8, 6}, true, 0.5));
    VecX product;
    pressure_operator(grid)->apply(checkerboard(torus), product);
    CHECK(product == 8 * checkerboard(torus));
}

TEST_CASE("the central divergence is minus the transpose of the central gradient", "[fluids][collocated]") {
    for (const bool periodic : {false, true}) {
        for (const Counts<2>& n : {Counts<2>{6, 5}, Counts<2>{1, 4}, Counts<2>{2, 2}}) {
            const Lattice<2> lattice = cells<2>(n, periodic);
            std::srand(3);
            const VecX p = VecX::Random(lattice.size());
            const Points<2> u = Points<2>::Random(2, lattice.size());
            VecX div;
            Points<2> grad;
            central_divergence(lattice, 0.3, u, div);
            central_gradient(lattice, 0.3, p, grad);
            CHECK(std::abs(p.dot(div) + u.cwiseProduct(grad).sum()) < 1e-12);
        }
    }
}

TEST_CASE("central differences are exact to second order", "[fluids][collocated]") {
    const auto error = [](Index n) {
        const Lattice<2> lattice = cells<2>({n, n}, true);
        const Real dx = Real(1) / static_cast<Real>(n);
        VecX p(lattice.size());
        Points<2> u(2, lattice.size()), gradient;
        for (Index c = 0; c < p.size(); ++c) {
            const GridPlace<2> x = lattice.place(lattice.coordinates(c));
            p[c] = std::sin(2 * pi * x[0] * dx) * std::cos(2 * pi * x[1] * dx);
            u.col(c) = Vec<2>(std::sin(2 * pi * x[0] * dx), std::cos(2 * pi * x[1] * dx));
        }
        central_gradient(lattice, dx, p, gradient);
        VecX div;
        central_divergence(lattice, dx, u, div);
        Real worst = 0;
        for (Index c = 0; c < p.size(); ++c) {
            const GridPlace<2> x = lattice.place(lattice.coordinates(c));
            worst =
                std::max(worst, std::abs(gradient(0, c) - 2 * pi * std::cos(2 * pi * x[0] * dx) * std::cos(2 * pi * x[1] * dx)));
            worst = std::max(worst, std::abs(div[c] - 2 * pi * (std::cos(2 * pi * x[0] * dx) - std::sin(2 * pi * x[1] * dx))));
        }
        return worst;
    };
    CHECK_THAT(error(32) / error(64), WithinRel(4.0, 0.02));
}

TEST_CASE("the collocated projection removes what it sees and leaves the checkerboard", "[fluids][collocated]") {
    for (const bool periodic : {false, true}) {
        const Lattice<2> lattice = cells<2>({16, 12}, periodic);
        std::srand(1);
        const Points<2> tentative = Points<2>::Random(2, lattice.size());
        Points<2> u = tentative;
        CollocatedProjection<2> projection(lattice, 1, {1e-11, 500});
        projection.project(u, 0.2);
        VecX div;
        central_divergence(lattice, 1, u, div);
        CHECK(div.cwiseAbs().maxCoeff() <= 1.1e-11 * projection.initial_divergence());
        CHECK(u.norm() <= tentative.norm());
        Points<2> again = u;
        CollocatedProjection<2>(lattice, 1, {1e-11, 500}).project(again, 0.2);
        CHECK((again - u).cwiseAbs().maxCoeff() < 1e-9);
    }
    const Lattice<2> lattice = cells<2>({8, 8}, true);
    Points<2> board(2, 64);
    board.row(0) = checkerboard(lattice).transpose();
    board.row(1) = board.row(0);
    Points<2> u = board;
    CollocatedProjection<2> projection(lattice, 1);
    CHECK(projection.project(u, 1) == 0);
    CHECK(u == board);
    // On the faces of a staggered grid the same velocity is a gradient, and nothing of it is left.
    const StaggeredGrid<2> grid(box<2>({8, 8}, true));
    FaceField<2> faces{{VecX(board.row(0)), VecX(board.row(1))}};
    PressureProjection<2>(grid, {1e-12, 100}).project(faces, 1);
    CHECK(max_speed(faces) < 1e-12);
}

TEST_CASE("the collocated projection can be stopped, resumed and capped", "[fluids][collocated]") {
    const Lattice<2> lattice = cells<2>({12, 12}, true);
    std::srand(2);
    const Points<2> tentative = Points<2>::Random(2, 144);
    CollocatedProjection<2> whole(lattice, 0.1, {1e-9, 500}), resumed(lattice, 0.1, {1e-9, 500});
    whole.begin(tentative, 0.1);
    whole.iterate();
    resumed.pressure() = whole.pressure();
    resumed.residual() = whole.residual();
    resumed.direction() = whole.direction();
    resumed.scalars() = whole.scalars();
    while (!whole.converged()) whole.iterate();
    while (!resumed.converged()) resumed.iterate();
    CHECK(whole.pressure() == resumed.pressure());
    Points<2> u = tentative;
    CollocatedProjection<2> capped(lattice, 0.1, {1e-9, 1});
    CHECK_THROWS_AS(capped.project(u, 0.1), Diverged);
    CHECK_THROWS_AS(CollocatedProjection<2>(lattice, 0.1, {0, 1}), Refused);
}
