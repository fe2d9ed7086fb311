#include <pliant/math/error.h>
#include <pliant/time/implicit.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr Real sufficient_decrease = 1e-4;
constexpr int unproved_steps = 5;

std::vector<char> fixed_flags(const Mass& mass) {
    std::vector<char> fixed(static_cast<std::size_t>(mass.size()));
    for (Index d = 0; d < mass.size(); ++d) fixed[static_cast<std::size_t>(d)] = mass.fixed(d);
    return fixed;
}

Real largest(const VecX& values) { return values.size() ? values.lpNorm<Eigen::Infinity>() : 0; }

}  // namespace

ImplicitSolver::ImplicitSolver(SecondOrderSystem& system, const Mass& mass, NewtonOptions options)
    : system_(system), mass_(mass), options_(options), model_(fixed_flags(mass)) {
    for (VecX* values : {&x_, &v_, &residual_, &reaction_, &direction_, &trial_, &scratch_}) values->setZero(mass.size());
    for (Index d = 0; d < mass.size(); ++d)
        if (mass.fixed(d)) fixed_.push_back(d);
}

void ImplicitSolver::set_options(const NewtonOptions& options) {
    if (options == options_) return;
    options_ = options;
    gradients_.reset();
    linearised_ = nullptr;
    linear_residual_.resize(0);
}

void ImplicitSolver::begin(ConstDofs x) {
    if (options_.linear_solve == LinearSolve::conjugate_gradients && form_.lower_bound.size() > 0)
        throw Refused("conjugate gradients: lower bounds are kept by the direct solve alone");
    if (!system_.has_potential() && form_.lower_bound.size() > 0)
        throw Refused("lower bounds: only a system whose forces have a potential keeps them");
    system_.begin_step(form_.frozen_at);
    iterations_ = unproved_ = linear_iterations_ = 0;
    converged_ = false;
    residual_norm_ = last_step_ = 0;

    // Fixed degrees of freedom move as the form predicts, and never again.
    x_ = x;
    for (Index d = 0; d < x_.size(); ++d)
        if (mass_.fixed(d)) x_[d] = form_.acceleration_origin[d];
    trial_ = form_.acceleration_origin;
    keep_bounds(x_);
    keep_bounds(trial_);
    length_ = system_.length_scale(x_);
    const Real at_prediction = merit(trial_), at_start = merit(x_);
    began_at_prediction_ = at_prediction <= at_start;
    if (began_at_prediction_) x_.swap(trial_);
    first_merit_ = began_at_prediction_ ? at_prediction : at_start;
    v_ = form_.velocity_rate * (x_ - form_.velocity_origin);
    if (!std::isfinite(first_merit_)) fail("the step starts with an energy that is not finite");
}

// What the steps lower: the incremental potential, J, or else 1/2 |residual|^2, N^2.
Real ImplicitSolver::merit(const VecX& x) {
    if (!system_.has_potential()) {
        v_ = form_.velocity_rate * (x - form_.velocity_origin);
        residual_at(x, v_, scratch_);
        return 0.5 * scratch_.squaredNorm();
    }
    scratch_ = x - form_.acceleration_origin;
    const Real inertia = 0.5 * form_.acceleration_rate * mass_.square(scratch_);
    scratch_ = form_.velocity_rate * (x - form_.velocity_origin);
    return inertia + system_.dissipation(scratch_) / form_.velocity_rate + system_.potential(x);
}

void ImplicitSolver::keep_bounds(VecX& x) const {
    if (form_.lower_bound.size() == 0) return;
    for (Index d = 0; d < x.size(); ++d)
        if (!mass_.fixed(d) && x[d] < form_.lower_bound[d]) x[d] = form_.lower_bound[d];
}

void ImplicitSolver::residual_at(const VecX& x, const VecX& v, VecX& g) const {
    g.resize(x.size());
    system_.force(x, v, g);
    offset_ = x - form_.acceleration_origin;
    mass_.multiply(offset_, inertia_);
    g = form_.acceleration_rate * inertia_ - g;
    for (Index d = 0; d < g.size(); ++d)
        if (mass_.fixed(d)) g[d] = 0;
}

void ImplicitSolver::imbalance(VecX& r) const {
    residual_at(x_, v_, r);
    r -= reaction_;
}

void ImplicitSolver::evaluate_residual() {
    residual_at(x_, v_, residual_);
    residual_norm_ = 0;
    for (Index d = 0; d < residual_.size(); ++d) {
        const bool pressed = form_.lower_bound.size() > 0 && x_[d] <= form_.lower_bound[d] && residual_[d] > 0;
        reaction_[d] = pressed ? residual_[d] : 0;
        if (!pressed) residual_norm_ = std::max(residual_norm_, std::abs(residual_[d]));
    }
}

void ImplicitSolver::find_direction() {
    if (!system_.has_potential()) return solve_for_direction();
    options_.linear_solve == LinearSolve::direct ? factorise_for_direction() : iterate_for_direction();
}

void ImplicitSolver::factorise_for_direction() {
    room_.resize(form_.lower_bound.size());
    if (room_.size() > 0) room_ = form_.lower_bound - x_;
    // The exact second derivatives converge fastest; where they are not positive definite, Newton's direction need not lead
    // downhill, and the positive ones take their place.
    for (const auto curvature : {SecondOrderSystem::Curvature::exact, SecondOrderSystem::Curvature::positive}) {
        model_.set_matrix(system_.stiffness(x_, form_.velocity_rate, curvature));
        if (mass_.matrix())
            model_.add_matrix(form_.acceleration_rate, *mass_.matrix());
        else
            model_.add_diagonal(form_.acceleration_rate, mass_.diagonal());
        if (model_.minimise(residual_, room_, direction_)) {
            reaction_ = model_.multiplier();
            return;
        }
    }
    fail("the matrix of the Newton iteration could not be factorised");
}

void ImplicitSolver::solve_for_direction() {
    const SparseMatrix& stiffness = system_.stiffness(x_, form_.velocity_rate, SecondOrderSystem::Curvature::exact);
    if (!lu_.solve(stiffness, form_.acceleration_rate, mass_, residual_, direction_))
        fail("the matrix of the Newton iteration is singular");
}

void ImplicitSolver::iterate_for_direction() {
    linearised_ = system_.linearise(x_, form_.velocity_rate, form_.acceleration_rate, mass_);
    if (!linearised_) throw Refused("conjugate gradients: this system offers no products; give the direct solve");
    // Fixed degrees of freedom take no part.
    const auto masked = [this](auto map) {
        return [this, map](const VecX& from, VecX& to) {
            (linearised_->*map)(from, to);
            for (const Index d : fixed_) to[d] = 0;
        };
    };
    if (!gradients_)
        gradients_.emplace(x_.size(), masked(&LinearisedSystem::multiply), masked(&LinearisedSystem::precondition),
                           ConjugateGradients::Settings{options_.linear_tolerance, options_.linear_iterations});
    scratch_ = -residual_;
    start_direction();
    gradients_->begin(scratch_, direction_);
    try {
        gradients_->solve();
        linear_converged_ = gradients_->status() != ConjugateGradients::Status::capped;
    } catch (const Diverged&) {
        // Where rounding hides the curvature along their direction; what they have reached leads downhill all the same.
        if (gradients_->iterations() == 0) throw;
        linear_converged_ = false;
    }
    linear_iterations_ += static_cast<int>(gradients_->iterations());
    direction_ = gradients_->x();
    if (options_.warm_start && iterations_ == 0) warm_direction_ = direction_;
    gradients_->residual_vector(linear_residual_);
    reaction_.setZero();
}

// Where the model -scratch_ . d + 1/2 d . H d is lowest along the direction of the step before, or 0.
void ImplicitSolver::start_direction() {
    direction_.setZero(x_.size());
    if (!options_.warm_start || iterations_ > 0 || warm_direction_.size() != x_.size()) return;
    linearised_->multiply(warm_direction_, offset_);
    const Real along = warm_direction_.dot(scratch_), curvature = warm_direction_.dot(offset_);
    if (along > 0 && curvature > 0) direction_ = along / curvature * warm_direction_;
}

Real ImplicitSolver::diagonal(Index dof) const {
    if (!system_.has_potential()) return std::abs(lu_.matrix().coeff(dof, dof));
    return linearised_ ? linearised_->diagonal(dof) : model_.diagonal(dof);
}

bool ImplicitSolver::at_rounding_level() const {
    // Positions are known to their rounding, and so is a force only to its stiffness times that.
    const Real rounding = 16 * epsilon * largest(x_);
    for (Index d = 0; d < residual_.size(); ++d)
        if (!(std::abs(residual_[d] - reaction_[d]) <= rounding * diagonal(d))) return false;
    return true;
}

bool ImplicitSolver::step_is_small() const {
    // The potential changes with the square of the step: below the root of the rounding it says nothing about it.
    return largest(direction_) <= std::sqrt(epsilon) * std::max(length_, largest(x_));
}

void ImplicitSolver::take_guarded_step() {
    fraction_ = 1;
    if (unproved_ == 0) {
        reference_.x = x_;
        reference_.direction = direction_;
        reference_.residual = residual_;
        reference_.potential = iterations_ == 0 ? first_merit_ : merit(x_);
    }
    trial_ = x_ + direction_;
    keep_bounds(trial_);
    const Real reached = merit(trial_);
    if (lower_than_reference(trial_, reached)) {
        unproved_ = 0;
    } else if (std::isfinite(reached) && unproved_ < unproved_steps && !last_before_cap()) {
        ++unproved_;
    } else {
        search_from_reference();
        unproved_ = 0;
    }
    last_step_ = (trial_ - x_).cwiseAbs().maxCoeff();
    x_.swap(trial_);
}

// Armijo's condition, along the path that the bounds cut off. The slope of 1/2 |residual|^2 along Newton's direction is minus
// twice its value.
bool ImplicitSolver::lower_than_reference(const VecX& x, Real reached) {
    if (!system_.has_potential()) return reached <= reference_.potential * (1 - 2 * sufficient_decrease * fraction_);
    scratch_ = x - reference_.x;
    return reached <= reference_.potential + sufficient_decrease * reference_.residual.dot(scratch_);
}

void ImplicitSolver::search_from_reference() {
    for (fraction_ = 0.5; fraction_ > epsilon; fraction_ /= 2) {
        trial_ = reference_.x + fraction_ * reference_.direction;
        keep_bounds(trial_);
        if (lower_than_reference(trial_, merit(trial_))) return;
    }
    fail(system_.has_potential() ? "no step along the Newton direction lowers the potential"
                                 : "no step along the Newton direction lowers the residual");
}

void ImplicitSolver::iterate() {
    evaluate_residual();
    if (!residual_.allFinite()) fail("the residual is not finite");
    if (residual_norm_ == 0) {
        converged_ = true;
        return;
    }
    find_direction();
    if (step_is_small()) {
        fraction_ = 1;
        last_step_ = largest(direction_);
        converged_ = linear_converged_ && (last_step_ <= options_.relative_step * length_ || at_rounding_level());
        x_ += direction_;
        keep_bounds(x_);
    } else {
        take_guarded_step();
        converged_ = linear_converged_ && fraction_ == 1 && unproved_ == 0 && last_step_ <= options_.relative_step * length_;
    }
    v_ = form_.velocity_rate * (x_ - form_.velocity_origin);
    ++iterations_;
}

void ImplicitSolver::finish(Dofs x, Dofs v) const {
    if (!converged_ && options_.at_cap == AtCap::fail) fail("Newton's method did not converge");
    x = x_;
    for (Index d = 0; d < v.size(); ++d)
        if (!mass_.fixed(d)) v[d] = v_[d];
}

void ImplicitSolver::fail(const std::string& what) const {
    Failure failure;
    failure.kind = FailureKind::not_converged;
    failure.what = fmt::format("{} after {} iterations: residual {:.6g} N, last step {:.6g} m", what, iterations_, residual_norm_,
                               last_step_);
    failure.limit = fmt::format("accepted: at most {} iterations, and a last step of at most {:.6g} m", options_.max_iterations,
                                options_.relative_step * length_);
    throw Diverged(failure);
}

}  // namespace pliant
