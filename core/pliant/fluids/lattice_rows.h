// The rows of a lattice along axis 0 and, for each, the rows beside it: what a stencil needs to run over contiguous memory.
#pragma once
#include <pliant/fluids/lattice.h>

#include <vector>

namespace pliant {

template <int Dim>
struct LatticeRow {
    static constexpr int beside_count = 2 * (Dim - 1);
    Index start = 0;                            // index of the row's first sample
    std::array<Index, beside_count> beside{};   // first sample of the row below and above, axis by axis from 1; -1 beyond a wall
    std::array<Beyond, beside_count> beyond{};  // what lies there when it is -1
    int colour = 0;                             // parity of the row's coordinates: its first sample is red (0) or black (1)
};

// A periodic axis with a single sample couples the sample with itself alone, which is the same as a wall with zero gradient.
template <int Dim>
std::vector<LatticeRow<Dim>> lattice_rows(const Lattice<Dim>& lattice);

// Do samples of one colour have neighbours of the other alone? Not around a periodic axis of an odd number.
template <int Dim>
bool two_coloured(const Lattice<Dim>& lattice) {
    for (int a = 0; a < Dim; ++a)
        if (lattice.periodic(a) && lattice.count[a] % 2 == 1 && lattice.count[a] > 1) return false;
    return true;
}

extern template std::vector<LatticeRow<2>> lattice_rows(const Lattice<2>&);
extern template std::vector<LatticeRow<3>> lattice_rows(const Lattice<3>&);

}  // namespace pliant
