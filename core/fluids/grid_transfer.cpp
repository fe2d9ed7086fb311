#include <pliant/fluids/grid_transfer.h>

namespace pliant {
namespace {

Index half(Index n) { return n > 1 ? (n + 1) / 2 : n; }

// The coarse cell that fine cell i lies in, and the next nearest one.
std::array<Index, 2> parents_along(Index i, Index n, bool periodic) {
    const Index m = half(n);
    if (n == 1) return {0, 0};
    const Index near = i / 2;
    Index far = i % 2 == 0 ? near - 1 : near + 1;
    if (far < 0) far = periodic ? m - 1 : 0;
    if (far >= m) far = periodic ? 0 : m - 1;
    return {near, far};
}

}  // namespace

template <int Dim>
Lattice<Dim> coarsened(const Lattice<Dim>& fine) {
    Lattice<Dim> coarse = fine;
    for (Index& n : coarse.count) n = half(n);
    return coarse;
}

template <int Dim>
GridTransfer<Dim>::GridTransfer(const Lattice<Dim>& fine)
    : n_(fine.count[0]), m_(half(n_)), coarse_size_(coarsened(fine).size()), halves_(n_ > 1), wraps_(fine.periodic(0)) {
    const Lattice<Dim> coarse = coarsened(fine);
    buffer_ = VecX::Zero(m_ + 2);
    for_each_row(fine, [&](Index start, const Counts<Dim>& at) {
        Row row{start, {}, {}};
        for (int p = 0; p < parents; ++p) {
            Counts<Dim> parent{};
            row.weight[p] = 1;
            for (int a = 1; a < Dim; ++a) {
                const int which = (p >> (a - 1)) & 1;
                parent[a] = parents_along(at[a], fine.count[a], fine.periodic(a))[which];
                row.weight[p] *= which == 0 ? 0.75 : 0.25;
            }
            row.coarse[p] = coarse.index(parent);
        }
        rows_.push_back(row);
    });
}

template <int Dim>
void GridTransfer<Dim>::expand(Real* fine) const {
    const Real* t = buffer();
    if (!halves_) {
        fine[0] += t[0];
        return;
    }
    for (Index i = 0; i < n_ / 2; ++i) {
        fine[2 * i] += 0.75 * t[i] + 0.25 * t[i - 1];
        fine[2 * i + 1] += 0.75 * t[i] + 0.25 * t[i + 1];
    }
    if (n_ % 2 == 1) fine[n_ - 1] += 0.75 * t[m_ - 1] + 0.25 * t[m_ - 2];
}

template <int Dim>
void GridTransfer<Dim>::compress(const Real* fine) {
    Real* t = buffer();
    if (!halves_) {
        t[0] = fine[0];
        return;
    }
    const auto at = [&](Index i) { return i >= 0 && i < n_ ? fine[i] : 0; };
    const auto sum = [](Real before, Real first, Real second, Real after) {
        return 0.75 * (first + second) + 0.25 * (before + after);
    };
    t[0] = sum(0, fine[0], fine[1], at(2));
    for (Index i = 1; i < m_ - 1; ++i) t[i] = sum(fine[2 * i - 1], fine[2 * i], fine[2 * i + 1], fine[2 * i + 2]);
    if (m_ > 1) t[m_ - 1] = sum(fine[2 * m_ - 3], fine[2 * m_ - 2], at(2 * m_ - 1), 0);
    // What the interpolation took from beyond the ends goes back to where that came from.
    const Real low = 0.25 * fine[0], high = n_ % 2 == 0 ? 0.25 * fine[n_ - 1] : 0;
    t[wraps_ ? m_ - 1 : 0] += low;
    t[wraps_ ? 0 : m_ - 1] += high;
}

template <int Dim>
void GridTransfer<Dim>::add_interpolated(const VecX& coarse, VecX& fine) {
    auto inner = buffer_.segment(1, m_);
    for (const Row& row : rows_) {
        inner = row.weight[0] * coarse.segment(row.coarse[0], m_);
        for (int p = 1; p < parents; ++p) inner += row.weight[p] * coarse.segment(row.coarse[p], m_);
        buffer_[0] = inner[wraps_ ? m_ - 1 : 0];
        buffer_[m_ + 1] = inner[wraps_ ? 0 : m_ - 1];
        expand(fine.data() + row.start);
    }
}

template <int Dim>
void GridTransfer<Dim>::restrict_to(const VecX& fine, VecX& coarse) {
    coarse.setZero(coarse_size_);
    const auto inner = buffer_.segment(1, m_);
    for (const Row& row : rows_) {
        compress(fine.data() + row.start);
        for (int p = 0; p < parents; ++p) coarse.segment(row.coarse[p], m_) += row.weight[p] * inner;
    }
}

template Lattice<2> coarsened(const Lattice<2>&);
template Lattice<3> coarsened(const Lattice<3>&);
template class GridTransfer<2>;
template class GridTransfer<3>;

}  // namespace pliant
