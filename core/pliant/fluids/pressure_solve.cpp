#include <fmt/format.h>
#include <pliant/fluids/pressure_solve.h>
#include <pliant/math/error.h>
#include <pliant/math/parallel.h>

#include <algorithm>
#include <cmath>

namespace pliant {

PressureSolve::PressureSolve(Index cells, Real dx) : dx_(dx) {
    for (VecX* array : {&pressure_, &residual_, &direction_, &z_, &product_}) *array = VecX::Zero(cells);
    scalars_ = VecX::Zero(scalar_count);
}

void PressureSolve::set(const ProjectionSettings& settings) {
    if (!(settings.tolerance > 0 && settings.tolerance < 1))
        throw Refused("tolerance", settings.tolerance, "", "a number between 0 and 1");
    if (settings.max_iterations < 1)
        throw Refused("max_iterations", static_cast<Real>(settings.max_iterations), "", "at least 1");
    settings_ = settings;
}

void PressureSolve::forget_directions() {
    direction_.setZero();
    scalars_[residual_dot_z] = 0;
}

void PressureSolve::begin(const PressureEquation& equation, Real dt, Real rounding) {
    if (!(dt > 0) || !std::isfinite(dt)) throw Refused("time_step", dt, "s", "a finite time above 0");
    if (!residual_.allFinite()) {
        Failure failure;
        failure.field = "velocity";
        failure.what = "the divergence of the velocity is not finite";
        throw Diverged(failure);
    }
    const Real largest = parallel_max_norm(residual_);
    scalars_.setZero();
    scalars_[step] = dt;
    scalars_[initial] = largest;
    scalars_[target] = std::max(settings_.tolerance * largest, rounding);
    const Real scale = -dx_ * dx_ / dt;
    parallel_parts(residual_.size(), 1, [&](Index first, Index last, int) {
        residual_.segment(first, last - first) *= scale;
        direction_.segment(first, last - first).setZero();
    });
    if (largest <= rounding)
        pressure_.setZero();
    else
        start_from_last_pressure(equation);
    measure(parallel_max_norm(residual_));
}

// Of all multiples of the last pressure, takes the one nearest to the solution in the energy norm, α = b·p / p·Ap. It never
// starts farther away than p = 0.
void PressureSolve::start_from_last_pressure(const PressureEquation& equation) {
    const Real energy = equation.multiply(pressure_, product_);
    const Real factor = energy > 0 ? parallel_dot(residual_, pressure_) / energy : 0;
    parallel_parts(pressure_.size(), 1, [&](Index first, Index last, int) {
        pressure_.segment(first, last - first) *= factor;
        residual_.segment(first, last - first) -= factor * product_.segment(first, last - first);
    });
}

void PressureSolve::measure(Real largest_residual) { scalars_[remaining] = largest_residual * scalars_[step] / (dx_ * dx_); }

void PressureSolve::iterate(const PressureEquation& equation) {
    if (converged()) return;
    if (iterations() >= settings_.max_iterations) give_up("the pressure solver reached its limit of iterations");

    const Index cells = pressure_.size();
    // The next direction: the preconditioned residual, made conjugate to the directions before.
    equation.precondition(residual_, z_);
    const Real r_dot_z = parallel_dot(residual_, z_);
    if (!(r_dot_z > 0)) give_up("the pressure solver stagnated");
    const Real beta = scalars_[residual_dot_z] > 0 ? r_dot_z / scalars_[residual_dot_z] : 0;
    parallel_parts(cells, 1, [&](Index first, Index last, int) {
        auto d = direction_.segment(first, last - first);
        d = z_.segment(first, last - first) + beta * d;
    });

    // As far along it as lowers the error most.
    const Real curvature = equation.multiply(direction_, product_);
    if (!(curvature > 0)) give_up("the pressure solver stagnated");
    const Real alpha = r_dot_z / curvature;
    const auto go_along = [&](Index first, Index last) {
        const Index n = last - first;
        pressure_.segment(first, n) += alpha * direction_.segment(first, n);
        auto left = residual_.segment(first, n);
        left -= alpha * product_.segment(first, n);
        return left.cwiseAbs().maxCoeff();
    };
    const Real largest = parallel_reduction(cells, 0, go_along, [](Real a, Real b) { return std::max(a, b); });
    equation.remove_unseen(pressure_);
    scalars_[residual_dot_z] = r_dot_z;
    scalars_[passes] += 1;
    measure(largest);
}

void PressureSolve::give_up(const char* why) const {
    Failure failure;
    failure.kind = FailureKind::not_converged;
    failure.stage = "projection";
    failure.field = "pressure";
    failure.what = fmt::format(
        "{}: after {} iterations the residual is {:.3g} m²/s² and the largest divergence left is {:.3g} 1/s, {:.3g} of the "
        "{:.3g} 1/s before",
        why, iterations(), residual_.lpNorm<Eigen::Infinity>(), remaining_divergence(),
        remaining_divergence() / initial_divergence(), initial_divergence());
    failure.limit = fmt::format("{:.3g} 1/s was asked for, within {} iterations", scalars_[target], settings_.max_iterations);
    throw Diverged(failure);
}

}  // namespace pliant
