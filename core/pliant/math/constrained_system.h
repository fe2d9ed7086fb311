// A symmetric linear system in which some unknowns are prescribed: they are removed from rows and columns alike, so that what is
// left to solve is symmetric too [Hughes2000 §1.6].
#pragma once
#include <pliant/math/types.h>

#include <vector>

namespace pliant {

class ConstrainedSystem {
public:
    // prescribed: one flag per unknown. The pattern of the reduced matrix is found here, once.
    ConstrainedSystem(const SparseMatrix& full, const std::vector<char>& prescribed);

    // Takes the values anew from a matrix with the same pattern.
    void update(const SparseMatrix& full);

    const SparseMatrix& matrix() const { return matrix_; }  // free × free
    Index size() const { return static_cast<Index>(free_.size()); }
    const std::vector<int>& free() const { return free_; }  // numbers of the free unknowns, ascending

    // Free entries of a full vector; and a full vector's free entries set, the prescribed ones left as they are.
    void reduce(const VecX& full, VecX& reduced) const;
    void expand(const VecX& reduced, VecX& full) const;

private:
    std::vector<int> free_;
    SparseMatrix matrix_;
    std::vector<int> source_;  // per entry of matrix_: index of its value in the full matrix
};

}  // namespace pliant
