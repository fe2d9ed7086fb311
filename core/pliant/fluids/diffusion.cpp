#include <fmt/format.h>
#include <pliant/fluids/diffusion.h>
#include <pliant/math/error.h>
#include <pliant/math/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {
namespace {

void check(Real viscosity, Real dt) {
    if (!(viscosity >= 0) || !std::isfinite(viscosity))
        throw Refused("viscosity", viscosity, "m²/s", "a finite number of at least 0");
    if (!(dt > 0) || !std::isfinite(dt)) throw Refused("time_step", dt, "s", "a finite time above 0");
}

[[noreturn]] void give_up(Index iterations, Real residual, Real target) {
    Failure failure;
    failure.kind = FailureKind::not_converged;
    failure.stage = "viscosity";
    failure.what = fmt::format("implicit diffusion left a residual of {:.3g} after {} iterations", residual, iterations);
    failure.limit = fmt::format("{:.3g} was asked for", target);
    throw Diverged(failure);
}

}  // namespace

template <int Dim>
Diffusion<Dim>::Diffusion(const Lattice<Dim>& lattice, std::vector<Index> held) : laplacian_(lattice), held_(std::move(held)) {
    for (const auto& axis : lattice.sides)
        for (const LatticeSide& side : axis)
            if (side.beyond == Beyond::wall_value) largest_wall_value_ = std::max(largest_wall_value_, std::abs(side.value));
    for (VecX* array : {&residual_, &direction_, &product_}) *array = VecX::Zero(lattice.size());
}

template <int Dim>
void Diffusion<Dim>::zero_held(VecX& values) const {
    for (Index i : held_) values[i] = 0;
}

// r (Σ q_neighbour − 2 Dim q), 0 at held samples.
template <int Dim>
void Diffusion<Dim>::rate_of_change(const VecX& q, Real r, VecX& out) const {
    laplacian_.apply(q, 0, -r, out);
    laplacian_.add_wall_terms(r, out);
    zero_held(out);
}

template <int Dim>
void Diffusion<Dim>::explicit_step(VecX& q, Real r) {
    rate_of_change(q, r, residual_);
    parallel_parts(q.size(), 1, [&](Index first, Index last, int) {
        q.segment(first, last - first) += residual_.segment(first, last - first);
    });
}

template <int Dim>
Real Diffusion<Dim>::magnitude(const VecX& q) const {
    return std::max(std::sqrt(parallel_square(q)), largest_wall_value_ * std::sqrt(static_cast<Real>(q.size())));
}

template <int Dim>
void Diffusion<Dim>::begin_implicit(const VecX& q, Real r, const DiffusionSettings& settings) {
    // The smallest eigenvalue of the matrix is at least 1, so that the error is at most the residual.
    target_ = settings.tolerance * magnitude(q);
    max_iterations_ = settings.max_iterations;
    r_ = r;
    iterations_ = 0;
    rate_of_change(q, r, residual_);
    parallel_parts(q.size(), 1, [&](Index first, Index last, int) {
        direction_.segment(first, last - first) = residual_.segment(first, last - first);
    });
    square_ = parallel_square(residual_);
    if (!std::isfinite(square_)) give_up(0, square_, target_);
}

template <int Dim>
void Diffusion<Dim>::iterate(VecX& q) {
    if (converged()) return;
    if (iterations_ == max_iterations_) give_up(iterations_, residual_norm(), target_);
    const Real curvature = laplacian_.apply(direction_, 1, r_, product_);
    zero_held(product_);
    const Real alpha = square_ / curvature, before = square_;
    square_ = parallel_sum(q.size(), [&](Index first, Index last) {
        const Index n = last - first;
        q.segment(first, n) += alpha * direction_.segment(first, n);
        auto left = residual_.segment(first, n);
        left -= alpha * product_.segment(first, n);
        return left.squaredNorm();
    });
    const Real beta = square_ / before;
    parallel_parts(q.size(), 1, [&](Index first, Index last, int) {
        auto d = direction_.segment(first, last - first);
        d = residual_.segment(first, last - first) + beta * d;
    });
    ++iterations_;
    if (!std::isfinite(square_)) give_up(iterations_, square_, target_);
}

template <int Dim>
Index Diffusion<Dim>::implicit_step(VecX& q, Real r, const DiffusionSettings& settings) {
    begin_implicit(q, r, settings);
    while (!converged()) iterate(q);
    return iterations_;
}

template <int Dim>
Diffusion<Dim>& Viscosity<Dim>::component(int axis) {
    if (!components_[axis]) components_[axis].emplace(grid_.faces(axis), grid_.closed_faces(axis));
    return *components_[axis];
}

template <int Dim>
Real Viscosity<Dim>::explicit_limit(Real viscosity) const {
    if (viscosity == 0) return std::numeric_limits<Real>::infinity();
    return Diffusion<Dim>::explicit_limit() * grid_.dx() * grid_.dx() / viscosity;
}

template <int Dim>
void Viscosity<Dim>::diffuse_explicitly(FaceField<Dim>& velocity, Real viscosity, Real dt) {
    check(viscosity, dt);
    if (viscosity == 0) return;
    const Real limit = explicit_limit(viscosity);
    // A time step that was computed as the limit itself passes in spite of rounding.
    if (dt > limit * (1 + 1e-12))
        throw Refused(
            "time_step", dt, "s",
            fmt::format("at most Δx²/({}ν) = {:.6g} s, the stability limit of explicit diffusion at ν = {:.6g} m²/s and Δx = "
                        "{:.6g} m, or diffuse implicitly",
                        2 * Dim, limit, viscosity, grid_.dx()));
    for (int a = 0; a < Dim; ++a) component(a).explicit_step(velocity[a], viscosity * dt / (grid_.dx() * grid_.dx()));
}

template <int Dim>
Index Viscosity<Dim>::diffuse_implicitly(FaceField<Dim>& velocity, Real viscosity, Real dt, const DiffusionSettings& settings) {
    check(viscosity, dt);
    if (viscosity == 0) return 0;
    Index iterations = 0;
    for (int a = 0; a < Dim; ++a)
        iterations += component(a).implicit_step(velocity[a], viscosity * dt / (grid_.dx() * grid_.dx()), settings);
    return iterations;
}

template class Diffusion<2>;
template class Diffusion<3>;
template class Viscosity<2>;
template class Viscosity<3>;

}  // namespace pliant
