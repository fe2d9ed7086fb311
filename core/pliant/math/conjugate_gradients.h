// Preconditioned conjugate gradients for symmetric positive definite systems [Shewchuk1994 §B3], one iteration at a time.
#pragma once
#include <pliant/math/types.h>

#include <array>
#include <functional>

namespace pliant {

// y = A x for a linear map A. y has its size already and is not x.
using LinearMap = std::function<void(const VecX& x, VecX& y)>;

// Maps over a matrix that outlives them. The matrix is symmetric with both triangles stored.
LinearMap product_with(const SparseMatrix& matrix);
// Preconditioners approximate the inverse of a symmetric positive definite matrix; their numbers are taken when they are made.
// Each throws Diverged, naming the unknown, when a diagonal entry is not positive.
LinearMap no_preconditioner();
LinearMap jacobi_preconditioner(const SparseMatrix& matrix);
LinearMap incomplete_cholesky_preconditioner(const SparseMatrix& matrix);

class ConjugateGradients {
public:
    struct Settings {
        Real tolerance = 1e-10;     // of |b - A x| / |b|
        Index max_iterations = -1;  // cap; negative: ten times the number of unknowns, at least 100
    };
    enum class Status {
        running,
        converged,  // |b - A x| <= tolerance |b|, with the residual computed anew and not only updated
        capped,     // the cap on iterations is reached first
        stagnated,  // rounding allows no smaller residual
    };

    // Throws Refused for a tolerance outside (0, 1).
    ConjugateGradients(Index size, LinearMap matrix, LinearMap preconditioner, Settings settings);
    // Of a sparse matrix that outlives this, with the Jacobi preconditioner.
    ConjugateGradients(const SparseMatrix& matrix, Settings settings);

    // Starts on A x = b from x0. Throws Refused, naming the entry, when b or x0 is not finite. b = 0 is solved at once by x = 0.
    void begin(const VecX& b, const VecX& x0);
    // One iteration; nothing is allocated, and nothing is done unless running(). Throws Diverged when the matrix turns out to be
    // singular or indefinite.
    void iterate();
    void solve();  // iterates while running()

    bool running() const { return status() == Status::running; }
    bool converged() const { return status() == Status::converged; }
    Status status() const { return static_cast<Status>(static_cast<int>(numbers_[status_number])); }
    // Throws Diverged, with the residual that was reached, unless converged().
    void require_convergence() const;

    const VecX& x() const { return x_; }
    void residual_vector(VecX& r) const { r = numbers_[scale] * r_; }  // b - A x
    Real residual() const { return numbers_[residual_number]; }        // |b - A x| / |b|; 0 when b = 0
    Index iterations() const { return static_cast<Index>(numbers_[iteration_number]); }
    Index max_iterations() const { return max_iterations_; }
    Real tolerance() const { return settings_.tolerance; }
    // Largest over smallest Rayleigh quotient met so far: a lower bound for the condition number of the preconditioned matrix.
    Real condition_seen() const;

    // Everything that the next iteration depends on, to save and restore: right side, solution, residual, direction, and numbers.
    std::array<VecX*, 4> vectors() { return {&b_, &x_, &r_, &p_}; }
    std::array<Real, 10>& numbers() { return numbers_; }

private:
    enum Number {
        iteration_number,
        status_number,
        scale,
        norm_b,
        residual_number,
        r_dot_z,
        p_norm,
        largest_quotient,
        smallest_quotient,
        last_true_residual
    };

    void restart();
    void check_residual();
    bool has_drifted();
    void stop(Status status) { numbers_[status_number] = static_cast<Real>(status); }
    [[noreturn]] void break_down(Real quotient) const;

    LinearMap matrix_, preconditioner_;
    Settings settings_;
    Index max_iterations_;
    // Carried from one iteration to the next; b, r and p in units of a power of two near |b|, so that their squares are numbers.
    VecX b_, x_, r_, p_;
    VecX z_, Ap_;  // preconditioned residual and A p, of one iteration
    std::array<Real, 10> numbers_{};
};

}  // namespace pliant
