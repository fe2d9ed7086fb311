// Direct solution of dense systems of any size.
#pragma once
#include <pliant/math/types.h>

#include <vector>

namespace pliant {

// P A = L U with row pivots, in blocks of columns [Golub2013 §3.4]: 2 n³/3 operations. Between two blocks it tells its progress
// and can be called off (watch.h).
class DenseLu {
public:
    // Throws Diverged, naming the unknown, for a column without a pivot or a matrix that is not finite.
    explicit DenseLu(MatX A);

    VecX solve(const VecX& b) const;
    // Multiplications and additions of the factorisation of n unknowns.
    static Real operations(Index n) { return 2.0 / 3 * static_cast<Real>(n) * static_cast<Real>(n) * static_cast<Real>(n); }

private:
    void factorize_panel(Index first, Index width);

    MatX factors_;              // L below the diagonal, U above
    std::vector<Index> pivot_;  // the row that row k was exchanged with
};

}  // namespace pliant
