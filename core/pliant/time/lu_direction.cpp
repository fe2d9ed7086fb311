#include <pliant/time/lu_direction.h>

#include <Eigen/SparseLU>

namespace pliant {

struct LuDirection::Factor {
    Eigen::SparseLU<SparseMatrix> lu;
};

LuDirection::LuDirection() : factor_(std::make_unique<Factor>()) {}
LuDirection::~LuDirection() = default;

bool LuDirection::solve(const SparseMatrix& stiffness, Real rate, const Mass& mass, const VecX& residual, VecX& d) {
    const bool first = matrix_.rows() == 0;
    matrix_ = stiffness;
    if (mass.matrix()) matrix_ += rate * *mass.matrix();
    matrix_.makeCompressed();
    // A fixed degree of freedom keeps its diagonal alone.
    for (Index column = 0; column < matrix_.cols(); ++column)
        for (SparseMatrix::InnerIterator entry(matrix_, column); entry; ++entry) {
            const bool diagonal = entry.row() == column, held = mass.fixed(entry.row()) || mass.fixed(column);
            if (held)
                entry.valueRef() = diagonal ? 1 : 0;
            else if (diagonal && !mass.matrix())
                entry.valueRef() += rate * mass.diagonal()[column];
        }
    if (first) factor_->lu.analyzePattern(matrix_);
    factor_->lu.factorize(matrix_);
    if (factor_->lu.info() != Eigen::Success) return false;
    d = -residual;
    for (Index n = 0; n < d.size(); ++n)
        if (mass.fixed(n)) d[n] = 0;
    d = factor_->lu.solve(d);
    return d.allFinite();
}

}  // namespace pliant
