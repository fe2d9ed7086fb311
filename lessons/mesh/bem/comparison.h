// What it costs to be as good: a ring by boundary elements and by finite elements, finer and finer.
#pragma once
#include "body.h"

#include <vector>

namespace pliant::bem {

struct Effort {
    Real unknowns = 0, entries = 0, operations = 0;  // of its matrix; multiplications and additions to factorise it
    Real error = 0;                                  // largest of the displacements on the boundary, over the largest of them
};

struct Comparison {
    std::vector<Effort> boundary, finite;  // finer and finer
    Effort own;                            // of these boundary elements
    Effort equal;                          // of finite elements with the same error
    Real order = 0;                        // by which the error of finite elements falls with their unknowns
    bool beyond = false;                   // is `equal` beyond the finest that was computed?
};

struct RingProblem {
    PressedRing ring;
    BoundaryOrder order;
    int elements;
};
// Boundary elements on both circles.
Effort boundary_effort(const RingProblem& problem, int elements);
// Linear triangles, so many across the wall; about as long as wide. Of a sparse Cholesky factorisation in a fill-reducing order.
Effort finite_effort(const PressedRing& ring, int across);
// own: what the present solution has.
Comparison compare_efforts(const RingProblem& problem, const Effort& own);

}  // namespace pliant::bem
