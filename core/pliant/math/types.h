// Numbers, vectors and matrices as the whole project spells them.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <numbers>

namespace pliant {

using Real = double;
using Index = Eigen::Index;

inline constexpr Real one_degree = std::numbers::pi / 180;  // rad

template <int Dim>
using Vec = Eigen::Matrix<Real, Dim, 1>;
template <int Dim>
using Mat = Eigen::Matrix<Real, Dim, Dim>;
using VecX = Eigen::VectorXd;
using MatX = Eigen::MatrixXd;

// One column per point, so that the numbers of a point lie side by side in memory.
template <int Dim>
using Points = Eigen::Matrix<Real, Dim, Eigen::Dynamic>;

// All numbers of a matrix as one column, in their order in memory.
template <class Matrix>
Eigen::Map<VecX> flat(Matrix& points) {
    return {points.data(), points.size()};
}
template <class Matrix>
Eigen::Map<const VecX> flat(const Matrix& points) {
    return {points.data(), points.size()};
}

using SparseMatrix = Eigen::SparseMatrix<Real>;

}  // namespace pliant
