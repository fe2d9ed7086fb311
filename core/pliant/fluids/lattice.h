// A box of evenly spaced samples: where they lie, how they are numbered and what is found beyond the sides of the box.
#pragma once
#include <pliant/math/types.h>

#include <array>

namespace pliant {

// Numbers of cells or samples along each axis, or the integer coordinates of one of them.
template <int Dim>
using Counts = std::array<Index, Dim>;

// One array per axis.
template <int Dim>
struct AxisArrays {
    std::array<VecX, Dim> components;

    VecX& operator[](int axis) { return components[axis]; }
    const VecX& operator[](int axis) const { return components[axis]; }
};

// What a quantity is taken to be just beyond a side of its lattice.
enum class Beyond {
    periodic,       // the sample at the other end
    zero_gradient,  // the value of the last sample
    wall_value,     // the side lies half a cell beyond the last sample, and the quantity equals `value` there
    held            // the last sample lies on the side itself and keeps its value
};

struct LatticeSide {
    Beyond beyond = Beyond::zero_gradient;
    Real value = 0;  // used by wall_value alone
};

// A place in cells from the corner of the domain, or a displacement in cells per second. Plain numbers: they stay in
// registers, where a fixed-size vector of Eigen would pass through memory.
template <int Dim>
using GridPlace = std::array<Real, Dim>;

template <int Dim>
struct Lattice {
    Counts<Dim> count{};                                  // samples along each axis; axis 0 runs fastest in memory
    GridPlace<Dim> offset{};                              // place of sample 0, in cells from the corner of the domain: 0 or 1/2
    std::array<std::array<LatticeSide, 2>, Dim> sides{};  // [axis][0: low, 1: high]

    bool periodic(int axis) const { return sides[axis][0].beyond == Beyond::periodic; }

    Index size() const {
        Index product = 1;
        for (Index n : count) product *= n;
        return product;
    }

    // Number of rows along axis 0.
    Index rows() const { return count[0] > 0 ? size() / count[0] : 0; }

    Index stride(int axis) const {
        Index product = 1;
        for (int a = 0; a < axis; ++a) product *= count[a];
        return product;
    }

    Index index(const Counts<Dim>& at) const {
        Index i = at[Dim - 1];
        for (int a = Dim - 2; a >= 0; --a) i = i * count[a] + at[a];
        return i;
    }

    Counts<Dim> coordinates(Index i) const {
        Counts<Dim> at{};
        for (int a = 0; a < Dim; ++a) {
            at[a] = i % count[a];
            i /= count[a];
        }
        return at;
    }

    // GridPlace of a sample, in cells from the corner of the domain.
    GridPlace<Dim> place(const Counts<Dim>& at) const {
        GridPlace<Dim> x = offset;
        for (int a = 0; a < Dim; ++a) x[a] += static_cast<Real>(at[a]);
        return x;
    }

    // The neighbour one step (-1 or +1) along an axis, wrapped on a periodic axis; -1 beyond a wall.
    Index neighbour(Counts<Dim> at, int axis, int step) const {
        at[axis] += step;
        if (at[axis] < 0 || at[axis] >= count[axis]) {
            if (!periodic(axis)) return -1;
            at[axis] += step > 0 ? -count[axis] : count[axis];
        }
        return index(at);
    }
};

// Calls body(first index of the row, coordinates of its first sample) for every row along axis 0, in memory order.
template <int Dim, class Body>
void for_each_row(const Lattice<Dim>& lattice, Body&& body) {
    Counts<Dim> at{};
    const Index rows = lattice.rows();
    for (Index row = 0; row < rows; ++row) {
        body(row * lattice.count[0], static_cast<const Counts<Dim>&>(at));
        for (int a = 1; a < Dim; ++a) {
            if (++at[a] < lattice.count[a]) break;
            at[a] = 0;
        }
    }
}

}  // namespace pliant
