#include <pliant/math/error.h>
#include <pliant/solids/rod.h>

#include <pliant/math/dense_matrix.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant {

void rod_slopes(Real segment, PointsIn<2> x, PointsOut<2> slope) {
    slope = (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)) / segment;
}

void rod_strains(PointsIn<2> slope, Eigen::Ref<VecX> strain) {
    for (Index i = 0; i < slope.cols(); ++i) strain[i] = slope.col(i).norm() - 1;
}

Real rod_energy(Real axial_stiffness, Real segment, const Eigen::Ref<const VecX>& strain) {
    return 0.5 * axial_stiffness * segment * strain.squaredNorm();
}

void add_rod_forces(Real axial_stiffness, PointsIn<2> slope, const Eigen::Ref<const VecX>& strain, PointsOut<2> f) {
    for (Index i = 0; i < slope.cols(); ++i) {
        const Real length = slope.col(i).norm();
        const Vec<2> pull = (length > 0 ? axial_stiffness * strain[i] / length : 0) * slope.col(i);
        f.col(i) += pull;
        f.col(i + 1) -= pull;
    }
}

Springs rod_springs(Index segments, Real segment, Real stiffness, Real damping) {
    if (segments < 1) throw Refused(fmt::format("a rod of {} segments is not accepted: give 1 or more", segments));
    std::vector<Spring> springs;
    springs.reserve(static_cast<std::size_t>(segments));
    for (Index i = 0; i < segments; ++i) springs.push_back({i, i + 1, segment, stiffness, damping});
    return Springs(segments + 1, springs);
}

void balance_chain(const Eigen::Ref<const VecX>& stiffness, const Eigen::Ref<const VecX>& force, VecX& added_tension,
                   VecX& move) {
    const Index n = stiffness.size();
    added_tension.resize(n);
    move.resize(n + 1);
    Real beyond = 0;
    for (Index i = n; i-- > 0;) added_tension[i] = beyond += force[i + 1];
    move[0] = 0;
    for (Index i = 0; i < n; ++i) move[i + 1] = move[i] + added_tension[i] / stiffness[i];
}

VecX chain_frequencies(const Eigen::Ref<const VecX>& stiffness, const Eigen::Ref<const VecX>& mass, bool last_is_fixed) {
    const Index springs = stiffness.size(), free = last_is_fixed ? springs - 1 : springs;
    if (free <= 0) return {};
    // In units of the stiffest spring and the lightest mass, so that extremes do not overflow.
    const Real k = stiffness.maxCoeff(), m = mass.minCoeff();
    VecX diagonal(free), beside(std::max<Index>(free - 1, 0));
    for (Index i = 0; i < free; ++i) {
        const Real beyond = i + 1 < springs ? stiffness[i + 1] / k : 0;
        diagonal[i] = (stiffness[i] / k + beyond) * (m / mass[i + 1]);
        if (i + 1 < free) beside[i] = -beyond * std::sqrt(m / mass[i + 1]) * std::sqrt(m / mass[i + 2]);
    }
    return std::sqrt(k) / std::sqrt(m) * tridiagonal_eigenvalues(diagonal, beside).cwiseMax(0).cwiseSqrt();
}

}  // namespace pliant
