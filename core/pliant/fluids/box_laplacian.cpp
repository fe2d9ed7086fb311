#include <pliant/fluids/box_laplacian.h>
#include <pliant/math/parallel.h>

namespace pliant {
namespace {

using ConstRow = Eigen::Map<const Eigen::Array<Real, Eigen::Dynamic, 1>>;
using MutableRow = Eigen::Map<Eigen::Array<Real, Eigen::Dynamic, 1>>;

// What a missing neighbour adds to the diagonal.
Real diagonal_beyond(Beyond beyond) { return beyond == Beyond::wall_value ? 2 : 0; }

}  // namespace

template <int Dim>
struct BoxLaplacian<Dim>::Beside {
    const Real* row[Row::beside_count];

    Real sum(Index i) const {
        if constexpr (Dim == 2)
            return row[0][i] + row[1][i];
        else
            return (row[0][i] + row[1][i]) + (row[2][i] + row[3][i]);
    }
    // The sum over samples first to first + n − 1 as an expression, which Eigen evaluates several samples at a time.
    auto sum(Index first, Index n) const {
        if constexpr (Dim == 2)
            return ConstRow(row[0] + first, n) + ConstRow(row[1] + first, n);
        else
            return (ConstRow(row[0] + first, n) + ConstRow(row[1] + first, n)) +
                   (ConstRow(row[2] + first, n) + ConstRow(row[3] + first, n));
    }
};

template <int Dim>
BoxLaplacian<Dim>::BoxLaplacian(const Lattice<Dim>& lattice)
    : size_(lattice.size()),
      n_(lattice.count[0]),
      wraps_(lattice.periodic(0) && n_ > 1),
      two_coloured_(two_coloured(lattice)),
      rows_(lattice_rows(lattice)),
      zeros_(static_cast<std::size_t>(n_), Real(0)) {
    const auto& ends = lattice.sides[0];
    for (int side = 0; side < 2; ++side)
        end_diagonal_[side] = (wraps_ ? 1 : diagonal_beyond(ends[side].beyond)) + (n_ > 1 ? 1 : 0);
    if (n_ == 1) end_diagonal_[0] = end_diagonal_[1] = end_diagonal_[0] + end_diagonal_[1];
    for (const Row& row : rows_) {
        Real diagonal = 0;
        for (int k = 0; k < Row::beside_count; ++k) diagonal += row.beside[k] >= 0 ? 1 : diagonal_beyond(row.beyond[k]);
        across_diagonal_.push_back(diagonal);
        // Terms of the walls beside this row, and of those at its two ends.
        for (int k = 0; k < Row::beside_count; ++k) {
            const LatticeSide& side = lattice.sides[k / 2 + 1][k % 2];
            if (row.beside[k] < 0 && side.beyond == Beyond::wall_value && side.value != 0)
                for (Index i = 0; i < n_; ++i) wall_terms_.emplace_back(row.start + i, 2 * side.value);
        }
        for (int side = 0; side < 2; ++side)
            if (ends[side].beyond == Beyond::wall_value && ends[side].value != 0)
                wall_terms_.emplace_back(row.start + (side == 0 ? 0 : n_ - 1), 2 * ends[side].value);
    }
}

template <int Dim>
typename BoxLaplacian<Dim>::Beside BoxLaplacian<Dim>::beside(const Row& row, const Real* x) const {
    Beside rows;
    for (int k = 0; k < Row::beside_count; ++k) rows.row[k] = row.beside[k] >= 0 ? x + row.beside[k] : zeros_.data();
    return rows;
}

// Sum of the neighbours along axis 0 of a row's first or last sample; x points at the row.
template <int Dim>
Real BoxLaplacian<Dim>::along_end(const Real* x, bool high) const {
    if (n_ == 1) return 0;
    const Real inner = high ? x[n_ - 2] : x[1];
    return wraps_ ? inner + (high ? x[0] : x[n_ - 1]) : inner;
}

template <int Dim>
void BoxLaplacian<Dim>::product(const Row& row, Real across_diagonal, const Real* x, Real shift, Real scale, Real* y) const {
    const Beside rows = beside(row, x);
    const Real* xr = x + row.start;
    Real* yr = y + row.start;
    for (int side = 0; side < 2; ++side) {
        const Index i = side == 0 ? 0 : n_ - 1;
        const Real diagonal = shift + scale * (end_diagonal_[side] + across_diagonal);
        yr[i] = diagonal * xr[i] - scale * (along_end(xr, side == 1) + rows.sum(i));
    }
    const Index inner = n_ - 2;
    if (inner <= 0) return;
    const Real diagonal = shift + scale * (2 + across_diagonal);
    const auto along = ConstRow(xr, inner) + ConstRow(xr + 2, inner);
    MutableRow(yr + 1, inner) = diagonal * ConstRow(xr + 1, inner) - scale * (along + rows.sum(1, inner));
}

template <int Dim>
Real BoxLaplacian<Dim>::apply(const VecX& x, Real shift, Real scale, VecX& y) const {
    y.resize(size_);
    dots_.resize(static_cast<Index>(rows_.size()));
    parallel_parts(dots_.size(), n_, [&](Index first, Index last, int) {
        for (Index r = first; r < last; ++r) {
            const Row& row = rows_[static_cast<std::size_t>(r)];
            product(row, across_diagonal_[static_cast<std::size_t>(r)], x.data(), shift, scale, y.data());
            dots_[r] = x.segment(row.start, n_).dot(y.segment(row.start, n_));
        }
    });
    return dots_.sum();
}

template <int Dim>
void BoxLaplacian<Dim>::residual(const VecX& b, const VecX& x, Real shift, Real scale, VecX& r) const {
    r.resize(size_);
    parallel_parts(static_cast<Index>(rows_.size()), n_, [&](Index first, Index last, int) {
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
            product(rows_[k], across_diagonal_[k], x.data(), shift, scale, r.data());
            auto row = r.segment(rows_[k].start, n_);
            row = b.segment(rows_[k].start, n_) - row;
        }
    });
}

template <int Dim>
void BoxLaplacian<Dim>::relax_row(const Row& row, Real across_diagonal, int colour, bool backward, Real inverse_scale,
                                  const Real* b, Real* x) const {
    const Beside rows = beside(row, x);
    Real* xr = x + row.start;
    const Real* br = b + row.start;
    const auto relax_end = [&](bool high) {
        const Index i = high ? n_ - 1 : 0;
        const Real diagonal = end_diagonal_[high ? 1 : 0] + across_diagonal;
        if (((i + row.colour) & 1) == colour && diagonal > 0)
            xr[i] = (inverse_scale * br[i] + along_end(xr, high) + rows.sum(i)) / diagonal;
    };
    const Real inverse = 1 / (2 + across_diagonal);
    const auto relax_inner = [&](Index i) { xr[i] = (inverse_scale * br[i] + (xr[i - 1] + xr[i + 1]) + rows.sum(i)) * inverse; };
    const Index first = ((1 + row.colour) & 1) == colour ? 1 : 2;
    if (!backward) {
        relax_end(false);
        for (Index i = first; i < n_ - 1; i += 2) relax_inner(i);
        if (n_ > 1) relax_end(true);
    } else {
        if (n_ > 1) relax_end(true);
        const Index last = (n_ - 2 - first) & 1 ? n_ - 3 : n_ - 2;
        for (Index i = last; i >= first; i -= 2) relax_inner(i);
        relax_end(false);
    }
}

template <int Dim>
void BoxLaplacian<Dim>::relax(const VecX& b, Real scale, VecX& x, SweepOrder sweep) const {
    const bool backward = sweep == SweepOrder::backward;
    for (int pass = 0; pass < 2; ++pass) {
        const int colour = backward ? 1 - pass : pass;
        // Samples of one colour take from the other colour alone, so that their order makes no difference.
        parallel_parts(static_cast<Index>(rows_.size()), two_coloured_ ? n_ : 0, [&](Index first, Index last, int) {
            for (Index k = 0; k < last - first; ++k) {
                const auto r = static_cast<std::size_t>(backward ? last - 1 - k : first + k);
                relax_row(rows_[r], across_diagonal_[r], colour, backward, 1 / scale, b.data(), x.data());
            }
        });
    }
}

template <int Dim>
void BoxLaplacian<Dim>::add_wall_terms(Real scale, VecX& y) const {
    for (const auto& [index, term] : wall_terms_) y[index] += scale * term;
}

template class BoxLaplacian<2>;
template class BoxLaplacian<3>;

}  // namespace pliant
