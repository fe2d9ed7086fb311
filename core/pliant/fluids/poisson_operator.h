// The pressure equation of one grid level: A p = b with (A p)_c = Σ w (p_c − p_n) + s p_c over the faces of cell c. On the
// finest level w is 1 between fluid and fluid and 0 elsewhere, and s is 1/θ for each neighbour of air, where p = 0 lies at the
// part θ of the way to its centre: A = −Δx² ∇² with ∂p/∂n = 0 at walls and solids [Bridson2007 §4.3] and p = 0 at the surface
// [Gibou2002 §2].
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
    // surface: the s of each cell; empty: 0 everywhere.
    WeightedPoisson(const Lattice<Dim>& cells, LowFaceWeights<Dim> weights, VecX surface = {});
    Real apply(const VecX& x, VecX& y) const override;
    void residual(const VecX& b, const VecX& x, VecX& r) const override;
    void relax(const VecX& b, VecX& x, SweepOrder sweep) const override;

    // Sum of the weights of a cell's faces and of s; 0 where no equation is to be solved.
    const VecX& diagonal() const { return diagonal_; }

private:
    using Row = LatticeRow<Dim>;
    struct Stencil;

    Stencil stencil(const Row& row, const Real* x) const;
    void product(const Row& row, const Real* x, Real* y) const;
    void relax_row(const Row& row, int colour, bool backward, const VecX& b, VecX& x) const;

    Index n_;
    bool wraps_, two_coloured_;
    mutable VecX dots_;  // by row
    std::vector<Row> rows_;
    LowFaceWeights<Dim> weights_;
    VecX diagonal_, inverse_diagonal_;
    VecX zeros_;  // stands for a row beyond a wall
};

// 1 on the low faces of the cells between fluid and fluid, 0 on the others.
template <int Dim>
LowFaceWeights<Dim> open_faces(const StaggeredGrid<Dim>& grid);

// s of every cell, Σ 1/θ over its neighbours of air; empty where the grid has no air.
template <int Dim>
VecX surface_weights(const StaggeredGrid<Dim>& grid, const SurfaceFractions<Dim>& fractions);

// The diagonal of A on the finest level: the number of fluid neighbours of every cell, and s; 0 in cells without fluid.
template <int Dim>
VecX pressure_diagonal(const StaggeredGrid<Dim>& grid, const SurfaceFractions<Dim>& fractions = {});

// A of the finest level.
template <int Dim>
std::unique_ptr<PoissonOperator<Dim>> pressure_operator(const StaggeredGrid<Dim>& grid,
                                                        const SurfaceFractions<Dim>& fractions = {});

extern template class WeightedPoisson<2>;
extern template class WeightedPoisson<3>;

}  // namespace pliant
