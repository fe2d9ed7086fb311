// A multigrid V-cycle for the pressure equation, symmetric so that it can precondition conjugate gradients
// [McAdamsSifakisTeran2010 §3-4].
#pragma once
#include <pliant/fluids/grid_transfer.h>
#include <pliant/fluids/preconditioner.h>

namespace pliant {

// Any number of cells along each axis, walls or periodic, with or without solid cells. Each level halves the number of cells
// along every axis of more than one; a coarse face weighs the sum of the fine faces that it covers over the coarsening
// factor, which is A of the coarse grid in the units of the fine one.
template <int Dim>
class Multigrid final : public Preconditioner<Dim> {
public:
    // fractions: of the grid's surface, if it has air.
    explicit Multigrid(const StaggeredGrid<Dim>& grid, const SurfaceFractions<Dim>& fractions = {});

    // The equation of the finest level.
    const PoissonOperator<Dim>& finest() const { return *levels_.front().op; }
    int levels() const { return static_cast<int>(levels_.size()); }

    // z ≈ A⁻¹ r by one V-cycle from z = 0: a forward sweep on the way down and its transpose on the way up.
    void precondition(const VecX& r, VecX& z) override;

private:
    struct Level {
        Lattice<Dim> cells;
        std::unique_ptr<PoissonOperator<Dim>> op;
        std::unique_ptr<GridTransfer<Dim>> transfer;  // to the next level; none on the coarsest
        VecX share;    // 1 / sum of the interpolation weights of a cell's active parents, 0 for an inactive cell; empty: all 1
        VecX b, x, r;  // b and x are unused on the finest level
    };

    void add_level(const Lattice<Dim>& cells, std::unique_ptr<PoissonOperator<Dim>> op);
    void share_among_active(Level& fine, const VecX& fine_diagonal, const VecX& coarse_diagonal);
    void cycle(std::size_t level, const VecX& b, VecX& x);

    std::vector<Level> levels_;
};

extern template class Multigrid<2>;
extern template class Multigrid<3>;

}  // namespace pliant
