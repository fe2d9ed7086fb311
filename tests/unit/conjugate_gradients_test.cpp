// Conjugate gradients: finite termination, convergence bounds, breakdown, and saving in mid-course. Sparse Cholesky beside them.
#include <pliant/math/conjugate_gradients.h>
#include <pliant/math/error.h>
#include <pliant/math/sparse_cholesky.h>

#include <Eigen/Dense>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Status = ConjugateGradients::Status;

namespace {

// Numbers in (-1, 1) that are the same on every machine.
class Numbers {
public:
    Real next() {
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        return static_cast<Real>(state_ >> 11) / 9007199254740992.0 * 2 - 1;
    }
    VecX vector(Index n) {
        VecX v(n);
        for (Index i = 0; i < n; ++i) v[i] = next();
        return v;
    }

private:
    std::uint64_t state_ = 12345;
};

SparseMatrix random_spd(Index n, Numbers& numbers) {
    MatX m(n, n);
    for (Index i = 0; i < m.size(); ++i) m.data()[i] = numbers.next();
    const MatX spd = m * m.transpose() + static_cast<Real>(n) * MatX::Identity(n, n);
    return spd.sparseView();
}

// Second differences on a chain of n unknowns, both ends held (definite) or free (constants in the null space).
SparseMatrix chain(Index n, bool held) {
    SparseMatrix A(n, n);
    for (Index i = 0; i < n; ++i) {
        A.coeffRef(i, i) = 2;
        if (i > 0) A.coeffRef(i, i - 1) = -1;
        if (i + 1 < n) A.coeffRef(i, i + 1) = -1;
    }
    if (!held) A.coeffRef(0, 0) = A.coeffRef(n - 1, n - 1) = 1;
    A.makeCompressed();
    return A;
}

}  // namespace

TEST_CASE("A system of n unknowns is solved in at most n iterations", "[solvers]") {
    Numbers numbers;
    for (Index n = 1; n <= 14; ++n) {
        const SparseMatrix A = random_spd(n, numbers);
        const VecX x = numbers.vector(n);
        for (const auto& preconditioner :
             {no_preconditioner(), jacobi_preconditioner(A), incomplete_cholesky_preconditioner(A)}) {
            ConjugateGradients cg(n, product_with(A), preconditioner, {1e-12, n});
            cg.begin(A * x, VecX::Zero(n));
            cg.solve();
            CHECK(cg.converged());
            CHECK((cg.x() - x).norm() < 1e-11 * x.norm());
        }
    }
}

TEST_CASE("The error falls at least as fast as the Chebyshev bound", "[solvers]") {
    const Index n = 40;
    const SparseMatrix A = chain(n, true);
    Numbers numbers;
    const VecX x = numbers.vector(n);
    // Eigenvalues 2 - 2 cos(k pi / (n + 1)); |e_k| <= 2 ((sqrt(c) - 1) / (sqrt(c) + 1))^k |e_0| in the norm of A.
    const Real smallest = 2 - 2 * std::cos(std::numbers::pi / (n + 1)), largest = 2 + 2 * std::cos(std::numbers::pi / (n + 1));
    const Real root = std::sqrt(largest / smallest), rate = (root - 1) / (root + 1);
    const auto energy_norm = [&A](const VecX& e) { return std::sqrt(e.dot(A * e)); };

    ConjugateGradients cg(n, product_with(A), no_preconditioner(), {1e-14, n});
    cg.begin(A * x, VecX::Zero(n));
    Real before = energy_norm(x);
    const Real first = before;
    while (cg.running() && cg.iterations() < n - 1) {
        cg.iterate();
        const Real error = energy_norm(cg.x() - x);
        CHECK(error <= before * (1 + 1e-12));
        CHECK(error <= 2 * std::pow(rate, cg.iterations()) * first * (1 + 1e-12));
        before = error;
    }
    // The quotients met lie between the extreme eigenvalues.
    CHECK(cg.condition_seen() > 1);
    CHECK(cg.condition_seen() <= largest / smallest * (1 + 1e-12));
}

TEST_CASE("The unit of the unknowns and of the right side changes nothing", "[solvers]") {
    const Real unit = GENERATE(1e-6, 1.0, 1e6);
    const Real load = GENERATE(1e-200, 1e-6, 1e6, 1e200);
    const SparseMatrix A = unit * chain(30, true);
    Numbers numbers;
    const VecX b = load * numbers.vector(30);
    ConjugateGradients cg(A, {1e-12});
    cg.begin(b, VecX::Zero(30));
    cg.solve();
    CHECK(cg.converged());
    CHECK((b - A * cg.x()).stableNorm() <= 1e-12 * b.stableNorm());
    CHECK(cg.iterations() <= 31);
}

TEST_CASE("Diagonal preconditioning undoes units that differ from unknown to unknown", "[solvers]") {
    Numbers numbers;
    const SparseMatrix A = random_spd(20, numbers);
    VecX units(20);
    for (Index i = 0; i < 20; ++i) units[i] = std::pow(10.0, 6 * numbers.next());
    const SparseMatrix scaled = units.asDiagonal() * A * units.asDiagonal();
    const VecX y = numbers.vector(20), b = units.cwiseProduct(A * y);  // solution: y in the same units
    ConjugateGradients cg(scaled, {1e-12, 40}), plain(20, product_with(scaled), no_preconditioner(), {1e-12, 40});
    for (auto* solver : {&cg, &plain}) {
        solver->begin(b, VecX::Zero(20));
        solver->solve();
    }
    CHECK(cg.converged());
    CHECK(!plain.converged());
    CHECK((units.cwiseProduct(cg.x()) - y).norm() < 1e-6 * y.norm());
}

TEST_CASE("A singular system is reported, unless the right side has a solution", "[solvers]") {
    MatX pair(2, 2);
    pair << 1, -1, -1, 1;
    const SparseMatrix two = pair.sparseView();
    ConjugateGradients cg(two, {});
    cg.begin(VecX::Unit(2, 0), VecX::Zero(2));
    CHECK_THROWS_WITH(cg.solve(), ContainsSubstring("singular"));

    const SparseMatrix A = chain(25, false);
    Numbers numbers;
    VecX b = numbers.vector(25);
    for (const bool factor : {false, true}) {
        ConjugateGradients unbalanced(25, product_with(A),
                                      factor ? incomplete_cholesky_preconditioner(A) : jacobi_preconditioner(A), {});
        unbalanced.begin(b, VecX::Zero(25));
        CHECK_THROWS_AS(unbalanced.solve(), Diverged);
        CHECK(unbalanced.x().allFinite());
    }
    b.array() -= b.mean();
    ConjugateGradients balanced(A, {1e-10});
    balanced.begin(b, VecX::Zero(25));
    balanced.solve();
    CHECK(balanced.converged());
}

TEST_CASE("An indefinite matrix is reported", "[solvers]") {
    MatX saddle(2, 2);
    saddle << 1, 2, 2, 1;
    const SparseMatrix A = saddle.sparseView();
    ConjugateGradients cg(A, {});
    cg.begin(Vec<2>(1, -1), VecX::Zero(2));
    CHECK_THROWS_WITH(cg.solve(), ContainsSubstring("not positive definite"));

    saddle << -1, 0, 0, 1;
    const SparseMatrix negative = saddle.sparseView();
    CHECK_THROWS_WITH(jacobi_preconditioner(negative), ContainsSubstring("diagonal entry 0"));
    CHECK_THROWS_WITH(incomplete_cholesky_preconditioner(negative), ContainsSubstring("diagonal entry 0"));
}

TEST_CASE("Reaching the cap or the limit of rounding is not convergence", "[solvers]") {
    const SparseMatrix A = chain(30, true);
    Numbers numbers;
    const VecX b = numbers.vector(30);
    ConjugateGradients capped(A, {1e-10, 1});
    capped.begin(b, VecX::Zero(30));
    capped.solve();
    CHECK(capped.status() == Status::capped);
    CHECK(capped.iterations() == 1);
    CHECK(capped.residual() > 1e-3);
    CHECK_THROWS_WITH(capped.require_convergence(), ContainsSubstring("cap 1 iterations") && ContainsSubstring("residual"));

    ConjugateGradients none(A, {1e-10, 0});
    none.begin(b, VecX::Zero(30));
    CHECK(none.status() == Status::capped);

    ConjugateGradients greedy(A, {1e-30, 100000});
    greedy.begin(b, VecX::Zero(30));
    greedy.solve();
    CHECK(greedy.status() == Status::stagnated);
    CHECK((b - A * greedy.x()).norm() < 1e-13 * b.norm());
    VecX left;
    greedy.residual_vector(left);
    CHECK((left - (b - A * greedy.x())).norm() < 1e-15 * b.norm());
    CHECK_THROWS_WITH(greedy.require_convergence(), ContainsSubstring("Rounding"));
}

TEST_CASE("A residual that rounding hides is noticed on the way, not when the updated one has converged", "[solvers]") {
    // A product with the digits of single precision: the true residual cannot fall below about 1e-7 of the right side.
    const Index n = 400;
    VecX units(n);
    for (Index i = 0; i < n; ++i) units[i] = std::pow(10.0, static_cast<Real>(i) / n);
    const SparseMatrix A = units.asDiagonal() * chain(n, true) * units.asDiagonal();
    const LinearMap rough = [&A](const VecX& x, VecX& y) {
        y.noalias() = A * x;
        y = y.cast<float>().cast<Real>();
    };
    Numbers numbers;
    ConjugateGradients cg(n, rough, jacobi_preconditioner(A), {1e-15, 1000000});
    cg.begin(numbers.vector(n), VecX::Zero(n));
    cg.solve();
    CHECK(cg.status() == Status::stagnated);
    CHECK(cg.residual() > 1e-10);
    CHECK(cg.residual() < 1e-3);
    // 1200; without looking on the way it takes 1895.
    CHECK(cg.iterations() < 1500);
}

TEST_CASE("The residual that stops the iteration is the true one", "[solvers]") {
    const SparseMatrix A = chain(400, true);
    Numbers numbers;
    const VecX b = numbers.vector(400);
    ConjugateGradients cg(A, {1e-12});
    cg.begin(b, numbers.vector(400));
    cg.solve();
    REQUIRE(cg.converged());
    CHECK((b - A * cg.x()).norm() / b.norm() <= 1.0001e-12);
}

TEST_CASE("Trivial and bad right sides", "[solvers]") {
    const SparseMatrix A = chain(5, true);
    ConjugateGradients cg(A, {});
    cg.begin(VecX::Zero(5), VecX::Ones(5));
    CHECK(cg.converged());
    CHECK(cg.x().isZero(0));
    CHECK(cg.residual() == 0);

    // Starting from the solution needs no iteration.
    cg.begin(A * VecX::Ones(5), VecX::Ones(5));
    CHECK(cg.converged());
    CHECK(cg.iterations() == 0);

    VecX b = VecX::Ones(5);
    b[3] = std::numeric_limits<Real>::quiet_NaN();
    CHECK_THROWS_WITH(cg.begin(b, VecX::Zero(5)), ContainsSubstring("entry 3"));
    CHECK_THROWS_AS(cg.begin(VecX::Zero(4), VecX::Zero(5)), Refused);
    for (const Real tolerance : {0.0, -1.0, 1.0, std::numeric_limits<Real>::quiet_NaN()})
        CHECK_THROWS_WITH(ConjugateGradients(A, {tolerance}), ContainsSubstring("tolerance"));

    const SparseMatrix empty(0, 0);
    ConjugateGradients nothing(empty, {});
    nothing.begin(VecX(0), VecX(0));
    CHECK(nothing.converged());
}

TEST_CASE("A saved iteration goes on to the same bits, and its memory stays in place", "[solvers]") {
    const SparseMatrix A = chain(50, true);
    Numbers numbers;
    const VecX b = numbers.vector(50);
    ConjugateGradients cg(A, {1e-12});
    cg.begin(b, VecX::Zero(50));
    const Real* memory = cg.x().data();
    for (int i = 0; i < 7; ++i) cg.iterate();

    std::array<VecX, 4> vectors;
    for (std::size_t i = 0; i < 4; ++i) vectors[i] = *cg.vectors()[i];
    const auto scalars = cg.numbers();
    cg.solve();
    const VecX x = cg.x();
    const Index iterations = cg.iterations();

    for (std::size_t i = 0; i < 4; ++i) *cg.vectors()[i] = vectors[i];
    cg.numbers() = scalars;
    CHECK(cg.iterations() == 7);
    cg.solve();
    CHECK(cg.x() == x);
    CHECK(cg.iterations() == iterations);
    CHECK(cg.x().data() == memory);
}

TEST_CASE("A matrix that is only known by its product is solved alike", "[solvers]") {
    const SparseMatrix A = chain(30, true);
    const LinearMap stencil = [](const VecX& x, VecX& y) {
        const Index n = x.size();
        for (Index i = 0; i < n; ++i) y[i] = 2 * x[i] - (i > 0 ? x[i - 1] : 0) - (i + 1 < n ? x[i + 1] : 0);
    };
    Numbers numbers;
    const VecX b = numbers.vector(30);
    ConjugateGradients by_matrix(30, product_with(A), no_preconditioner(), {1e-12}),
        by_stencil(30, stencil, no_preconditioner(), {1e-12});
    for (auto* cg : {&by_matrix, &by_stencil}) {
        cg->begin(b, VecX::Zero(30));
        cg->solve();
        CHECK(cg->converged());
    }
    CHECK((by_matrix.x() - by_stencil.x()).norm() < 1e-10 * by_matrix.x().norm());
}

TEST_CASE("Sparse Cholesky solves definite systems and reports the others", "[solvers]") {
    Numbers numbers;
    const SparseMatrix A = chain(200, true);
    const VecX x = numbers.vector(200);
    SparseCholesky cholesky;
    cholesky.factorize(A);
    VecX solution;
    cholesky.solve(A * x, solution);
    CHECK((solution - x).norm() < 1e-11 * x.norm());
    // New numbers in the same pattern.
    const SparseMatrix twice = 2 * A;
    cholesky.factorize(twice);
    cholesky.solve(A * x, solution);
    CHECK((solution - 0.5 * x).norm() < 1e-11 * x.norm());

    SparseCholesky singular;
    CHECK_THROWS_WITH(singular.factorize(chain(20, false)), ContainsSubstring("singular"));
    MatX saddle(2, 2);
    saddle << 1, 2, 2, 1;
    const SparseMatrix indefinite = saddle.sparseView();
    CHECK_THROWS_WITH(SparseCholesky().factorize(indefinite), ContainsSubstring("not positive definite"));
}
