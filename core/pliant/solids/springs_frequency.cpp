#include <pliant/math/watch.h>
#include <pliant/solids/springs_frequency.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pliant {
namespace {

template <int Dim>
Mat<Dim> stiffness_block(const Vec<Dim>& x_ij, Real rest, Real k) {
    const Real length = x_ij.norm();
    if (length == 0) return (rest == 0 ? k : 0) * Mat<Dim>::Identity();
    const Vec<Dim> n = x_ij / length;
    const Real transverse = std::max(Real(0), (length - rest) / length);
    return k * ((1 - transverse) * (n * n.transpose()) + transverse * Mat<Dim>::Identity());
}

template <int Dim>
Mat<Dim> damping_block(const Vec<Dim>& x_ij, SpringDamping mode, Real damping) {
    if (mode == SpringDamping::none) return Mat<Dim>::Zero();
    if (mode == SpringDamping::naive) return damping * Mat<Dim>::Identity();
    const Real length_squared = x_ij.squaredNorm();
    if (length_squared == 0) return Mat<Dim>::Zero();
    return damping / length_squared * x_ij * x_ij.transpose();
}

Real shortest_relaxation(const Springs& springs, SpringDamping mode) {
    if (mode == SpringDamping::none) return 0;
    Real shortest = std::numeric_limits<Real>::infinity();
    for (Index s = 0; s < springs.size(); ++s)
        if (springs.stiffness()[s] > 0) shortest = std::min(shortest, springs.damping()[s] / springs.stiffness()[s]);
    return shortest;
}

// Largest eigenvalue of M^-1 A, where A has the block of every spring at its nodes and its negative between them.
template <int Dim>
Real power_iteration(const Springs& springs, const DiagonalMass& mass, const std::vector<Mat<Dim>>& blocks, int iterations) {
    // Scaled by the roots of the masses the matrix is symmetric, and its Rayleigh quotient a lower bound.
    const VecX inverse_root = mass.inverse().cwiseSqrt();
    VecX direction(mass.size()), scaled(mass.size()), result(mass.size());
    for (Index d = 0; d < direction.size(); ++d) direction[d] = std::cos(1 + Real(d) * Real(d));
    Real eigenvalue = 0;
    for (int n = 0; n < iterations; ++n) {
        tell_progress("largest_frequency", n, iterations);
        const Real norm = direction.norm();
        if (norm == 0) return 0;
        direction /= norm;
        scaled = inverse_root.cwiseProduct(direction);
        result.setZero();
        for (Index s = 0; s < springs.size(); ++s) {
            const Index i = Dim * springs.i(s), j = Dim * springs.j(s);
            const Vec<Dim> force =
                blocks[static_cast<std::size_t>(s)] * (scaled.template segment<Dim>(i) - scaled.template segment<Dim>(j));
            result.template segment<Dim>(i) += force;
            result.template segment<Dim>(j) -= force;
        }
        result.array() *= inverse_root.array();
        eigenvalue = direction.dot(result);
        direction = result;
    }
    return std::max(eigenvalue, Real(0));
}

}  // namespace

template <int Dim>
SpringRates spring_rate_estimates(const Springs& springs, const DiagonalMass& mass, SpringDamping mode, PointsIn<Dim> x,
                                  int iterations) {
    SpringRates rates;
    rates.relaxation_time = shortest_relaxation(springs, mode);
    std::vector<Mat<Dim>> blocks;
    for (Index s = 0; s < springs.size(); ++s)
        blocks.push_back(
            stiffness_block<Dim>(x.col(springs.j(s)) - x.col(springs.i(s)), springs.rest_length()[s], springs.stiffness()[s]));
    rates.omega = std::sqrt(power_iteration<Dim>(springs, mass, blocks, iterations));
    if (mode == SpringDamping::none) return rates;
    for (Index s = 0; s < springs.size(); ++s)
        blocks[static_cast<std::size_t>(s)] =
            damping_block<Dim>(x.col(springs.j(s)) - x.col(springs.i(s)), mode, springs.damping()[s]);
    rates.damping = power_iteration<Dim>(springs, mass, blocks, iterations);
    return rates;
}

SpringRates with_spring_to(const SpringRates& rates, Real stiffness, Real mass) {
    SpringRates both = rates;
    both.omega = std::hypot(rates.omega, std::sqrt(stiffness / mass));
    return both;
}

Real stability_limit(Scheme scheme, const SpringRates& rates) {
    if (scheme == Scheme::explicit_euler) {
        const Real infinite = std::numeric_limits<Real>::infinity();
        if (rates.omega == 0) return rates.damping > 0 ? 2 / rates.damping : infinite;
        return std::min(rates.relaxation_time, rates.damping > 0 ? 2 / rates.damping : 0);
    }
    return stability_limit(scheme, rates.omega, rates.omega > 0 ? rates.damping / (2 * rates.omega) : 0);
}

template SpringRates spring_rate_estimates<2>(const Springs&, const DiagonalMass&, SpringDamping, PointsIn<2>, int);
template SpringRates spring_rate_estimates<3>(const Springs&, const DiagonalMass&, SpringDamping, PointsIn<3>, int);

}  // namespace pliant
