// The collocated grid: velocity and pressure both at cell centres, with central differences over two cells. It is here for
// comparison with the staggered grid: every second cell does not see its neighbour, so that a checkerboard has neither
// divergence nor gradient [HarlowWelch1965; Bridson2007].
#pragma once
#include <pliant/fluids/lattice.h>
#include <pliant/fluids/pressure_solve.h>

namespace pliant {

// Both take the cell centres of a grid (StaggeredGrid::cells()) with cells of the edge dx, m. At a wall the pressure goes on with
// its last value and the normal velocity mirrors with the opposite sign, so that it is 0 on the wall itself; the divergence is
// then minus the transpose of the gradient, in a box as on periodic axes. Solid cells are not known.

// ∇·u, 1/s: Σ_a (u_a of the next cell − u_a of the one before) / (2Δx). `velocity` has one column per cell.
template <int Dim>
void central_divergence(const Lattice<Dim>& cells, Real dx, const Points<Dim>& velocity, VecX& out);

// ∇p: (p of the next cell − p of the one before) / (2Δx), one column per cell.
template <int Dim>
void central_gradient(const Lattice<Dim>& cells, Real dx, const VecX& p, Points<Dim>& out);

// The pressures of cells whose central gradient is 0, as orthogonal vectors of ±1: the constant, and with every periodic axis of
// an even number of cells the one that alternates along it. 4 on a periodic 8×8 grid, where the staggered grid has 1; a wall
// joins even and odd cells and leaves the constant alone.
template <int Dim>
std::vector<VecX> invisible_pressures(const Lattice<Dim>& cells);

// u = ũ − Δt ∇p with Δt ∇·∇p = ∇·ũ, both differences central, by plain conjugate gradients: `settings.preconditioner` is not
// used. In steps and arrays the same as PressureProjection.
template <int Dim>
class CollocatedProjection {
public:
    // Throws Refused for settings that are out of range.
    CollocatedProjection(const Lattice<Dim>& cells, Real dx, ProjectionSettings settings = {});

    void set(const ProjectionSettings& settings) { solve_.set(settings); }
    void begin(const Points<Dim>& velocity, Real dt);
    bool converged() const { return solve_.converged(); }
    void iterate();
    void apply(Points<Dim>& velocity) const;
    Index project(Points<Dim>& velocity, Real dt);  // returns the number of passes

    Index iterations() const { return solve_.iterations(); }
    Real initial_divergence() const { return solve_.initial_divergence(); }      // 1/s
    Real remaining_divergence() const { return solve_.remaining_divergence(); }  // 1/s

    VecX& pressure() { return solve_.pressure(); }
    const VecX& pressure() const { return solve_.pressure(); }
    VecX& residual() { return solve_.residual(); }
    VecX& direction() { return solve_.direction(); }
    VecX& scalars() { return solve_.scalars(); }

    // y = A x = −Δx² ∇·∇x. Returns x·y.
    Real multiply(const VecX& x, VecX& y) const;

private:
    class Equation;

    Lattice<Dim> cells_;
    Real dx_;
    PressureSolve solve_;
    std::vector<VecX> invisible_;
    mutable Points<Dim> gradient_;  // of one product
};

extern template class CollocatedProjection<2>;
extern template class CollocatedProjection<3>;

}  // namespace pliant
