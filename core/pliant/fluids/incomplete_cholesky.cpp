#include <pliant/fluids/incomplete_cholesky.h>
#include <pliant/math/error.h>

#include <algorithm>

namespace pliant {
namespace {

constexpr Real smallest_pivot = 0.25;  // of the diagonal

// The fluid neighbours of a cell that come later in memory, each with the number of faces between.
struct Later {
    Index cell;
    Real faces;
};
template <int Dim>
std::vector<Later> later_neighbours(const StaggeredGrid<Dim>& grid, Index cell) {
    std::vector<Later> later;
    const Lattice<Dim>& cells = grid.cells();
    for (int k = 0; k < 2 * Dim; ++k) {
        const Index n = cells.neighbour(cells.coordinates(cell), k / 2, k % 2 == 0 ? -1 : 1);
        if (n <= cell || !grid.is_fluid(n)) continue;
        const auto known = std::ranges::find(later, n, &Later::cell);
        if (known != later.end())
            known->faces += 1;  // a periodic axis of two cells
        else
            later.push_back({n, 1});
    }
    return later;
}

}  // namespace

template <int Dim>
IncompleteCholesky<Dim>::IncompleteCholesky(const StaggeredGrid<Dim>& grid, const SurfaceFractions<Dim>& fractions, Real modified)
    : n_(grid.cells().count[0]),
      wraps_(grid.periodic(0) && n_ > 1),
      rows_(lattice_rows(grid.cells())),
      inverse_pivot_(VecX::Zero(grid.cells().size())),
      above_(n_) {
    if (!(modified >= 0 && modified <= 1)) throw Refused("modified", modified, "", "a share between 0 and 1");
    find_pivots(grid, pressure_diagonal(grid, fractions), modified);
}

template <int Dim>
void IncompleteCholesky<Dim>::find_pivots(const StaggeredGrid<Dim>& grid, VecX pivot, Real modified) {
    const VecX diagonal = pivot;
    for (Index c = 0; c < pivot.size(); ++c) {
        if (diagonal[c] == 0) continue;
        if (pivot[c] < smallest_pivot * diagonal[c]) pivot[c] = diagonal[c];
        inverse_pivot_[c] = 1 / pivot[c];
        // What eliminating this cell takes from the diagonals of its later neighbours, and would put between them.
        const std::vector<Later> later = later_neighbours(grid, c);
        Real all = 0;
        for (const Later& n : later) all += n.faces;
        for (const Later& n : later) pivot[n.cell] -= n.faces * (n.faces + modified * (all - n.faces)) * inverse_pivot_[c];
    }
}

template <int Dim>
void IncompleteCholesky<Dim>::precondition(const VecX& r, VecX& z) {
    z.resize(r.size());
    for (const Row& row : rows_) substitute_forward(row, r.data(), z.data());
    for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) substitute_backward(*row, z.data());
}

// (E + L) y = r, from the first cell of the row to the last; z holds y.
template <int Dim>
void IncompleteCholesky<Dim>::substitute_forward(const Row& row, const Real* r, Real* z) const {
    const auto part = [this](const auto* from, Index start) { return Eigen::Map<const VecX>(from + start, n_); };
    const Real* e = inverse_pivot_.data() + row.start;
    Real* y = z + row.start;
    Eigen::Map<VecX> sum(y, n_);
    sum = part(r, row.start);
    for (const Index beside : row.beside)
        if (beside >= 0 && beside < row.start) sum += part(z, beside);
    sum.array() *= part(inverse_pivot_.data(), row.start).array();
    const Index last = n_ - 1;
    for (Index i = 1; i <= last; ++i) y[i] += e[i] * y[i - 1];
    if (wraps_) y[last] += e[last] * y[0];
}

// (I + E⁻¹ Lᵀ) z = y, from the last cell of the row to the first.
template <int Dim>
void IncompleteCholesky<Dim>::substitute_backward(const Row& row, Real* z) {
    const Real* e = inverse_pivot_.data() + row.start;
    Real* x = z + row.start;
    above_.setZero();
    for (const Index beside : row.beside)
        if (beside > row.start) above_ += Eigen::Map<const VecX>(z + beside, n_);
    Eigen::Map<VecX>(x, n_).array() += Eigen::Map<const VecX>(e, n_).array() * above_.array();
    const Index last = n_ - 1;
    for (Index i = last - 1; i >= 0; --i) x[i] += e[i] * x[i + 1];
    if (wraps_) x[0] += e[0] * x[last];
}

template class IncompleteCholesky<2>;
template class IncompleteCholesky<3>;

}  // namespace pliant
