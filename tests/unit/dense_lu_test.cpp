// Dense systems by LU in blocks, against a product that is known.
#include <pliant/math/dense_lu.h>
#include <pliant/math/error.h>
#include <pliant/math/watch.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>

#include <cmath>

using namespace pliant;

namespace {

MatX full_matrix(Index n) {
    MatX A(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            A(i, j) = std::sin(static_cast<Real>(1 + 7 * i + 13 * j + i * j)) + (i == n - 1 - j ? 4 : 0);
    return A;
}

}  // namespace

TEST_CASE("LU in blocks solves, whatever the size beside the blocks", "[dense_lu]") {
    const Index n = GENERATE(1, 2, 47, 48, 49, 130);
    const MatX A = full_matrix(n);
    const VecX x = VecX::LinSpaced(n, -1, 2);
    CHECK((DenseLu(A).solve(A * x) - x).norm() < 1e-10 * x.norm());
}

TEST_CASE("LU exchanges rows where the diagonal is 0", "[dense_lu]") {
    const MatX A = (MatX(3, 3) << 0, 2, 1, 1, 0, 0, 0, 0, 3).finished();
    CHECK((DenseLu(A).solve(Vec<3>(7, 1, 9)) - Vec<3>(1, 2, 3)).norm() < 1e-14);
}

TEST_CASE("LU names a matrix that is singular or not finite", "[dense_lu]") {
    MatX A = full_matrix(60);
    A.col(50).setZero();
    CHECK_THROWS_AS(DenseLu(A), Diverged);
    A = full_matrix(60);
    A(5, 3) = NAN;
    CHECK_THROWS_AS(DenseLu(A), Diverged);
    CHECK_THROWS_AS(DenseLu(MatX::Zero(2, 2)), Diverged);
}

TEST_CASE("LU is called off between two blocks", "[dense_lu]") {
    Watch watch;
    const Watched watched(watch);
    watch.begin();
    watch.cancel();
    CHECK_THROWS_AS(DenseLu(full_matrix(60)), Cancelled);
}
