#include <pliant/fluids/padded_field.h>
#include <pliant/fluids/parallel_rows.h>

namespace pliant {

template <int Dim>
PaddedField<Dim>::PaddedField(const Lattice<Dim>& lattice, Interpolation interpolation)
    : lattice_(lattice), margin_(interpolation == Interpolation::linear ? 1 : 2) {
    Index size = 1;
    for (int a = 0; a < Dim; ++a) {
        stride_[a] = size;
        // One more above, which only a point exactly on the high side reads, with weight 0.
        count_[a] = lattice.count[a] + 2 * margin_ + 1;
        size *= count_[a];
        shift_[a] = static_cast<Real>(margin_) - lattice.offset[a];
    }
    values_ = VecX::Zero(size);
}

template <int Dim>
void PaddedField<Dim>::fill(const VecX& samples) {
    const Index n = lattice_.count[0];
    parallel_for_each_row(
        lattice_, [&](Index start, const Counts<Dim>& at, int) { values_.segment(position(at), n) = samples.segment(start, n); });
    for (int a = 0; a < Dim; ++a) fill_beyond(a);
}

// Layers beyond a side mirror those within: as they are where the gradient vanishes, turned over about the wall's value where
// that is given. The one beyond a held sample repeats it.
template <int Dim>
void PaddedField<Dim>::fill_beyond(int axis) {
    const Index n = lattice_.count[axis], stride = stride_[axis], block = stride * count_[axis];
    const auto& sides = lattice_.sides[axis];
    for (Index start = 0; start < values_.size(); start += block) {
        const auto layer = [&](Index l) { return values_.segment(start + (l + margin_) * stride, stride); };
        const auto fill_layer = [&](const LatticeSide& side, Index out, Index mirrored, Index last) {
            if (side.beyond == Beyond::periodic)
                layer(out) = layer(((out % n) + n) % n);
            else if (side.beyond == Beyond::wall_value)
                layer(out).array() = 2 * side.value - layer(mirrored).array();
            else
                layer(out) = layer(side.beyond == Beyond::held ? last : mirrored);
        };
        for (Index k = 1; k <= margin_ + 1; ++k) {
            if (k <= margin_) fill_layer(sides[0], -k, std::min(k, n) - 1, 0);
            fill_layer(sides[1], n - 1 + k, std::max<Index>(n - k, 0), n - 1);
        }
    }
}

template <int Dim>
Real PaddedField<Dim>::cubic_at(const GridPlace<Dim>& x) const {
    const Inside in = locate(x);
    // Two columns of samples at a time.
    const auto along_1 = [&](const Real* w) {
        return monotone_cubic<Pair>(
            {load_pair(w - stride_[1]), load_pair(w), load_pair(w + stride_[1]), load_pair(w + 2 * stride_[1])}, in.fraction[1]);
    };
    const auto columns = [&](const Real* w) {
        if constexpr (Dim == 2)
            return along_1(w);
        else
            return monotone_cubic<Pair>(
                {along_1(w - stride_[2]), along_1(w), along_1(w + stride_[2]), along_1(w + 2 * stride_[2])}, in.fraction[2]);
    };
    const Real* corner = values_.data() + in.position;
    const Pair left = columns(corner - 1), right = columns(corner + 1);
    return monotone_cubic<Real>({left[0], left[1], right[0], right[1]}, in.fraction[0]);
}

template <int Dim>
std::array<Real, 2> PaddedField<Dim>::range_around(const GridPlace<Dim>& x) const {
    constexpr int corners = 1 << Dim;
    const Index position = locate(x).position;
    std::array<Real, corners> q;
    for (int k = 0; k < corners; ++k) {
        Index p = position;
        for (int a = 0; a < Dim; ++a) p += (k >> a & 1) * stride_[a];
        q[static_cast<std::size_t>(k)] = values_[p];
    }
    // Between the last sample and the one beyond a wall lies the wall: the mean of both.
    const Counts<Dim> at = coordinates(position);
    for (int a = 0; a < Dim; ++a) {
        const bool below = at[a] < 0, above = at[a] >= lattice_.count[a] - 1;
        if ((!below && !above) || lattice_.periodic(a)) continue;
        for (int k = 0; k < corners; ++k) {
            if ((k >> a & 1) != (above ? 1 : 0)) continue;
            Real& beyond = q[static_cast<std::size_t>(k)];
            beyond = (beyond + q[static_cast<std::size_t>(k ^ (1 << a))]) / 2;
        }
    }
    const auto [low, high] = std::minmax_element(q.begin(), q.end());
    return {*low, *high};
}

template <int Dim>
Counts<Dim> PaddedField<Dim>::coordinates(Index position) const {
    Counts<Dim> at;
    for (int a = 0; a < Dim; ++a) {
        at[a] = position % count_[a] - margin_;
        position /= count_[a];
    }
    return at;
}

template class PaddedField<2>;
template class PaddedField<3>;

}  // namespace pliant
