// Interpolation of cell-centred corrections from a coarse grid to one of twice the resolution, and its transpose.
#pragma once
#include <pliant/fluids/lattice.h>

#include <utility>
#include <vector>

namespace pliant {

// Cells are merged in pairs along every axis of more than one cell; the last coarse cell of an odd axis covers one fine cell.
template <int Dim>
Lattice<Dim> coarsened(const Lattice<Dim>& fine);

// Multilinear interpolation between cell centres: along each axis a fine cell takes 3/4 of the coarse cell that it lies in and
// 1/4 of the next nearest; beyond a wall that is the same cell again.
template <int Dim>
class GridTransfer {
public:
    explicit GridTransfer(const Lattice<Dim>& fine);

    // fine += P coarse.
    void add_interpolated(const VecX& coarse, VecX& fine);
    // coarse = Pᵀ fine.
    void restrict_to(const VecX& fine, VecX& coarse);

private:
    static constexpr int parents = 1 << (Dim - 1);
    // The coarse rows that a fine row takes from.
    struct Row {
        Index start;
        std::array<Index, parents> coarse;
        std::array<Real, parents> weight;
    };

    void expand(const Real* t, Real* fine) const;    // fine row += interpolation of the coarse row t along axis 0
    void compress(const Real* fine, Real* t) const;  // t = transpose of that
    void make_buffers();

    Index n_, m_, coarse_size_;  // fine and coarse cells along axis 0, coarse cells in all
    bool halves_, wraps_;        // along axis 0
    std::vector<Row> rows_;
    std::vector<std::vector<std::pair<Index, Real>>> children_;  // the fine rows that a coarse row gives to, and its weight there
    std::vector<VecX> buffers_;                                  // one coarse row with a cell beyond each end, by thread
    VecX compressed_;                                            // the fine rows, coarsened along axis 0
};

extern template Lattice<2> coarsened(const Lattice<2>&);
extern template Lattice<3> coarsened(const Lattice<3>&);
extern template class GridTransfer<2>;
extern template class GridTransfer<3>;

}  // namespace pliant
