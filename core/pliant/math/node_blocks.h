// The blocks of a sparse matrix that has Dim unknowns for every node, where each column of a node holds the same nodes.
#pragma once
#include <pliant/math/types.h>

#include <vector>

namespace pliant {

// Works on the values of matrices that have the pattern of ElementAssembly, or another with a Dim × Dim block for every pair of
// nodes. A product reads one index for each block, not for each entry.
template <int Dim>
class NodeBlocks {
public:
    // Throws Refused when the columns of a node differ, or a node has no diagonal block.
    explicit NodeBlocks(const SparseMatrix& pattern);

    Index node_count() const { return static_cast<Index>(diagonal_.size()); }
    void add_at_node(Index node, const Mat<Dim>& block, SparseMatrix& matrix) const;
    Mat<Dim> at_node(Index node, const SparseMatrix& matrix) const;
    // y = A x for a symmetric A, by rows, in several threads; the bits do not depend on how many.
    void multiply(const SparseMatrix& symmetric, const VecX& x, VecX& y) const;

private:
    std::vector<int> diagonal_;  // of each node: place of the diagonal block in a column, counted in blocks
};

}  // namespace pliant
