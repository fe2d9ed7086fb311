// Assembly of element matrices into a sparse one. The pattern is found once; every later assembly only adds numbers.
#pragma once
#include <pliant/math/types.h>

#include <vector>

namespace pliant {

// Dim unknowns per node, `Nodes` nodes per element. Unknown k of node a has number Dim a + k, so that a Dim × nodes matrix in
// memory is the vector of unknowns.
template <int Dim, int Nodes>
class ElementAssembly {
public:
    using Elements = Eigen::Matrix<int, Nodes, Eigen::Dynamic>;  // node numbers, one column per element
    using Local = Mat<Dim * Nodes>;                              // element matrix, block (a, b) at row Dim a, column Dim b

    // Throws Refused when the matrix would have more entries than an int can count.
    ElementAssembly(const Elements& elements, Index node_count);

    // A matrix of zeros with an entry for every pair of unknowns that share an element.
    const SparseMatrix& pattern() const { return pattern_; }

    // Does the element have a node of [first, last)?
    bool touches(Index element, Index first, Index last) const {
        for (int a = 0; a < Nodes; ++a)
            if (elements_(a, element) >= first && elements_(a, element) < last) return true;
        return false;
    }
    // Adds the columns of those nodes alone, all others are left as they are.
    void add(Index element, const Local& local, SparseMatrix& matrix, Index first, Index last) const;
    // Adds the matrix of one element to a matrix that has the pattern. Elements that are added in the same order give the same
    // bits, and symmetric element matrices give a matrix that is symmetric to the bit.
    void add(Index element, const Local& local, SparseMatrix& matrix) const {
        add(element, local, matrix, 0, static_cast<Index>(first_.size()));
    }

private:
    SparseMatrix pattern_;
    Elements elements_;
    std::vector<int> first_;  // per node: index of the first value of its columns
    std::vector<int> rank_;   // per element and pair of its nodes (b, a): place of node a in the columns of node b
};

}  // namespace pliant
