#include <pliant/solids/springs_matrix.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

// For every node, itself and the nodes that springs join it to, in ascending order.
std::vector<std::vector<Index>> neighbours(const Springs& springs) {
    std::vector<std::vector<Index>> rows(static_cast<std::size_t>(springs.node_count()));
    for (Index n = 0; n < springs.node_count(); ++n) rows[static_cast<std::size_t>(n)].push_back(n);
    for (Index s = 0; s < springs.size(); ++s) {
        rows[static_cast<std::size_t>(springs.i(s))].push_back(springs.j(s));
        rows[static_cast<std::size_t>(springs.j(s))].push_back(springs.i(s));
    }
    for (auto& row : rows) std::sort(row.begin(), row.end());
    return rows;
}

std::int32_t rank(const std::vector<Index>& sorted, Index node) {
    return static_cast<std::int32_t>(std::lower_bound(sorted.begin(), sorted.end(), node) - sorted.begin());
}

}  // namespace

template <int Dim>
SpringMatrix<Dim>::SpringMatrix(const Springs& springs) : matrix_(Dim * springs.node_count(), Dim * springs.node_count()) {
    if (matrix_.cols() == 0) return;
    const auto rows = neighbours(springs);
    Eigen::VectorXi entries(matrix_.cols());
    for (Index column = 0; column < matrix_.cols(); ++column)
        entries[column] = static_cast<int>(Dim * rows[static_cast<std::size_t>(column / Dim)].size());
    matrix_.reserve(entries);
    for (Index column = 0; column < matrix_.cols(); ++column)
        for (const Index node : rows[static_cast<std::size_t>(column / Dim)])
            for (int c = 0; c < Dim; ++c) matrix_.insert(Dim * node + c, column) = 0;
    matrix_.makeCompressed();

    for (Index n = 0; n < springs.node_count(); ++n) diagonal_.push_back(rank(rows[static_cast<std::size_t>(n)], n));
    places_.reserve(static_cast<std::size_t>(springs.size()));
    for (Index s = 0; s < springs.size(); ++s) {
        const auto &row_i = rows[static_cast<std::size_t>(springs.i(s))], &row_j = rows[static_cast<std::size_t>(springs.j(s))];
        places_.push_back(
            {rank(row_i, springs.i(s)), rank(row_j, springs.j(s)), rank(row_j, springs.i(s)), rank(row_i, springs.j(s))});
    }
}

template <int Dim>
void SpringMatrix<Dim>::add_block(Index column_node, std::int32_t rank, const Mat<Dim>& block) {
    for (int c = 0; c < Dim; ++c) {
        Real* values = matrix_.valuePtr() + matrix_.outerIndexPtr()[Dim * column_node + c] + Dim * rank;
        for (int r = 0; r < Dim; ++r) values[r] += block(r, c);
    }
}

template <int Dim>
void SpringMatrix<Dim>::add_spring(Index s, Index i, Index j, const Mat<Dim>& block) {
    const Places& places = places_[static_cast<std::size_t>(s)];
    add_block(i, places.ii, block);
    add_block(j, places.jj, block);
    add_block(j, places.ij, -block);
    add_block(i, places.ji, -block);
}

template <int Dim>
void SpringMatrix<Dim>::add_at_node(Index node, const Mat<Dim>& block) {
    add_block(node, diagonal_[static_cast<std::size_t>(node)], block);
}

template <int Dim>
void SpringMatrix<Dim>::add_stiffness(const Springs& springs, PointsIn<Dim> x, SpringCurvature curvature) {
    for (Index s = 0; s < springs.size(); ++s) {
        const Index i = springs.i(s), j = springs.j(s);
        const Real rest = springs.rest_length()[s], k = springs.stiffness()[s];
        const Vec<Dim> x_ij = x.col(j) - x.col(i);
        const Real length = x_ij.norm();
        if (length == 0 && rest > 0) continue;

        const Vec<Dim> n = length > 0 ? Vec<Dim>(x_ij / length) : Vec<Dim>::Zero();
        Real across = rest > 0 ? (length - rest) / length : 1;
        if (curvature == SpringCurvature::positive) across = std::max(across, Real(0));
        const Mat<Dim> along = n * n.transpose();
        add_spring(s, i, j, k * ((1 - across) * along + across * Mat<Dim>::Identity()));
    }
}

template <int Dim>
void SpringMatrix<Dim>::add_damping(const Springs& springs, SpringDamping mode, PointsIn<Dim> x, Real factor) {
    if (mode == SpringDamping::none) return;
    for (Index s = 0; s < springs.size(); ++s) {
        const Index i = springs.i(s), j = springs.j(s);
        Mat<Dim> block = Mat<Dim>::Identity();
        if (mode == SpringDamping::projected) {
            const Vec<Dim> x_ij = x.col(j) - x.col(i);
            const Real length_squared = x_ij.squaredNorm();
            if (length_squared == 0) continue;
            block = (x_ij * x_ij.transpose()) / length_squared;
        }
        add_spring(s, i, j, factor * springs.damping()[s] * block);
    }
}

template class SpringMatrix<2>;
template class SpringMatrix<3>;

}  // namespace pliant
