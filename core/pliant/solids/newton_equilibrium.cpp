#include <pliant/math/conjugate_gradients.h>
#include <pliant/math/error.h>
#include <pliant/solids/newton_equilibrium.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace pliant {
namespace {

// Of the decrease that the slope promises [Nocedal2006 eq. 3.4].
constexpr Real enough_decrease = 1e-4;
constexpr Real shortest_step = 1e-10;
constexpr Real linear_tolerance = 1e-12;  // of conjugate gradients

}  // namespace

template <int Dim>
NewtonEquilibrium<Dim>::NewtonEquilibrium(const ElasticBody<Dim>& body, const DisplacementConstraints<Dim>& constraints,
                                          Settings settings)
    : body_(&body),
      settings_(settings),
      constraints_(constraints),
      stiffness_(body.pattern()),
      system_(body.pattern(), constraints.flags()) {
    body.check_support(constraints);
    if (!(settings.tolerance > 0 && settings.tolerance < 1)) throw Refused("tolerance", settings.tolerance, "", "(0, 1)");
    cholesky_.analyze(system_.matrix());
    u_ = force_ = step_ = internal_ = residual_force_ = trial_ = Points<Dim>::Zero(Dim, body.node_count());
}

template <int Dim>
void NewtonEquilibrium<Dim>::begin(const Points<Dim>& u0, const Points<Dim>& force,
                                   const DisplacementConstraints<Dim>& constraints) {
    constraints_ = constraints;
    u_ = u0;
    force_ = force;
    step_.setZero();
    iterations_ = 0;
    step_length_ = 0;
    made_definite_ = false;
    status_ = Status::running;
    potential_ = body_->energy(u_) - flat(force_).dot(flat(u_));
    measure();
}

template <int Dim>
void NewtonEquilibrium<Dim>::solve() {
    while (running()) iterate();
}

// The forces at u, and whether they balance.
template <int Dim>
void NewtonEquilibrium<Dim>::measure() {
    body_->internal_force(u_, internal_);
    residual_force_.setZero();
    for (const int i : system_.free()) residual_force_.data()[i] = force_.data()[i] - internal_.data()[i];
    residual_size_ = residual_force_.cwiseAbs().maxCoeff();
    const Real scale = std::max(internal_.cwiseAbs().maxCoeff(), force_.cwiseAbs().maxCoeff());
    residual_ = scale > 0 ? residual_size_ / scale : 0;
    if (constraints_.distance_from(u_) == 0 && residual_ <= settings_.tolerance) status_ = Status::converged;
}

// K d = residual over the free components, with the supports moved by what they lack.
template <int Dim>
void NewtonEquilibrium<Dim>::find_direction() {
    step_.setZero();
    for (Index i = 0; i < u_.size(); ++i)
        if (constraints_.flags()[static_cast<std::size_t>(i)]) step_.data()[i] = constraints_.values().data()[i] - u_.data()[i];
    diagonal_shift_ = 0;
    made_definite_ = !solve_tangent(false);
    if (made_definite_ && !solve_tangent(true)) {
        // What is left singular is given a small stiffness of its own.
        SparseMatrix shifted = system_.matrix();
        diagonal_shift_ = 1e-8 * shifted.diagonal().cwiseAbs().maxCoeff();
        shifted.diagonal().array() += diagonal_shift_;
        cholesky_.factorize(shifted);
        cholesky_.solve(right_side_, direction_);
    }
    for (std::size_t k = 0; k < system_.free().size(); ++k) step_.data()[system_.free()[k]] = direction_[static_cast<Index>(k)];
}

// False where the tangent is not positive definite.
template <int Dim>
bool NewtonEquilibrium<Dim>::solve_tangent(bool definite) {
    body_->stiffness(u_, definite, stiffness_);
    system_.update(stiffness_);
    full_ = flat(residual_force_) - stiffness_ * flat(step_);
    system_.reduce(full_, right_side_);
    const SparseMatrix& matrix = system_.matrix();
    try {
        if (settings_.solver == LinearSolver::direct) {
            cholesky_.factorize(matrix);
            cholesky_.solve(right_side_, direction_);
        } else {
            ConjugateGradients cg(matrix.rows(), product_with(matrix), incomplete_cholesky_preconditioner(matrix),
                                  {.tolerance = linear_tolerance});
            cg.begin(right_side_, VecX::Zero(right_side_.size()));
            cg.solve();
            direction_ = cg.x();
        }
    } catch (const Diverged&) {
        return false;
    }
    return true;
}

// Change of the potential energy along the step, to first order.
template <int Dim>
Real NewtonEquilibrium<Dim>::slope() const {
    return (flat(internal_) - flat(force_)).dot(flat(step_));
}

// Takes the step when the potential energy falls enough; while the supports still move, when it stays finite. Near the solution,
// where the energy falls by less than its rounding, the residual decides.
template <int Dim>
bool NewtonEquilibrium<Dim>::try_step(Real length, Real slope) {
    trial_ = u_ + length * step_;
    // A whole step ends on the supports to the bit.
    if (length == 1)
        for (Index i = 0; i < u_.size(); ++i)
            if (constraints_.flags()[static_cast<std::size_t>(i)]) trial_.data()[i] = constraints_.values().data()[i];
    const Real work = flat(force_).dot(flat(trial_)), energy = body_->energy(trial_);
    const Real potential = energy - work;
    if (!std::isfinite(potential)) return false;
    const bool moves_supports = constraints_.distance_from(u_) > 0;
    const Real rounding = 64 * std::numeric_limits<Real>::epsilon() * (std::abs(energy) + std::abs(work) + body_->energy_scale());
    if (!moves_supports && potential > potential_ + enough_decrease * length * slope + rounding) return false;
    u_.swap(trial_);
    potential_ = potential;
    step_length_ = length;
    return true;
}

template <int Dim>
void NewtonEquilibrium<Dim>::iterate() {
    if (!running()) return;
    find_direction();
    const Real downhill = slope(), residual_before = residual_size_;
    const bool moves_supports = constraints_.distance_from(u_) > 0;
    Real length = body_->admissible_share(u_, step_);
    while (!try_step(length, downhill)) {
        length /= 2;
        if (length < shortest_step) {
            status_ = Status::stagnated;
            return;
        }
    }
    ++iterations_;
    measure();
    if (!running()) return;
    // A whole step that no longer lowers a residual near rounding has done all it can.
    const bool at_rounding = !moves_supports && length == 1 && residual_ < 1e-6 && residual_size_ > 0.5 * residual_before;
    if (at_rounding) status_ = Status::stagnated;
    if (running() && iterations_ >= settings_.max_iterations) status_ = Status::capped;
}

template <int Dim>
void NewtonEquilibrium<Dim>::require_convergence() const {
    if (converged()) return;
    Failure failure;
    failure.kind = FailureKind::not_converged;
    failure.field = "displacement";
    failure.what =
        fmt::format("Newton's method {} after {} iterations with a residual force of {:.3g} of the largest force",
                    status_ == Status::stagnated ? "finds no further step" : "has not converged", iterations_, residual_);
    failure.limit = fmt::format("{:.3g}: load in smaller steps, or allow more iterations", settings_.tolerance);
    failure.value = residual_;
    failure.bound = settings_.tolerance;
    throw Diverged(failure);
}

template <int Dim>
void NewtonEquilibrium<Dim>::reaction(Points<Dim>& reaction) const {
    reaction = internal_ - force_;
    for (const int i : system_.free()) reaction.data()[i] = 0;
}

template class NewtonEquilibrium<2>;
template class NewtonEquilibrium<3>;

}  // namespace pliant
