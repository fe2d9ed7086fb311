#include <pliant/math/line_fit.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {

std::optional<LineFit> fit_line(std::span<const Real> position, std::span<const Real> value) {
    const auto count = static_cast<Index>(std::min(position.size(), value.size()));
    if (count < 2) return std::nullopt;
    const Eigen::Map<const VecX> x(position.data(), count), y(value.data(), count);

    // Positions relative to their mean and in units of their spread, so that squares neither overflow nor vanish.
    const Real mean_x = x.mean(), mean_y = y.mean();
    const VecX from_mean = x.array() - mean_x;
    const Real spread = from_mean.cwiseAbs().maxCoeff();
    if (!std::isfinite(spread) || !(spread > std::numeric_limits<Real>::epsilon() * x.cwiseAbs().maxCoeff())) return std::nullopt;
    const VecX scaled = from_mean / spread;

    LineFit fit;
    fit.slope = scaled.dot((y.array() - mean_y).matrix()) / scaled.squaredNorm() / spread;
    fit.intercept = mean_y - fit.slope * mean_x;
    fit.largest_deviation = (y.array() - mean_y - fit.slope * from_mean.array()).abs().maxCoeff();
    return fit;
}

}  // namespace pliant
