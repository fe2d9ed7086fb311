// The preconditioners of the pressure equation: one solution, different numbers of iterations.
#include "fluids_grids.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/incomplete_cholesky.h>
#include <pliant/fluids/jacobi.h>
#include <pliant/fluids/projection.h>
#include <pliant/math/dense_matrix.h>
#include <pliant/math/error.h>

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;

namespace {

using P = PressurePreconditioner;
constexpr std::array<P, 4> all{P::none, P::jacobi, P::incomplete_cholesky, P::multigrid};

// A corridor around two rooms that nothing joins, one of them with a pillar, and a cell that stands alone.
StaggeredGridInfo<2> pockets() {
    return drawn({"................",  //
                  ".##############.",  //
                  ".#.....##.....#.",  //
                  ".#..#..##.....#.",  //
                  ".#.....##.....#.",  //
                  ".####.#########.",  //
                  ".###############",  //
                  "................"});
}

template <int Dim>
void check_same_solution(const StaggeredGridInfo<Dim>& info) {
    const StaggeredGrid<Dim> grid(info);
    const FaceField<Dim> tentative = random_velocity(grid);
    PressureProjection<Dim> reference(grid, {1e-13, 5000});
    FaceField<Dim> u = tentative;
    reference.project(u, 0.1);
    for (const P kind : all) {
        PressureProjection<Dim> projection(grid, {1e-12, 5000, kind});
        FaceField<Dim> v = tentative;
        projection.project(v, 0.1);
        CHECK((projection.pressure() - reference.pressure()).cwiseAbs().maxCoeff() <=
              1e-9 * (reference.pressure().cwiseAbs().maxCoeff() + 1e-300));
        CHECK(max_divergence(grid, v) <= 1e-11 * max_divergence(grid, tentative) + 1e-14 * max_speed(tentative) / info.dx);
        for (int a = 0; a < Dim; ++a) CHECK((u[a] - v[a]).cwiseAbs().sum() <= 1e-9 * (tentative[a].cwiseAbs().sum() + 1e-300));
    }
}

template <int Dim>
Index passes(const StaggeredGrid<Dim>& grid, P kind, Real tolerance = 1e-6) {
    PressureProjection<Dim> projection(grid, {tolerance, 20000, kind});
    FaceField<Dim> u = random_velocity(grid);
    return projection.project(u, 1);
}

template <int Dim>
MatX dense(Preconditioner<Dim>& preconditioner, Index n) {
    MatX M(n, n);
    VecX column;
    for (Index c = 0; c < n; ++c) {
        preconditioner.precondition(VecX::Unit(n, c), column);
        M.col(c) = column;
    }
    return M;
}

}  // namespace

TEST_CASE("all preconditioners lead to the same pressure", "[fluids][pressure_solvers]") {
    check_same_solution(box<2>({24, 24}));
    check_same_solution(box<2>({17, 9}, false, 0.1));
    check_same_solution(box<2>({16, 11}, true));
    check_same_solution(box<2>({3, 2}, true));
    check_same_solution(box<2>({1, 7}));
    check_same_solution(pockets());
    check_same_solution(box<3>({7, 8, 6}));
    check_same_solution(box<3>({3, 2, 5}, true));
    StaggeredGridInfo<2> channel = box<2>({14, 9});
    channel.periodic[0] = true;
    channel.types.assign(14 * 9, CellType::fluid);
    for (const std::size_t c : {45, 46, 59, 60, 61}) channel.types[c] = CellType::solid;
    check_same_solution(channel);
}

TEST_CASE("better preconditioners need fewer iterations", "[fluids][pressure_solvers]") {
    StaggeredGridInfo<2> info = box<2>({96, 96});
    info.types.assign(96 * 96, CellType::fluid);
    for (Index j = 30; j < 50; ++j)
        for (Index i = 40; i < 60; ++i) info.types[static_cast<std::size_t>(96 * j + i)] = CellType::solid;
    const StaggeredGrid<2> grid(info);
    std::array<Index, 4> n{};
    for (std::size_t k = 0; k < 4; ++k) n[k] = passes(grid, all[k]);
    CAPTURE(n[0], n[1], n[2], n[3]);
    // The diagonal is 4 almost everywhere: dividing by it gains nothing.
    CHECK(std::abs(n[0] - n[1]) <= n[0] / 20);
    CHECK(n[0] >= 3 * n[2]);
    CHECK(n[1] >= 3 * n[2]);
    CHECK(n[2] >= 3 * n[3]);
}

TEST_CASE("iterations grow with the resolution, apart from multigrid", "[fluids][pressure_solvers]") {
    const StaggeredGrid<2> coarse(box<2>({32, 32})), fine(box<2>({128, 128}));
    CHECK(passes(fine, P::none) > 3 * passes(coarse, P::none));
    CHECK(passes(fine, P::incomplete_cholesky) > 3 * passes(coarse, P::incomplete_cholesky) / 2);
    for (const Index n : {64, 128, 256, 512}) CHECK(passes(StaggeredGrid<2>(box<2>({n, n})), P::multigrid) <= 8);
    for (const Index n : {16, 32}) CHECK(passes(StaggeredGrid<3>(box<3>({n, n, n})), P::multigrid) <= 9);
}

TEST_CASE("multigrid needs no more iterations on 64 x 64 x 64", "[fluids][pressure_solvers][slow]") {
    CHECK(passes(StaggeredGrid<3>(box<3>({64, 64, 64})), P::multigrid) <= 9);
}

TEST_CASE("the incomplete factorization is symmetric, positive, and exact along a line", "[fluids][pressure_solvers]") {
    StaggeredGridInfo<2> channel = box<2>({5, 4});
    channel.periodic[0] = true;
    for (const auto& info : {box<2>({6, 5}), box<2>({3, 4}, true), box<2>({2, 2}, true), channel, pockets()}) {
        const StaggeredGrid<2> grid(info);
        const Index n = grid.cells().size();
        IncompleteCholesky<2> factor(grid);
        const MatX M = dense(factor, n);
        CHECK((M - M.transpose()).cwiseAbs().maxCoeff() <= 1e-13 * M.cwiseAbs().maxCoeff());
        const VecX d = pressure_diagonal(grid);
        const VecX values = dense_eigen(M).values;
        CHECK((values.array() > 1e-6).count() == (d.array() > 0).count());
        CHECK(values.minCoeff() > -1e-12);
    }
    // Without fill-in to leave out the factorization is exact: one pass solves.
    const StaggeredGrid<2> line(box<2>({12, 1}));
    CHECK(passes(line, P::incomplete_cholesky) <= 2);
    CHECK_THROWS_AS(IncompleteCholesky<2>(line, {}, 1.5), Refused);
}

TEST_CASE("the diagonal counts the open faces", "[fluids][pressure_solvers]") {
    const StaggeredGrid<2> grid(drawn({"#..", "...", ".#."}));
    const VecX expected{{1, 0, 1, 2, 3, 3, 0, 2, 2}};
    CHECK(pressure_diagonal(grid) == expected);
    Jacobi<2> jacobi(grid);
    VecX z;
    jacobi.precondition(VecX::Ones(9), z);
    CHECK(z[0] == 1);
    CHECK(z[1] == 0);
    CHECK(z[3] == 0.5);
    CHECK(pressure_diagonal(StaggeredGrid<2>(box<2>({1, 2}, true))) == VecX{{2, 2}});
}

TEST_CASE("a lone cell and a solid box leave nothing to solve with any preconditioner", "[fluids][pressure_solvers]") {
    const StaggeredGrid<2> lone(drawn({"###", "#.#", "###"})), none(drawn({"##", "##"})), two(drawn({".#.", ".#."}));
    for (const P kind : all) {
        for (const StaggeredGrid<2>* grid : {&lone, &none}) {
            PressureProjection<2> projection(*grid, {1e-6, 10, kind});
            FaceField<2> u = random_velocity(*grid);
            CHECK(projection.project(u, 1) == 0);
            CHECK(max_speed(u) == 0);
            CHECK(projection.pressure().isZero(0));
        }
        // Two regions: each has its own constant, and mean 0.
        PressureProjection<2> projection(two, {1e-12, 100, kind});
        FaceField<2> u = random_velocity(two);
        projection.project(u, 1);
        CHECK(projection.regions().count() == 2);
        CHECK(max_divergence(two, u) < 1e-12);
        const VecX& p = projection.pressure();
        CHECK(std::abs(p[0] + p[3]) < 1e-14);
        CHECK(std::abs(p[2] + p[5]) < 1e-14);
        CHECK(std::abs(p[0]) > 1e-3);
    }
}

TEST_CASE("every preconditioner stops at its cap with the residual, and can be stopped and resumed",
          "[fluids][pressure_solvers]") {
    const StaggeredGrid<2> grid(box<2>({32, 30}));
    const FaceField<2> tentative = random_velocity(grid);
    for (const P kind : all) {
        PressureProjection<2> capped(grid, {1e-10, 1, kind});
        FaceField<2> u = tentative;
        CHECK_THROWS_WITH(capped.project(u, 0.1),
                          ContainsSubstring("after 1 iterations the residual is") && ContainsSubstring("divergence left"));
        CHECK(capped.iterations() == 1);
        CHECK(capped.remaining_divergence() > 0);

        PressureProjection<2> whole(grid, {1e-8, 2000, kind}), resumed(grid, {1e-8, 2000, kind});
        whole.begin(tentative, 0.1);
        whole.iterate();
        whole.iterate();
        resumed.pressure() = whole.pressure();
        resumed.residual() = whole.residual();
        resumed.direction() = whole.direction();
        resumed.scalars() = whole.scalars();
        while (!whole.converged()) whole.iterate();
        while (!resumed.converged()) resumed.iterate();
        CHECK(whole.pressure() == resumed.pressure());
        CHECK(whole.iterations() == resumed.iterations());
    }
}

TEST_CASE("the preconditioner can be changed between two passes", "[fluids][pressure_solvers]") {
    const StaggeredGrid<2> grid(box<2>({40, 40}));
    FaceField<2> u = random_velocity(grid);
    const Real before = max_divergence(grid, u);
    PressureProjection<2> projection(grid, {1e-8, 500, P::none});
    projection.begin(u, 0.1);
    for (int k = 0; k < 10; ++k) projection.iterate();
    projection.set({1e-8, 500, P::multigrid});
    while (!projection.converged()) projection.iterate();
    CHECK(projection.iterations() < 30);
    projection.apply(u);
    CHECK(max_divergence(grid, u) <= 1.01e-8 * before);
}
