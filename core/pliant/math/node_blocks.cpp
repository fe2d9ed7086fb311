#include <pliant/math/error.h>
#include <pliant/math/node_blocks.h>
#include <pliant/math/parallel.h>

#include <algorithm>

#include <fmt/format.h>

namespace pliant {

template <int Dim>
NodeBlocks<Dim>::NodeBlocks(const SparseMatrix& pattern) {
    const int *begin = pattern.outerIndexPtr(), *row = pattern.innerIndexPtr();
    for (int n = 0; n < pattern.cols() / Dim; ++n) {
        const int first = begin[Dim * n], size = begin[Dim * n + 1] - first;
        const int place = static_cast<int>(std::lower_bound(row + first, row + first + size, Dim * n) - (row + first));
        bool sound = size % Dim == 0 && place % Dim == 0 && place < size && row[first + place] == Dim * n;
        for (int l = 1; l < Dim; ++l)
            sound = sound && begin[Dim * n + l + 1] - begin[Dim * n + l] == size &&
                    std::equal(row + first, row + first + size, row + begin[Dim * n + l]);
        if (!sound) throw Refused(fmt::format("the matrix has no blocks of {} × {} unknowns at node {}", Dim, Dim, n));
        diagonal_.push_back(place / Dim);
    }
}

template <int Dim>
void NodeBlocks<Dim>::add_at_node(Index node, const Mat<Dim>& block, SparseMatrix& matrix) const {
    for (int l = 0; l < Dim; ++l) {
        Real* values =
            matrix.valuePtr() + matrix.outerIndexPtr()[Dim * node + l] + Dim * diagonal_[static_cast<std::size_t>(node)];
        for (int k = 0; k < Dim; ++k) values[k] += block(k, l);
    }
}

template <int Dim>
Mat<Dim> NodeBlocks<Dim>::at_node(Index node, const SparseMatrix& matrix) const {
    Mat<Dim> block;
    for (int l = 0; l < Dim; ++l) {
        const Index place = matrix.outerIndexPtr()[Dim * node + l] + Dim * diagonal_[static_cast<std::size_t>(node)];
        for (int k = 0; k < Dim; ++k) block(k, l) = matrix.valuePtr()[place + k];
    }
    return block;
}

// Columns are rows of a symmetric matrix.
template <int Dim>
void NodeBlocks<Dim>::multiply(const SparseMatrix& symmetric, const VecX& x, VecX& y) const {
    const int *begin = symmetric.outerIndexPtr(), *row = symmetric.innerIndexPtr();
    const Real *values = symmetric.valuePtr(), *from = x.data();
    parallel_parts(node_count(), 16 * Dim * Dim, [&](Index first, Index last, int) {
        for (Index n = first; n < last; ++n) {
            const Index start = begin[Dim * n], size = begin[Dim * n + 1] - start;
            // A sum for each pair of components, so that none waits for another.
            Mat<Dim> sums = Mat<Dim>::Zero();
            const Real* entry = values + start;
            for (Index i = 0; i < size; i += Dim, entry += Dim) {
                const Eigen::Map<const Vec<Dim>> at(from + row[start + i]);
                for (int l = 0; l < Dim; ++l) sums.col(l) += Eigen::Map<const Vec<Dim>>(entry + l * size).cwiseProduct(at);
            }
            for (int l = 0; l < Dim; ++l) y[Dim * n + l] = sums.col(l).sum();
        }
    });
}

template class NodeBlocks<2>;
template class NodeBlocks<3>;

}  // namespace pliant
