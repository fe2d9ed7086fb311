// Loops over the rows of a lattice in several threads.
#pragma once
#include <pliant/fluids/lattice.h>
#include <pliant/math/parallel.h>

namespace pliant {

// As for_each_row, but body(first index of the row, coordinates of its first sample, thread) may run in several threads: each row
// must write to places of its own.
template <int Dim, class Body>
void parallel_for_each_row(const Lattice<Dim>& lattice, Body&& body) {
    parallel_parts(lattice.rows(), lattice.count[0], [&](Index first, Index last, int thread) {
        Counts<Dim> at{};
        Index rest = first;
        for (int a = 1; a < Dim; ++a) {
            at[a] = rest % lattice.count[a];
            rest /= lattice.count[a];
        }
        for (Index row = first; row < last; ++row) {
            body(row * lattice.count[0], static_cast<const Counts<Dim>&>(at), thread);
            for (int a = 1; a < Dim; ++a) {
                if (++at[a] < lattice.count[a]) break;
                at[a] = 0;
            }
        }
    });
}

}  // namespace pliant
