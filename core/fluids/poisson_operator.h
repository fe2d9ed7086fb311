// The pressure equation of one grid level: A p = b with (A p)_c = Σ w (p_c − p_n) over the faces of cell c. On the finest level
// w is 1 on open faces and 0 on closed ones, and A = −Δx² ∇² with ∂p/∂n = 0 at walls and solids [Bridson2007 §4.3].
#pragma once
#include <pliant/fluids/box_laplacian.h>
#include <pliant/fluids/staggered_grid.h>

#include <memory>

namespace pliant {

template <int Dim>
class PoissonOperator {
public:
    virtual ~PoissonOperator() = default;

    // y = A x. Returns x·y.
    virtual Real apply(const VecX& x, VecX& y) const = 0;
    // r = b − A x.
    virtual void residual(const VecX& b, const VecX& x, VecX& r) const = 0;
    // One red-black Gauss-Seidel sweep of A x = b; cells without an open face keep their value.
    virtual void relax(const VecX& b, VecX& x, SweepOrder sweep) const = 0;
};

// All faces inside the box have the same weight: a box without solids.
template <int Dim>
class UniformPoisson final : public PoissonOperator<Dim> {
public:
    UniformPoisson(const Lattice<Dim>& cells, Real weight) : laplacian_(cells), weight_(weight) {}
    Real apply(const VecX& x, VecX& y) const override { return laplacian_.apply(x, 0, weight_, y); }
    void residual(const VecX& b, const VecX& x, VecX& r) const override { laplacian_.residual(b, x, 0, weight_, r); }
    void relax(const VecX& b, VecX& x, SweepOrder sweep) const override { laplacian_.relax(b, weight_, x, sweep); }

private:
    BoxLaplacian<Dim> laplacian_;
    Real weight_;
};

// The weight of the low face of every cell across each axis, one array of cells per axis; 0 on a wall.
template <int Dim>
using LowFaceWeights = AxisArrays<Dim>;

// Every face has a weight of its own.
template <int Dim>
class WeightedPoisson final : public PoissonOperator<Dim> {
public:
    WeightedPoisson(const Lattice<Dim>& cells, LowFaceWeights<Dim> weights);
    Real apply(const VecX& x, VecX& y) const override;
    void residual(const VecX& b, const VecX& x, VecX& r) const override;
    void relax(const VecX& b, VecX& x, SweepOrder sweep) const override;

    // Sum of the weights of a cell's faces; 0 where no equation is to be solved.
    const VecX& diagonal() const { return diagonal_; }

private:
    using Row = LatticeRow<Dim>;
    struct Stencil;

    Stencil stencil(const Row& row, const Real* x) const;
    void product(const Row& row, const Real* x, Real* y) const;

    Index n_;
    bool wraps_;
    std::vector<Row> rows_;
    LowFaceWeights<Dim> weights_;
    VecX diagonal_, inverse_diagonal_;
    VecX zeros_;  // stands for a row beyond a wall
};

// 1 on the low faces of the cells that are open, 0 on those that are closed.
template <int Dim>
LowFaceWeights<Dim> open_faces(const StaggeredGrid<Dim>& grid);

// The number of open faces of every cell to another: the diagonal of A on the finest level. Solid cells have none.
template <int Dim>
VecX open_face_counts(const StaggeredGrid<Dim>& grid);

// A of the finest level.
template <int Dim>
std::unique_ptr<PoissonOperator<Dim>> pressure_operator(const StaggeredGrid<Dim>& grid);

extern template class WeightedPoisson<2>;
extern template class WeightedPoisson<3>;

}  // namespace pliant
