// Numbers, vectors and matrices as the whole project spells them.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace pliant {

using Real = double;
using Index = Eigen::Index;

template <int Dim>
using Vec = Eigen::Matrix<Real, Dim, 1>;
template <int Dim>
using Mat = Eigen::Matrix<Real, Dim, Dim>;
using VecX = Eigen::VectorXd;
using MatX = Eigen::MatrixXd;

// One column per point, so that the numbers of a point lie side by side in memory.
template <int Dim>
using Points = Eigen::Matrix<Real, Dim, Eigen::Dynamic>;

using SparseMatrix = Eigen::SparseMatrix<Real>;

}  // namespace pliant
