#include <pliant/fluids/grid_transfer.h>
#include <pliant/math/parallel.h>

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
    children_.resize(static_cast<std::size_t>(coarse.rows()));
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
            children_[static_cast<std::size_t>(row.coarse[p] / m_)].emplace_back(static_cast<Index>(rows_.size()), row.weight[p]);
        }
        rows_.push_back(row);
    });
}

template <int Dim>
void GridTransfer<Dim>::expand(const Real* t, Real* fine) const {
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
void GridTransfer<Dim>::compress(const Real* fine, Real* t) const {
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
void GridTransfer<Dim>::make_buffers() {
    while (static_cast<int>(buffers_.size()) < threads()) buffers_.push_back(VecX::Zero(m_ + 2));
}

template <int Dim>
void GridTransfer<Dim>::add_interpolated(const VecX& coarse, VecX& fine) {
    make_buffers();
    parallel_parts(static_cast<Index>(rows_.size()), n_, [&](Index first, Index last, int thread) {
        VecX& buffer = buffers_[static_cast<std::size_t>(thread)];
        auto inner = buffer.segment(1, m_);
        for (Index k = first; k < last; ++k) {
            const Row& row = rows_[static_cast<std::size_t>(k)];
            inner = row.weight[0] * coarse.segment(row.coarse[0], m_);
            for (int p = 1; p < parents; ++p) inner += row.weight[p] * coarse.segment(row.coarse[p], m_);
            buffer[0] = inner[wraps_ ? m_ - 1 : 0];
            buffer[m_ + 1] = inner[wraps_ ? 0 : m_ - 1];
            expand(buffer.data() + 1, fine.data() + row.start);
        }
    });
}

template <int Dim>
void GridTransfer<Dim>::restrict_to(const VecX& fine, VecX& coarse) {
    // Along axis 0 every fine row for itself, then every coarse row from the fine ones in their order.
    compressed_.resize(static_cast<Index>(rows_.size()) * m_);
    parallel_parts(static_cast<Index>(rows_.size()), n_, [&](Index first, Index last, int) {
        for (Index k = first; k < last; ++k)
            compress(fine.data() + rows_[static_cast<std::size_t>(k)].start, compressed_.data() + k * m_);
    });
    coarse.resize(coarse_size_);
    parallel_parts(static_cast<Index>(children_.size()), 2 * n_, [&](Index first, Index last, int) {
        for (Index k = first; k < last; ++k) {
            auto out = coarse.segment(k * m_, m_);
            out.setZero();
            for (const auto& [row, weight] : children_[static_cast<std::size_t>(k)])
                out += weight * compressed_.segment(row * m_, m_);
        }
    });
}

template Lattice<2> coarsened(const Lattice<2>&);
template Lattice<3> coarsened(const Lattice<3>&);
template class GridTransfer<2>;
template class GridTransfer<3>;

}  // namespace pliant
