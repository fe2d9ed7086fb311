#include <pliant/solids/elastic_solutions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pliant {
namespace {

using std::numbers::pi;

// Of both components, in amplitudes, and half waves along y.
constexpr std::array<Real, 2> heights{1, 0.5};
constexpr std::array<Real, 2> waves_up{1, 2};

}  // namespace

Vec<2> SinesInSquare::displacement(const Vec<2>& X) const {
    Vec<2> u;
    for (std::size_t k = 0; k < 2; ++k)
        u[static_cast<Index>(k)] =
            length * amplitude * heights[k] * std::sin(pi * X.x() / length) * std::sin(waves_up[k] * pi * X.y() / length);
    return u;
}

Mat<2> SinesInSquare::gradient(const Vec<2>& X) const {
    Mat<2> H;
    const Real x = pi * X.x() / length;
    for (std::size_t k = 0; k < 2; ++k) {
        const Real y = waves_up[k] * pi * X.y() / length;
        H(static_cast<Index>(k), 0) = amplitude * heights[k] * pi * std::cos(x) * std::sin(y);
        H(static_cast<Index>(k), 1) = amplitude * heights[k] * pi * waves_up[k] * std::sin(x) * std::cos(y);
    }
    return H;
}

// b_i = -sum_jkl dP_ij/dF_kl d²u_k/(dX_l dX_j).
Vec<2> SinesInSquare::force_density(const Vec<2>& X, const EnergyDensity<2>& energy) const {
    const Mat<4> tangent = energy.tangent(Mat<2>::Identity() + gradient(X));
    Vec<2> b = Vec<2>::Zero();
    const Real x = pi * X.x() / length;
    for (std::size_t k = 0; k < 2; ++k) {
        const Real y = waves_up[k] * pi * X.y() / length, size = amplitude * heights[k] * pi * pi / length;
        Mat<2> second;  // of u_k
        second(0, 0) = -size * std::sin(x) * std::sin(y);
        second(0, 1) = second(1, 0) = size * waves_up[k] * std::cos(x) * std::cos(y);
        second(1, 1) = -size * waves_up[k] * waves_up[k] * std::sin(x) * std::sin(y);
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
                for (int l = 0; l < 2; ++l) b[i] -= tangent(i + 2 * j, static_cast<int>(k) + 2 * l) * second(l, j);
    }
    return b;
}

Vec<2> SpinningDisc::displacement(const Vec<2>& X) const {
    const Real l = material.lambda, m = material.mu, R2 = radius * radius, stiff = 8 * (l + 2 * m);
    return rim_force / radius * ((2 * l + 3 * m) * R2 / ((l + m) * stiff) - X.squaredNorm() / stiff) * X;
}

Real ReleasedRod::plateau(Real t) const {
    const Real way = std::fmod(wave_speed * t, 4 * length);
    return way <= 2 * length ? length - way : way - 3 * length;
}

Real ReleasedRod::displacement(Real s, Real t) const {
    const Real out = plateau(t);
    return strain * std::copysign(std::min(s, std::abs(out)), out);
}

Real ReleasedRod::strain_at(Real s, Real t) const {
    const Real out = plateau(t);
    return s < std::abs(out) ? std::copysign(strain, out) : 0;
}

Real ReleasedRod::frequency(Index j) const { return static_cast<Real>(2 * j - 1) * wave_speed / (4 * length); }

}  // namespace pliant
