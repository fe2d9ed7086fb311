// A copy of a quantity on a lattice with layers of what lies beyond its sides, so that it can be interpolated anywhere in the
// domain without asking where the walls are.
#pragma once
#include <pliant/fluids/lattice.h>
#include <pliant/fluids/monotone_cubic.h>
#include <pliant/math/pair.h>

#include <type_traits>

namespace pliant {

// The places of two particles that are handled at once, axis by axis.
template <int Dim>
using PlacePair = std::array<Pair, Dim>;

// {f(0), ..., f(Dim − 1)}, with the axis as a constant: unlike a loop over an array, what it makes stays in registers.
template <int Dim, class F>
[[gnu::always_inline]] inline auto for_axes(const F& f) {
    using std::integral_constant;
    if constexpr (Dim == 2)
        return std::array{f(integral_constant<int, 0>()), f(integral_constant<int, 1>())};
    else
        return std::array{f(integral_constant<int, 0>()), f(integral_constant<int, 1>()), f(integral_constant<int, 2>())};
}

enum class Interpolation {
    linear,         // between the 2^Dim samples around the place
    monotone_cubic  // between the 4^Dim samples around it, axis by axis from the last one; makes no new extremum
};

template <int Dim>
class PaddedField {
public:
    // One layer beyond each side for linear interpolation, two for the cubic one.
    explicit PaddedField(const Lattice<Dim>& lattice, Interpolation interpolation = Interpolation::linear);

    const Lattice<Dim>& lattice() const { return lattice_; }
    Interpolation interpolation() const { return margin_ == 1 ? Interpolation::linear : Interpolation::monotone_cubic; }

    // Copies one value per sample of the lattice and fills the layers beyond its sides.
    void fill(const VecX& samples);

    // The cell of samples that a place in the domain lies in: where its lowest sample is stored, and how far the place is from
    // that sample along each axis, in [0, 1).
    struct Inside {
        Index position;
        GridPlace<Dim> fraction;
    };
    Inside locate(const GridPlace<Dim>& x) const {
        Inside in{0, {}};
        for (int a = 0; a < Dim; ++a) {
            const Real t = x[a] + shift_[a];
            const auto i = static_cast<int>(t);
            in.position += i * stride_[a];
            in.fraction[a] = t - i;
        }
        return in;
    }

    // Multilinear interpolation at a place in the domain.
    Real at(const GridPlace<Dim>& x) const {
        const Inside in = locate(x);
        const Pair q = beside(values_.data() + in.position, in.fraction, stride_);
        return q[0] + in.fraction[0] * (q[1] - q[0]);
    }
    // The same for n places, given by one array of coordinates per axis. All arrays hold whole pairs: n + 1 numbers, if n is odd.
    void at(const std::array<const Real*, Dim>& x, Index n, Real* out) const {
        // Copies, which the numbers that are written cannot change.
        const Counts<Dim> stride = stride_;
        const GridPlace<Dim> shift = shift_;
        const Real* values = values_.data();
        for (Index i = 0; i < n; i += 2) {
            Index first = 0, second = 0;
            const PlacePair<Dim> fraction = for_axes<Dim>([&](auto a) -> Pair {
                const Pair t = load_pair(x[a] + i) + shift[a];
                const auto j = static_cast<int>(t[0]), k = static_cast<int>(t[1]);
                first += a == 0 ? j : j * stride[a];
                second += a == 0 ? k : k * stride[a];
                return t - Pair{static_cast<Real>(j), static_cast<Real>(k)};
            });
            const Pair q = beside(values + first, lane(fraction, 0), stride),
                       r = beside(values + second, lane(fraction, 1), stride);
            const Pair low{q[0], r[0]}, high{q[1], r[1]};
            store_pair(out + i, low + fraction[0] * (high - low));
        }
    }

    // Monotone cubic interpolation, for a field made for it.
    Real cubic_at(const GridPlace<Dim>& x) const;
    // By the interpolation that the field was made for.
    Real interpolated(const GridPlace<Dim>& x) const { return margin_ == 1 ? at(x) : cubic_at(x); }

    // The smallest and the largest of the samples around a place and of the walls between them.
    std::array<Real, 2> range_around(const GridPlace<Dim>& x) const;

    // The sample with these coordinates; one step beyond the sides is allowed, two for cubic interpolation.
    Real sample(const Counts<Dim>& at) const { return values_[position(at)]; }
    // Where a sample is stored, and how far its neighbours along an axis are, for loops over data(). A loop may read one more
    // number behind a row of samples.
    Index position(const Counts<Dim>& at) const {
        Index p = 0;
        for (int a = 0; a < Dim; ++a) p += (at[a] + margin_) * stride_[a];
        return p;
    }
    Counts<Dim> coordinates(Index position) const;
    Index stride(int axis) const { return stride_[axis]; }
    const Real* data() const { return values_.data(); }

    [[gnu::always_inline]] static GridPlace<Dim> lane(const PlacePair<Dim>& x, int k) {
        return for_axes<Dim>([&](auto a) { return x[a][k]; });
    }

private:
    // Interpolation along all axes but 0 at the two samples beside the place along axis 0, the lower of which is at v.
    [[gnu::always_inline]] static Pair beside(const Real* v, const GridPlace<Dim>& fraction, const Counts<Dim>& stride) {
        const auto along_1 = [&](const Real* w) -> Pair {
            const Pair low = load_pair(w), high = load_pair(w + stride[1]);
            return low + fraction[1] * (high - low);
        };
        if constexpr (Dim == 2) {
            return along_1(v);
        } else {
            const Pair near = along_1(v), far = along_1(v + stride[2]);
            return near + fraction[2] * (far - near);
        }
    }
    void fill_beyond(int axis);

    Lattice<Dim> lattice_;
    Index margin_;
    Counts<Dim> count_{}, stride_{};
    GridPlace<Dim> shift_{};
    VecX values_;
};

extern template class PaddedField<2>;
extern template class PaddedField<3>;

}  // namespace pliant
