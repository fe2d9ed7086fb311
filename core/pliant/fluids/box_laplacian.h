// The 5-point (7-point) Laplacian on a box of samples, matrix-free.
#pragma once
#include <pliant/fluids/lattice_rows.h>

namespace pliant {

enum class SweepOrder { forward, backward };

// A = −Δx² ∇², symmetric: (A x)_c = d_c x_c − Σ x_n over the neighbours n of c. A neighbour adds 1 to d_c, a side with
// zero_gradient nothing, and a side with wall_value 2, since beyond it lies the linear continuation 2·value − x_c; the term
// 2·value belongs to the right-hand side, see wall_terms(). Samples that a side holds are treated as if the lattice ended
// with zero gradient there: what they are is the caller's business.
template <int Dim>
class BoxLaplacian {
public:
    explicit BoxLaplacian(const Lattice<Dim>& lattice);

    Index size() const { return size_; }

    // y = shift x + scale A x. Returns x·y.
    Real apply(const VecX& x, Real shift, Real scale, VecX& y) const;

    // r = b − (shift x + scale A x).
    void residual(const VecX& b, const VecX& x, Real shift, Real scale, VecX& r) const;

    // One Gauss-Seidel sweep of scale A x = b: red samples, then black ones; backward in the opposite order, its transpose.
    void relax(const VecX& b, Real scale, VecX& x, SweepOrder sweep) const;

    // y += scale · 2·value at the samples next to a side with wall_value.
    void add_wall_terms(Real scale, VecX& y) const;

private:
    using Row = LatticeRow<Dim>;
    struct Beside;  // the rows of one vector beside a row

    Beside beside(const Row& row, const Real* x) const;
    void product(const Row& row, Real across_diagonal, const Real* x, Real shift, Real scale, Real* y) const;
    void relax_row(const Row& row, Real across_diagonal, int colour, bool backward, Real inverse_scale, const Real* b,
                   Real* x) const;
    Real along_end(const Real* x, bool high) const;

    Index size_, n_;        // samples in all and along axis 0
    bool wraps_;            // along axis 0
    Real end_diagonal_[2];  // what axis 0 adds to d at the first and at the last sample of a row
    bool two_coloured_;     // red samples have black neighbours: not around a periodic axis of an odd number
    std::vector<Row> rows_;
    mutable VecX dots_;                  // by row
    std::vector<Real> across_diagonal_;  // what the other axes add to d, by row
    std::vector<Real> zeros_;            // stands for a row beyond a wall
    std::vector<std::pair<Index, Real>> wall_terms_;
};

extern template class BoxLaplacian<2>;
extern template class BoxLaplacian<3>;

}  // namespace pliant
