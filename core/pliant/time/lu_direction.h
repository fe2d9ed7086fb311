// Newton's direction where the matrix need not be symmetric.
#pragma once
#include <pliant/time/mass.h>

#include <memory>

namespace pliant {

// Solves J d = -r by an LU factorisation, with d = 0 where a degree of freedom is fixed. The pattern is analysed once.
class LuDirection {
public:
    LuDirection();
    ~LuDirection();

    // J is K + rate M with K of any symmetry, whose pattern never changes and holds every diagonal entry. Returns false when J is
    // singular.
    bool solve(const SparseMatrix& stiffness, Real rate, const Mass& mass, const VecX& residual, VecX& d);
    // Of the latest matrix, N/m.
    const SparseMatrix& matrix() const { return matrix_; }

private:
    SparseMatrix matrix_;
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

}  // namespace pliant
