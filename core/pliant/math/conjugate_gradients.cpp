#include <pliant/math/conjugate_gradients.h>
#include <pliant/math/error.h>
#include <pliant/math/watch.h>

#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

namespace pliant {
namespace {

constexpr Index drift_check_interval = 50;
constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

void require_finite(const char* name, const VecX& values, Index size) {
    if (values.size() != size)
        throw Refused(fmt::format("{} has {} entries, but the system has {} unknowns", name, values.size(), size));
    for (Index i = 0; i < size; ++i)
        if (!std::isfinite(values[i]))
            throw Refused(fmt::format("entry {} of {} is {}, which is not a finite number", i, name, values[i]));
}

void require_positive_diagonal(const SparseMatrix& matrix) {
    for (Index i = 0; i < matrix.rows(); ++i) {
        const Real diagonal = matrix.coeff(i, i);
        if (diagonal > 0 && std::isfinite(diagonal)) continue;
        Failure failure;
        failure.kind = FailureKind::not_converged;
        failure.index = i;
        failure.what = fmt::format("the matrix is not positive definite: diagonal entry {} is {}", i, diagonal);
        throw Diverged(failure);
    }
}

}  // namespace

LinearMap product_with(const SparseMatrix& matrix) {
    // Column j of a symmetric matrix is row j: each result is a sum over one column.
    return [&matrix](const VecX& x, VecX& y) { y.noalias() = matrix.transpose() * x; };
}

LinearMap no_preconditioner() {
    return [](const VecX& r, VecX& z) { z = r; };
}

LinearMap jacobi_preconditioner(const SparseMatrix& matrix) {
    require_positive_diagonal(matrix);
    return [inverse = VecX(matrix.diagonal().cwiseInverse())](const VecX& r, VecX& z) { z = inverse.cwiseProduct(r); };
}

LinearMap incomplete_cholesky_preconditioner(const SparseMatrix& matrix) {
    require_positive_diagonal(matrix);
    if (matrix.rows() == 0) return no_preconditioner();
    // In the given order of unknowns: a fill-reducing order worsens a factor without fill.
    using Factor = Eigen::IncompleteCholesky<Real, Eigen::Lower, Eigen::NaturalOrdering<int>>;
    const auto factor = std::make_shared<const Factor>(matrix);
    return [factor](const VecX& r, VecX& z) {
        z = factor->scalingS().cwiseProduct(r);
        factor->matrixL().triangularView<Eigen::Lower>().solveInPlace(z);
        factor->matrixL().adjoint().triangularView<Eigen::Upper>().solveInPlace(z);
        z.array() *= factor->scalingS().array();
    };
}

ConjugateGradients::ConjugateGradients(Index size, LinearMap matrix, LinearMap preconditioner, Settings settings)
    : matrix_(std::move(matrix)),
      preconditioner_(std::move(preconditioner)),
      settings_(settings),
      max_iterations_(settings.max_iterations >= 0 ? settings.max_iterations : std::max<Index>(100, 10 * size)) {
    if (!(settings.tolerance > 0 && settings.tolerance < 1))
        throw Refused("tolerance", settings.tolerance, "", "a value in (0, 1)");
    for (VecX* vector : {&b_, &x_, &r_, &p_, &z_, &Ap_}) vector->setZero(size);
    stop(Status::converged);
}

ConjugateGradients::ConjugateGradients(const SparseMatrix& matrix, Settings settings)
    : ConjugateGradients(matrix.rows(), product_with(matrix), jacobi_preconditioner(matrix), settings) {}

void ConjugateGradients::begin(const VecX& b, const VecX& x0) {
    require_finite("the right side", b, b_.size());
    require_finite("the first guess", x0, x_.size());
    numbers_ = {};
    numbers_[smallest_quotient] = std::numeric_limits<Real>::max();
    numbers_[last_true_residual] = std::numeric_limits<Real>::max();
    x_ = x0;
    const Real norm = b.stableNorm();
    numbers_[scale] = norm > 0 ? std::ldexp(1.0, std::ilogb(norm)) : 1;
    b_ = b / numbers_[scale];
    numbers_[norm_b] = b_.norm();
    if (numbers_[norm_b] == 0) {
        x_.setZero();
        r_.setZero();
        p_.setZero();
        return stop(Status::converged);
    }
    stop(Status::running);
    check_residual();
    if (running() && iterations() >= max_iterations_) stop(Status::capped);
}

// Computes the residual anew, and stops or starts a new sequence of directions from it.
void ConjugateGradients::check_residual() {
    matrix_(x_, Ap_);
    r_ = b_ - Ap_ / numbers_[scale];
    const Real residual = r_.norm() / numbers_[norm_b];
    numbers_[residual_number] = residual;
    if (residual <= settings_.tolerance) return stop(Status::converged);
    // Fresh residuals that no longer fall are rounding.
    if (residual > 0.5 * numbers_[last_true_residual]) return stop(Status::stagnated);
    numbers_[last_true_residual] = residual;
    restart();
}

void ConjugateGradients::restart() {
    preconditioner_(r_, z_);
    p_ = z_;
    numbers_[r_dot_z] = r_.dot(z_);
    numbers_[p_norm] = numbers_[r_dot_z];
}

void ConjugateGradients::iterate() {
    if (!running()) return;

    // Curvature along the direction; its quotient with |p|^2 in the norm of the preconditioner lies between the extreme
    // eigenvalues of the preconditioned matrix.
    matrix_(p_, Ap_);
    const Real curvature = p_.dot(Ap_);
    const Real quotient = curvature / numbers_[p_norm];
    if (!std::isfinite(quotient) || !(quotient > epsilon * numbers_[largest_quotient])) break_down(quotient);
    numbers_[largest_quotient] = std::max(numbers_[largest_quotient], quotient);
    numbers_[smallest_quotient] = std::min(numbers_[smallest_quotient], quotient);

    // Step to the minimum along the direction.
    const Real alpha = numbers_[r_dot_z] / curvature;
    x_.noalias() += alpha * numbers_[scale] * p_;
    r_.noalias() -= alpha * Ap_;
    numbers_[iteration_number] += 1;
    numbers_[residual_number] = r_.norm() / numbers_[norm_b];

    // The updated residual drifts from the true one by rounding, so that it only tells when to look.
    if (residual() <= settings_.tolerance || has_drifted()) {
        check_residual();
    } else {
        preconditioner_(r_, z_);
        const Real before = numbers_[r_dot_z];
        numbers_[r_dot_z] = r_.dot(z_);
        const Real beta = numbers_[r_dot_z] / before;
        p_ = z_ + beta * p_;
        // The new residual is orthogonal to the old direction, hence Pythagoras.
        numbers_[p_norm] = numbers_[r_dot_z] + beta * beta * numbers_[p_norm];
    }
    if (running() && iterations() >= max_iterations_) stop(Status::capped);
}

// Now and then: is the true residual far above the updated one? Then more iterations along these directions lower only the
// latter.
bool ConjugateGradients::has_drifted() {
    if (iterations() % drift_check_interval != 0) return false;
    matrix_(x_, Ap_);
    return residual() * numbers_[norm_b] < 0.1 * (b_ - Ap_ / numbers_[scale]).norm();
}

void ConjugateGradients::solve() {
    while (running()) cancel_point(), iterate();
}

Real ConjugateGradients::condition_seen() const {
    return numbers_[largest_quotient] > 0 ? numbers_[largest_quotient] / numbers_[smallest_quotient] : 1;
}

void ConjugateGradients::break_down(Real quotient) const {
    Failure failure;
    failure.kind = FailureKind::not_converged;
    failure.what = fmt::format(
        "conjugate gradients broke down in iteration {}: the matrix is singular or not positive definite (Rayleigh quotient "
        "{:.3g} after "
        "{:.3g}), relative residual {:.3g}",
        iterations() + 1, quotient, numbers_[largest_quotient], residual());
    throw Diverged(failure);
}

void ConjugateGradients::require_convergence() const {
    if (converged()) return;
    Failure failure;
    failure.kind = FailureKind::not_converged;
    failure.what =
        fmt::format("conjugate gradients reached a relative residual of {:.3g} in {} iterations", residual(), iterations());
    if (status() == Status::stagnated)
        failure.limit = fmt::format("Rounding allows no less: give a tolerance above {:.3g} instead of {:.3g}", residual(),
                                    settings_.tolerance);
    else
        failure.limit = fmt::format("The tolerance is {:.3g}, the cap {} iterations: raise one of them", settings_.tolerance,
                                    max_iterations_);
    throw Diverged(failure);
}

}  // namespace pliant
