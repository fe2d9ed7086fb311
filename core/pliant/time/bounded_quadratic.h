// Minimum of a quadratic function of many variables, some of which are fixed or bounded from below: the model of a potential
// that one Newton iteration minimises.
#pragma once
#include <pliant/math/types.h>

#include <memory>
#include <vector>

namespace pliant {

// Minimises 1/2 d . H d + g . d over d >= lower, with d = 0 where `fixed`, by the primal-dual active set method: variables that
// would pass their bound are held on it, those that the bound would have to pull are let go, until nothing changes
// [Hintermueller2003]. Each pass factorises H with the held variables taken out, unless that
// is the matrix of the pass before; the pattern is analysed once.
class BoundedQuadratic {
public:
    explicit BoundedQuadratic(std::vector<char> fixed);
    ~BoundedQuadratic();
    BoundedQuadratic(BoundedQuadratic&&) noexcept;

    // H, symmetric, both triangles stored. The first call sets the pattern, which must hold every diagonal entry and not change.
    void set_matrix(const SparseMatrix& matrix);
    // Adds factor times a matrix of the same pattern, or values to the diagonal.
    void add_matrix(Real factor, const SparseMatrix& matrix) { matrix_.coeffs() += factor * matrix.coeffs(); }
    void add_diagonal(Real factor, const VecX& values);
    const SparseMatrix& matrix() const { return matrix_; }  // H
    Real diagonal(Index d) const { return matrix_.valuePtr()[diagonal_[static_cast<std::size_t>(d)]]; }

    // lower: <= 0, or empty when there are no bounds. The first held set is what the gradient presses onto a bound. Returns false
    // when H is not positive definite on the free variables.
    bool minimise(const VecX& gradient, const VecX& lower, VecX& d);
    // Gradient of the model at the minimum where a bound holds a variable, >= 0; 0 elsewhere.
    const VecX& multiplier() const { return multiplier_; }

    int factorisations() const { return factorisations_; }  // since made; what is the same again needs none

private:
    bool solve_with_held(const VecX& gradient, const VecX& lower, VecX& d);
    bool update_held(const VecX& gradient, const VecX& lower, const VecX& d);
    bool held(Index d) const { return held_[static_cast<std::size_t>(d)]; }
    bool fixed(Index d) const { return fixed_[static_cast<std::size_t>(d)]; }

    std::vector<char> fixed_, held_;
    SparseMatrix matrix_, reduced_;
    std::vector<Index> diagonal_;  // of each column, in the matrix's values
    struct Factor;
    std::unique_ptr<Factor> factor_;
    VecX product_, right_side_, multiplier_;
    int factorisations_ = 0;
};

}  // namespace pliant
