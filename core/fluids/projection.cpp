#include <fmt/format.h>
#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/pressure_gradient.h>
#include <pliant/fluids/projection.h>
#include <pliant/math/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {

template <int Dim>
PressureProjection<Dim>::PressureProjection(const StaggeredGrid<Dim>& grid, ProjectionSettings settings)
    : grid_(grid), regions_(grid), multigrid_(grid) {
    set(settings);
    const Index cells = grid.cells().size();
    for (VecX* array : {&pressure_, &residual_, &direction_, &z_, &product_}) *array = VecX::Zero(cells);
    scalars_ = VecX::Zero(scalar_count);
}

template <int Dim>
void PressureProjection<Dim>::domain_changed(const SurfaceFractions<Dim>& fractions) {
    fractions_ = fractions;
    regions_ = FluidRegions<Dim>(grid_);
    multigrid_ = Multigrid<Dim>(grid_, fractions_);
}

template <int Dim>
void PressureProjection<Dim>::set(ProjectionSettings settings) {
    if (!(settings.tolerance > 0 && settings.tolerance < 1))
        throw Refused("tolerance", settings.tolerance, "", "a number between 0 and 1");
    if (settings.max_iterations < 1)
        throw Refused("max_iterations", static_cast<Real>(settings.max_iterations), "", "at least 1");
    settings_ = settings;
}

template <int Dim>
void PressureProjection<Dim>::begin(const FaceField<Dim>& velocity, Real dt) {
    if (!(dt > 0) || !std::isfinite(dt)) throw Refused("time_step", dt, "s", "a finite time above 0");
    regions_.check_flux(velocity);
    divergence(grid_, velocity, residual_);
    if (!residual_.allFinite()) {
        Failure failure;
        failure.field = "velocity";
        failure.what = "the divergence of the velocity is not finite";
        throw Diverged(failure);
    }
    regions_.remove_means(residual_);

    // Below what rounding leaves of a divergence of 0 there is nothing to solve.
    const Real rounding = 8 * Dim * std::numeric_limits<Real>::epsilon() * max_speed(velocity) / grid_.dx();
    const Real largest = residual_.template lpNorm<Eigen::Infinity>();
    scalars_.setZero();
    scalars_[time_step] = dt;
    scalars_[initial] = largest;
    scalars_[target] = std::max(settings_.tolerance * largest, rounding);
    residual_ *= -grid_.dx() * grid_.dx() / dt;
    direction_.setZero();
    for (Index c = 0; grid_.has_solids() && c < pressure_.size(); ++c)
        if (!grid_.is_fluid(c)) pressure_[c] = 0;
    if (largest <= rounding)
        pressure_.setZero();
    else
        start_from_last_pressure();
    measure();
}

// Of all multiples of the last pressure, takes the one nearest to the solution in the energy norm, α = b·p / p·Ap. It never
// starts farther away than p = 0.
template <int Dim>
void PressureProjection<Dim>::start_from_last_pressure() {
    const Real energy = laplacian().apply(pressure_, product_);
    const Real factor = energy > 0 ? residual_.dot(pressure_) / energy : 0;
    pressure_ *= factor;
    residual_ -= factor * product_;
}

template <int Dim>
void PressureProjection<Dim>::measure() {
    scalars_[remaining] = residual_.template lpNorm<Eigen::Infinity>() * scalars_[time_step] / (grid_.dx() * grid_.dx());
}

template <int Dim>
bool PressureProjection<Dim>::converged() const {
    return scalars_[remaining] <= scalars_[target];
}

template <int Dim>
void PressureProjection<Dim>::iterate() {
    if (converged()) return;
    if (iterations() >= settings_.max_iterations) give_up("the pressure solver reached its limit of iterations");

    // The next direction: the preconditioned residual, made conjugate to the directions before.
    multigrid_.precondition(residual_, z_);
    const Real r_dot_z = residual_.dot(z_);
    if (!(r_dot_z > 0)) give_up("the pressure solver stagnated");
    const Real beta = scalars_[residual_dot_z] > 0 ? r_dot_z / scalars_[residual_dot_z] : 0;
    direction_ = z_ + beta * direction_;

    // As far along it as lowers the error most.
    const Real curvature = laplacian().apply(direction_, product_);
    if (!(curvature > 0)) give_up("the pressure solver stagnated");
    const Real alpha = r_dot_z / curvature;
    pressure_ += alpha * direction_;
    residual_ -= alpha * product_;
    regions_.remove_means(pressure_);
    scalars_[residual_dot_z] = r_dot_z;
    scalars_[passes] += 1;
    measure();
}

template <int Dim>
void PressureProjection<Dim>::give_up(const char* why) const {
    Failure failure;
    failure.stage = "projection";
    failure.field = "pressure";
    failure.what =
        fmt::format("{}: after {} iterations the largest divergence left is {:.3g} 1/s, {:.3g} of the {:.3g} 1/s before", why,
                    iterations(), remaining_divergence(), remaining_divergence() / initial_divergence(), initial_divergence());
    failure.limit = fmt::format("{:.3g} 1/s was asked for, within {} iterations", scalars_[target], settings_.max_iterations);
    throw Diverged(failure);
}

template <int Dim>
void PressureProjection<Dim>::apply(FaceField<Dim>& velocity) const {
    if (grid_.has_air())
        subtract_gradient(grid_, pressure_, fractions_, scalars_[time_step], velocity);
    else
        subtract_gradient(grid_, pressure_, scalars_[time_step], velocity);
}

template <int Dim>
Index PressureProjection<Dim>::project(FaceField<Dim>& velocity, Real dt) {
    begin(velocity, dt);
    while (!converged()) iterate();
    apply(velocity);
    return iterations();
}

template <int Dim>
Index PressureProjection<Dim>::iterations() const {
    return static_cast<Index>(scalars_[passes]);
}

template <int Dim>
Real PressureProjection<Dim>::initial_divergence() const {
    return scalars_[initial];
}

template <int Dim>
Real PressureProjection<Dim>::remaining_divergence() const {
    return scalars_[remaining];
}

template class PressureProjection<2>;
template class PressureProjection<3>;

}  // namespace pliant
