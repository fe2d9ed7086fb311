// The null space of a linear map that is given by what it does.
#pragma once
#include <pliant/math/dense_matrix.h>

namespace pliant {

// Dimension of the null space of a linear map on n numbers, map(x, y): y = A x, by the rank of its dense matrix: n³ operations.
// Pivots below 1e-10 of the largest count as 0.
template <class Map>
Index null_dimension(Index n, Map&& map) {
    MatX matrix(n, n);
    VecX column;
    for (Index c = 0; c < n; ++c) {
        map(VecX::Unit(n, c), column);
        matrix.col(c) = column;
    }
    return n - rank(matrix, 1e-10);
}

}  // namespace pliant
