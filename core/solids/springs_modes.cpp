#include <pliant/math/dense_matrix.h>
#include <pliant/math/error.h>
#include <pliant/solids/springs_matrix.h>
#include <pliant/solids/springs_modes.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pliant {

Real SpringModes::omega(Index mode) const { return std::sqrt(std::max(omega_squared[mode], Real(0))); }

Index SpringModes::without_stiffness(Real part) const {
    if (size() == 0) return 0;
    const Real largest = omega_squared.cwiseAbs().maxCoeff();
    return (omega_squared.array().abs() <= part * part * largest).count();
}

template <int Dim>
SpringModes spring_modes(const Springs& springs, const DiagonalMass& mass, PointsIn<Dim> x) {
    std::vector<Index> free;
    for (Index d = 0; d < mass.size(); ++d)
        if (!mass.fixed(d)) free.push_back(d);
    const auto count = static_cast<Index>(free.size());
    if (count > most_mode_dofs)
        throw Refused(
            fmt::format("modes of a net with {} free degrees of freedom: give one with at most {}", count, most_mode_dofs));

    SpringMatrix<Dim> stiffness(springs);
    stiffness.add_stiffness(springs, x, SpringCurvature::exact);
    std::vector<Index> place(static_cast<std::size_t>(mass.size()), -1);
    for (Index n = 0; n < count; ++n) place[static_cast<std::size_t>(free[static_cast<std::size_t>(n)])] = n;
    // M^-1/2 K M^-1/2, whose eigenvectors are orthonormal.
    const VecX root = mass.inverse().cwiseSqrt();
    MatX scaled = MatX::Zero(count, count);
    for (Index column = 0; column < count; ++column)
        for (SparseMatrix::InnerIterator entry(stiffness.matrix(), free[static_cast<std::size_t>(column)]); entry; ++entry)
            if (const Index row = place[static_cast<std::size_t>(entry.row())]; row >= 0)
                scaled(row, column) = root[entry.row()] * entry.value() * root[entry.col()];

    SpringModes modes{.omega_squared = VecX(0), .shape = MatX::Zero(mass.size(), count)};
    if (count == 0) return modes;
    const DenseEigen pairs = dense_eigen(scaled);
    modes.omega_squared = pairs.values;
    for (Index n = 0; n < count; ++n) {
        const Index dof = free[static_cast<std::size_t>(n)];
        modes.shape.row(dof) = root[dof] * pairs.vectors.row(n);
    }
    return modes;
}

template SpringModes spring_modes<2>(const Springs&, const DiagonalMass&, PointsIn<2>);
template SpringModes spring_modes<3>(const Springs&, const DiagonalMass&, PointsIn<3>);

}  // namespace pliant
