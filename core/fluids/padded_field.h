// A copy of a quantity on a lattice with one layer of what lies beyond its sides, so that it can be interpolated anywhere in
// the domain without asking where the walls are.
#pragma once
#include <pliant/fluids/lattice.h>

namespace pliant {

template <int Dim>
class PaddedField {
public:
    explicit PaddedField(const Lattice<Dim>& lattice) : lattice_(lattice) {
        Index size = 1;
        for (int a = 0; a < Dim; ++a) {
            stride_[a] = size;
            count_[a] = lattice.count[a] + 3;
            size *= count_[a];
            shift_[a] = 1 - lattice.offset[a];
        }
        values_ = VecX::Zero(size);
    }

    const Lattice<Dim>& lattice() const { return lattice_; }

    // Copies one value per sample of the lattice and fills the layer beyond its sides.
    void fill(const VecX& samples);

    // Multilinear interpolation at a place in the domain.
    Real at(const GridPlace<Dim>& x) const {
        const Real tx = x[0] + shift_[0], ty = x[1] + shift_[1];
        const auto i = static_cast<Index>(tx), j = static_cast<Index>(ty);
        const Real fx = tx - static_cast<Real>(i), fy = ty - static_cast<Real>(j);
        const Real* v = values_.data() + i + j * stride_[1];
        if constexpr (Dim == 2) {
            return plane(v, fx, fy);
        } else {
            const Real tz = x[2] + shift_[2];
            const auto k = static_cast<Index>(tz);
            v += k * stride_[2];
            const Real near = plane(v, fx, fy), far = plane(v + stride_[2], fx, fy);
            return near + (tz - static_cast<Real>(k)) * (far - near);
        }
    }

    // The same for n places, given by one array of coordinates per axis.
    void at(const std::array<const Real*, Dim>& x, Index n, Real* out) const {
        for (Index i = 0; i < n; ++i) {
            if constexpr (Dim == 2)
                out[i] = at({x[0][i], x[1][i]});
            else
                out[i] = at({x[0][i], x[1][i], x[2][i]});
        }
    }

    // The sample with these coordinates; one step beyond the sides is allowed.
    Real sample(const Counts<Dim>& at) const { return values_[position(at)]; }
    // Where a sample is stored, and how far its neighbours along an axis are, for loops over data().
    Index position(const Counts<Dim>& at) const {
        Index p = 0;
        for (int a = 0; a < Dim; ++a) p += (at[a] + 1) * stride_[a];
        return p;
    }
    Index stride(int axis) const { return stride_[axis]; }
    const Real* data() const { return values_.data(); }

private:
    // Bilinear interpolation over axes 0 and 1.
    Real plane(const Real* v, Real fx, Real fy) const {
        const Eigen::Array2d low = Eigen::Map<const Eigen::Array2d>(v), high = Eigen::Map<const Eigen::Array2d>(v + stride_[1]);
        const Eigen::Array2d q = low + fy * (high - low);
        return q[0] + fx * (q[1] - q[0]);
    }
    void fill_beyond(int axis);

    Lattice<Dim> lattice_;
    Counts<Dim> count_{}, stride_{};
    GridPlace<Dim> shift_{};
    VecX values_;
};

extern template class PaddedField<2>;
extern template class PaddedField<3>;

}  // namespace pliant
