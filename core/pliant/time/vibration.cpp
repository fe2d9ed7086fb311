#include <pliant/math/dense_matrix.h>
#include <pliant/math/watch.h>
#include <pliant/time/vibration.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pliant {
namespace {

constexpr Index most_vectors = 400, between_checks = 5;

// Lanczos' vectors q_j, orthonormal with respect to M, and the tridiagonal matrix of M^-1 K on them.
struct Krylov {
    std::vector<VecX> q, Mq;
    std::vector<Real> diagonal, beside;

    // Twice is enough to leave rounding alone.
    void orthogonalise(VecX& w) const {
        for (int pass = 0; pass < 2; ++pass)
            for (std::size_t j = 0; j < q.size(); ++j) w -= Mq[j].dot(w) * q[j];
    }
    MatX tridiagonal() const {
        const auto size = static_cast<Index>(diagonal.size());
        MatX T = MatX::Zero(size, size);
        for (Index k = 0; k < size; ++k) T(k, k) = diagonal[static_cast<std::size_t>(k)];
        for (Index k = 0; k + 1 < size; ++k) T(k, k + 1) = T(k + 1, k) = beside[static_cast<std::size_t>(k)];
        return T;
    }
};

}  // namespace

VibrationMode fastest_mode(const SparseMatrix& stiffness, const Mass& mass, Real tolerance) {
    VibrationMode mode;
    const Index n = mass.size();
    VecX w(n), Kq(n), Mw(n);
    Index free = 0;
    for (Index d = 0; d < n; ++d) {
        w[d] = mass.fixed(d) ? 0 : std::cos(1 + static_cast<Real>(d) * static_cast<Real>(d));
        free += !mass.fixed(d);
    }
    mode.shape.setZero(n);
    Krylov space;
    Real norm = std::sqrt(mass.square(w));
    const Index most = std::min(free, most_vectors);
    for (Index k = 0; k < most; ++k) {
        tell_progress("largest_frequency", k, most);
        space.q.push_back(w / norm);
        mass.multiply(space.q.back(), Mw);
        space.Mq.push_back(Mw);
        Kq.noalias() = stiffness * space.q.back();
        ++mode.products;
        space.diagonal.push_back(space.q.back().dot(Kq));
        mass.accelerate(Kq, w);
        space.orthogonalise(w);
        norm = std::sqrt(mass.square(w));
        const bool exhausted = k + 1 == most || !(norm > std::numeric_limits<Real>::epsilon() * std::abs(space.diagonal[0]));
        if (exhausted || (k + 1) % between_checks == 0) {
            const DenseEigen ritz = dense_eigen(space.tridiagonal());
            const Real value = std::max(ritz.values[k], Real{0});
            if (exhausted || norm * std::abs(ritz.vectors(k, k)) <= tolerance * value) {
                mode.omega = std::sqrt(value);
                for (Index j = 0; j <= k; ++j) mode.shape += ritz.vectors(j, k) * space.q[static_cast<std::size_t>(j)];
                return mode;
            }
        }
        space.beside.push_back(norm);
    }
    return mode;
}

}  // namespace pliant
