#include <pliant/fluids/padded_field.h>

namespace pliant {

template <int Dim>
void PaddedField<Dim>::fill(const VecX& samples) {
    const Index n = lattice_.count[0];
    for_each_row(lattice_,
                 [&](Index start, const Counts<Dim>& at) { values_.segment(position(at), n) = samples.segment(start, n); });
    for (int a = 0; a < Dim; ++a) fill_beyond(a);
}

// Layers are numbered from 0 beyond the low side: 1 to n are the samples, n + 1 lies beyond the high side, and n + 2 is only
// ever read with weight 0, by a point exactly on the high side.
template <int Dim>
void PaddedField<Dim>::fill_beyond(int axis) {
    const Index n = lattice_.count[axis], stride = stride_[axis], block = stride * count_[axis];
    const auto& sides = lattice_.sides[axis];
    for (Index start = 0; start < values_.size(); start += block) {
        const auto layer = [&](Index l) { return values_.segment(start + l * stride, stride); };
        const auto beyond = [&](const LatticeSide& side, Index out, Index last, Index opposite) {
            if (side.beyond == Beyond::periodic)
                layer(out) = layer(opposite);
            else if (side.beyond == Beyond::wall_value)
                layer(out).array() = 2 * side.value - layer(last).array();
            else
                layer(out) = layer(last);
        };
        beyond(sides[0], 0, 1, n);
        beyond(sides[1], n + 1, n, 1);
        layer(n + 2) = layer(lattice_.periodic(axis) ? 2 : n + 1);
    }
}

template class PaddedField<2>;
template class PaddedField<3>;

}  // namespace pliant
