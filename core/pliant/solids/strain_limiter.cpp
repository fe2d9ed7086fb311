#include <pliant/math/error.h>
#include <pliant/solids/strain_limiter.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant {

StrainLimiter::StrainLimiter(const Springs& springs, Index count) : springs_(springs), corrections_(3, count) {
    if (count < 0 || count > springs.size())
        throw Refused(fmt::format("strain limiting of {} springs was asked for: there are {}", count, springs.size()));
    corrections_.setZero();
}

Real StrainLimiter::pass(const DiagonalMass& mass, Real limit, Real dt, PointsOut<3> x, PointsOut<3> v) {
    const Index count = corrections_.cols();
    Real worst = 0;
    for (Index k = 0; k < count; ++k) {
        const Index s = passes_ % 2 ? count - 1 - k : k;
        corrections_.col(s).setZero();
        const Index i = springs_.i(s), j = springs_.j(s);
        const Real rest = springs_.rest_length()[s], mobility = mass.inverse()[3 * i] + mass.inverse()[3 * j];
        const Vec<3> x_ij = x.col(j) - x.col(i);
        const Real length = x_ij.norm(), excess = length - (1 + limit) * rest;
        if (!(excess > 0) || mobility == 0) continue;
        worst = std::max(worst, excess / rest);
        const Vec<3> p = excess / (length * mobility) * x_ij;
        corrections_.col(s) = p;
        x.col(i) += mass.inverse()[3 * i] * p;
        x.col(j) -= mass.inverse()[3 * j] * p;
        v.col(i) += mass.inverse()[3 * i] / dt * p;
        v.col(j) -= mass.inverse()[3 * j] / dt * p;
    }
    ++passes_;
    return worst;
}

Real largest_stretch(const Springs& springs, Index count, PointsIn<3> x) {
    Real largest = 0;
    for (Index s = 0; s < count; ++s) {
        const Real rest = springs.rest_length()[s];
        if (rest > 0) largest = std::max(largest, (x.col(springs.j(s)) - x.col(springs.i(s))).norm() / rest - 1);
    }
    return largest;
}

}  // namespace pliant
