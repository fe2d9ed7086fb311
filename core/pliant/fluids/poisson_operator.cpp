#include <pliant/fluids/poisson_operator.h>
#include <pliant/math/parallel.h>

namespace pliant {

template <int Dim>
struct WeightedPoisson<Dim>::Stencil {
    const Real* x;                          // the row itself
    const Real* low;                        // weights of its low faces across axis 0
    const Real* beside[Row::beside_count];  // the rows beside it
    const Real* weight[Row::beside_count];  // and the weights of the faces between

    Real across(Index i) const {
        Real sum = weight[0][i] * beside[0][i] + weight[1][i] * beside[1][i];
        if constexpr (Dim == 3) sum += weight[2][i] * beside[2][i] + weight[3][i] * beside[3][i];
        return sum;
    }
    Real inner(Index i) const { return (low[i] * x[i - 1] + low[i + 1] * x[i + 1]) + across(i); }
    // At the first or last sample of a row of n; `wraps` joins its ends.
    Real end(Index i, Index n, bool wraps) const {
        Real sum = across(i);
        if (i > 0)
            sum += low[i] * x[i - 1];
        else if (wraps)
            sum += low[0] * x[n - 1];
        if (i < n - 1)
            sum += low[i + 1] * x[i + 1];
        else if (wraps)
            sum += low[0] * x[0];
        return sum;
    }
};

template <int Dim>
WeightedPoisson<Dim>::WeightedPoisson(const Lattice<Dim>& cells, LowFaceWeights<Dim> weights, VecX surface)
    : n_(cells.count[0]),
      wraps_(cells.periodic(0) && n_ > 1),
      two_coloured_(two_coloured(cells)),
      rows_(lattice_rows(cells)),
      weights_(std::move(weights)),
      diagonal_(surface.size() > 0 ? std::move(surface) : VecX::Zero(cells.size()).eval()),
      inverse_diagonal_(VecX::Zero(cells.size())),
      zeros_(VecX::Zero(n_)) {
    for (int a = 0; a < Dim; ++a) {
        // Along an axis of one cell nothing is coupled, also where the axis closes onto itself.
        if (cells.count[a] == 1) weights_[a].setZero();
        for (Index c = 0; c < cells.size(); ++c) {
            diagonal_[c] += weights_[a][c];
            const Index high = cells.neighbour(cells.coordinates(c), a, 1);
            if (high >= 0) diagonal_[c] += weights_[a][high];
        }
    }
    for (Index c = 0; c < cells.size(); ++c)
        if (diagonal_[c] > 0) inverse_diagonal_[c] = 1 / diagonal_[c];
}

template <int Dim>
typename WeightedPoisson<Dim>::Stencil WeightedPoisson<Dim>::stencil(const Row& row, const Real* x) const {
    Stencil s;
    s.x = x + row.start;
    s.low = weights_[0].data() + row.start;
    for (int k = 0; k < Row::beside_count; ++k) {
        const Index other = row.beside[k];
        s.beside[k] = other >= 0 ? x + other : zeros_.data();
        // The face to the row below is this row's low face, the face to the row above is that row's.
        const Index owner = k % 2 == 0 ? row.start : other;
        s.weight[k] = other >= 0 ? weights_[k / 2 + 1].data() + owner : zeros_.data();
    }
    return s;
}

template <int Dim>
void WeightedPoisson<Dim>::product(const Row& row, const Real* x, Real* y) const {
    const Stencil s = stencil(row, x);
    const Real* d = diagonal_.data() + row.start;
    Real* yr = y + row.start;
    yr[0] = d[0] * s.x[0] - s.end(0, n_, wraps_);
    for (Index i = 1; i < n_ - 1; ++i) yr[i] = d[i] * s.x[i] - s.inner(i);
    if (n_ > 1) yr[n_ - 1] = d[n_ - 1] * s.x[n_ - 1] - s.end(n_ - 1, n_, wraps_);
}

template <int Dim>
Real WeightedPoisson<Dim>::apply(const VecX& x, VecX& y) const {
    y.resize(x.size());
    dots_.resize(static_cast<Index>(rows_.size()));
    parallel_parts(dots_.size(), n_, [&](Index first, Index last, int) {
        for (Index r = first; r < last; ++r) {
            const Row& row = rows_[static_cast<std::size_t>(r)];
            product(row, x.data(), y.data());
            dots_[r] = x.segment(row.start, n_).dot(y.segment(row.start, n_));
        }
    });
    return dots_.sum();
}

template <int Dim>
void WeightedPoisson<Dim>::residual(const VecX& b, const VecX& x, VecX& r) const {
    r.resize(x.size());
    parallel_parts(static_cast<Index>(rows_.size()), n_, [&](Index first, Index last, int) {
        for (Index k = first; k < last; ++k) {
            const Row& row = rows_[static_cast<std::size_t>(k)];
            product(row, x.data(), r.data());
            auto out = r.segment(row.start, n_);
            out = b.segment(row.start, n_) - out;
        }
    });
}

template <int Dim>
void WeightedPoisson<Dim>::relax_row(const Row& row, int colour, bool backward, const VecX& b, VecX& x) const {
    const Stencil s = stencil(row, x.data());
    const Real* br = b.data() + row.start;
    const Real* inverse = inverse_diagonal_.data() + row.start;
    Real* xr = x.data() + row.start;
    const auto relax_at = [&](Index i) {
        const bool at_end = i == 0 || i == n_ - 1;
        if (inverse[i] > 0) xr[i] = (br[i] + (at_end ? s.end(i, n_, wraps_) : s.inner(i))) * inverse[i];
    };
    const Index first = (row.colour & 1) == colour ? 0 : 1;
    const Index count = (n_ - first + 1) / 2;
    for (Index m = 0; m < count; ++m) relax_at(first + 2 * (backward ? count - 1 - m : m));
}

template <int Dim>
void WeightedPoisson<Dim>::relax(const VecX& b, VecX& x, SweepOrder sweep) const {
    const bool backward = sweep == SweepOrder::backward;
    for (int pass = 0; pass < 2; ++pass) {
        const int colour = backward ? 1 - pass : pass;
        parallel_parts(static_cast<Index>(rows_.size()), two_coloured_ ? n_ : 0, [&](Index first, Index last, int) {
            for (Index k = 0; k < last - first; ++k)
                relax_row(rows_[static_cast<std::size_t>(backward ? last - 1 - k : first + k)], colour, backward, b, x);
        });
    }
}

template <int Dim>
LowFaceWeights<Dim> open_faces(const StaggeredGrid<Dim>& grid) {
    const Lattice<Dim>& cells = grid.cells();
    LowFaceWeights<Dim> weights;
    for (int a = 0; a < Dim; ++a) {
        weights[a] = VecX::Ones(cells.size());
        for (const std::vector<Index>* faces : {&grid.closed_faces(a), &grid.surface_faces(a)}) {
            for (Index face : *faces) {
                const Index above = grid.cell_beside(a, face, 1);
                if (above >= 0) weights[a][above] = 0;
            }
        }
    }
    return weights;
}

template <int Dim>
VecX surface_weights(const StaggeredGrid<Dim>& grid, const SurfaceFractions<Dim>& fractions) {
    if (!grid.has_air()) return {};
    VecX weights = VecX::Zero(grid.cells().size());
    for (int a = 0; a < Dim; ++a) {
        const std::vector<Index>& faces = grid.surface_faces(a);
        for (std::size_t k = 0; k < faces.size(); ++k) {
            const Index below = grid.cell_beside(a, faces[k], 0);
            const Index cell = grid.is_fluid(below) ? below : grid.cell_beside(a, faces[k], 1);
            weights[cell] += 1 / fractions[a][static_cast<Index>(k)];
        }
    }
    return weights;
}

template <int Dim>
VecX pressure_diagonal(const StaggeredGrid<Dim>& grid, const SurfaceFractions<Dim>& fractions) {
    const Lattice<Dim>& cells = grid.cells();
    VecX counts = VecX::Zero(cells.size());
    if (grid.has_air()) counts = surface_weights(grid, fractions);
    for (Index c = 0; c < counts.size(); ++c) {
        if (!grid.is_fluid(c)) continue;
        const Counts<Dim> at = cells.coordinates(c);
        for (int k = 0; k < 2 * Dim; ++k) {
            const Index n = cells.neighbour(at, k / 2, k % 2 == 0 ? -1 : 1);
            if (n >= 0 && n != c && grid.is_fluid(n)) counts[c] += 1;
        }
    }
    return counts;
}

template <int Dim>
std::unique_ptr<PoissonOperator<Dim>> pressure_operator(const StaggeredGrid<Dim>& grid, const SurfaceFractions<Dim>& fractions) {
    if (grid.has_gaps())
        return std::make_unique<WeightedPoisson<Dim>>(grid.cells(), open_faces(grid), surface_weights(grid, fractions));
    return std::make_unique<UniformPoisson<Dim>>(grid.cells(), 1);
}

template class WeightedPoisson<2>;
template class WeightedPoisson<3>;
template LowFaceWeights<2> open_faces(const StaggeredGrid<2>&);
template LowFaceWeights<3> open_faces(const StaggeredGrid<3>&);
template VecX surface_weights(const StaggeredGrid<2>&, const SurfaceFractions<2>&);
template VecX surface_weights(const StaggeredGrid<3>&, const SurfaceFractions<3>&);
template VecX pressure_diagonal(const StaggeredGrid<2>&, const SurfaceFractions<2>&);
template VecX pressure_diagonal(const StaggeredGrid<3>&, const SurfaceFractions<3>&);
template std::unique_ptr<PoissonOperator<2>> pressure_operator(const StaggeredGrid<2>&, const SurfaceFractions<2>&);
template std::unique_ptr<PoissonOperator<3>> pressure_operator(const StaggeredGrid<3>&, const SurfaceFractions<3>&);

}  // namespace pliant
