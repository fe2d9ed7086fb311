#include <pliant/fluids/lattice_rows.h>

namespace pliant {

template <int Dim>
std::vector<LatticeRow<Dim>> lattice_rows(const Lattice<Dim>& lattice) {
    std::vector<LatticeRow<Dim>> rows;
    rows.reserve(static_cast<std::size_t>(lattice.rows()));
    for_each_row(lattice, [&](Index start, const Counts<Dim>& at) {
        LatticeRow<Dim> row;
        row.start = start;
        for (int a = 1; a < Dim; ++a) {
            row.colour ^= static_cast<int>(at[a] & 1);
            for (int side = 0; side < 2; ++side) {
                const int k = 2 * (a - 1) + side;
                const bool alone = lattice.periodic(a) && lattice.count[a] == 1;
                row.beside[k] = alone ? -1 : lattice.neighbour(at, a, side == 0 ? -1 : 1);
                row.beyond[k] = alone ? Beyond::zero_gradient : lattice.sides[a][side].beyond;
            }
        }
        rows.push_back(row);
    });
    return rows;
}

template std::vector<LatticeRow<2>> lattice_rows(const Lattice<2>&);
template std::vector<LatticeRow<3>> lattice_rows(const Lattice<3>&);

}  // namespace pliant
