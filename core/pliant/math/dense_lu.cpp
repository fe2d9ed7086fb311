#include <pliant/math/dense_lu.h>
#include <pliant/math/error.h>
#include <pliant/math/watch.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr Index panel_width = 48;

}  // namespace

DenseLu::DenseLu(MatX A) : factors_(std::move(A)), pivot_(static_cast<std::size_t>(factors_.cols())) {
    const Index n = factors_.cols();
    for (Index first = 0; first < n; first += panel_width) {
        const Index width = std::min(panel_width, n - first), rest = n - first - width;
        tell_progress("factorising the matrix", first, n);
        factorize_panel(first, width);
        if (rest == 0) break;
        factors_.block(first, first + width, width, rest) = factors_.block(first, first, width, width)
                                                                .triangularView<Eigen::UnitLower>()
                                                                .solve(MatX(factors_.block(first, first + width, width, rest)));
        factors_.bottomRightCorner(rest, rest).noalias() -=
            factors_.block(first + width, first, rest, width) * factors_.block(first, first + width, width, rest);
    }
}

// Column by column; the rows of the whole matrix are exchanged with those of the panel.
void DenseLu::factorize_panel(Index first, Index width) {
    const Index n = factors_.cols();
    for (Index k = first; k < first + width; ++k) {
        Index best = 0;
        const Real largest = factors_.col(k).tail(n - k).cwiseAbs().maxCoeff(&best);
        if (!(largest > 0) || !std::isfinite(largest)) {
            Failure failure;
            failure.what = fmt::format("the dense matrix is singular: unknown {} has no pivot", k);
            failure.kind = FailureKind::not_converged;
            throw Diverged(failure);
        }
        best += k;
        pivot_[static_cast<std::size_t>(k)] = best;
        if (best != k) factors_.row(k).swap(factors_.row(best));
        factors_.col(k).tail(n - k - 1) /= factors_(k, k);
        const Index right = first + width - k - 1;
        factors_.block(k + 1, k + 1, n - k - 1, right).noalias() -=
            factors_.col(k).tail(n - k - 1) * factors_.row(k).segment(k + 1, right);
    }
}

VecX DenseLu::solve(const VecX& b) const {
    VecX x = b;
    for (Index k = 0; k < x.size(); ++k) std::swap(x[k], x[pivot_[static_cast<std::size_t>(k)]]);
    factors_.triangularView<Eigen::UnitLower>().solveInPlace(x);
    factors_.triangularView<Eigen::Upper>().solveInPlace(x);
    if (!x.allFinite()) {
        Failure failure;
        failure.what = "the solution of the dense system is not finite";
        failure.kind = FailureKind::not_converged;
        throw Diverged(failure);
    }
    return x;
}

}  // namespace pliant
