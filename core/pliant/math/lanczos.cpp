#include <pliant/math/lanczos.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace pliant {
namespace {

// Has the tridiagonal matrix an eigenvalue above x? Its Sturm sequence then changes signs less than n times.
bool eigenvalue_above(const std::vector<Real>& diagonal, const std::vector<Real>& beside, Real x) {
    Real pivot = 1;
    for (std::size_t k = 0; k < diagonal.size(); ++k) {
        pivot = diagonal[k] - x - (k == 0 ? 0 : beside[k - 1] * beside[k - 1] / pivot);
        if (pivot > 0) return true;
        if (pivot == 0) pivot = -std::numeric_limits<Real>::min();
    }
    return false;
}

// By bisection between Gershgorin's bounds.
Real largest_of_tridiagonal(const std::vector<Real>& diagonal, const std::vector<Real>& beside) {
    Real low = diagonal[0], high = diagonal[0];
    for (std::size_t k = 0; k < diagonal.size(); ++k) {
        const Real reach = (k > 0 ? std::abs(beside[k - 1]) : 0) + (k < beside.size() ? std::abs(beside[k]) : 0);
        low = std::min(low, diagonal[k] - reach), high = std::max(high, diagonal[k] + reach);
    }
    constexpr int halvings = 100;
    for (int k = 0; k < halvings; ++k) {
        const Real middle = 0.5 * (low + high);
        (eigenvalue_above(diagonal, beside, middle) ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

Real largest_eigenvalue(Index n, const std::function<void(const VecX&, VecX&)>& apply, Index steps) {
    if (n == 0) return 0;
    std::mt19937_64 engine(1);
    VecX q = VecX::NullaryExpr(n, [&] { return static_cast<Real>(engine() >> 11) * 0x1p-52 - 1; });
    q.normalize();
    VecX before = VecX::Zero(n), next(n);
    std::vector<Real> diagonal, beside;
    for (Index k = 0; k < std::min(steps, n); ++k) {
        apply(q, next);
        diagonal.push_back(q.dot(next));
        next -= diagonal.back() * q + (k > 0 ? beside.back() : Real{0}) * before;
        const Real length = next.norm();
        // The start has no part of what is left.
        if (!(length > 1e-14 * std::abs(diagonal.back())) || k + 1 == std::min(steps, n)) break;
        beside.push_back(length);
        before.swap(q);
        q = next / length;
    }
    return largest_of_tridiagonal(diagonal, beside);
}

}  // namespace pliant
