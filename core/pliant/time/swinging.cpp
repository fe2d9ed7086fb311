#include <pliant/time/swinging.h>

#include <algorithm>
#include <cmath>

namespace pliant {

bool SwingingOptions::operator==(const SwingingOptions& o) const {
    return system == o.system && omega == o.omega && zeta == o.zeta && stiffness_ratio == o.stiffness_ratio &&
           start.x == o.start.x && start.v == o.start.v;
}

Swinging::Swinging(const SwingingOptions& options) : options_(options) {
    const Real omega = options_.omega, soft = omega * omega;
    length_ = gravity / soft;
    if (options_.system == SwingingKind::stiff_pair) {
        const Real r = options_.stiffness_ratio;
        // In units of the soft spring: [1 + r, -r; -r, r] with eigenvalues a >= b, a b = r.
        const Real a = 0.5 + r + std::sqrt(0.25 + r * r), b = r / a;
        rates_ = omega * Eigen::Vector2d(std::sqrt(b), std::sqrt(a));
        modes_.col(0) = Eigen::Vector2d(r, 1 + r - b).normalized();
        modes_.col(1) = Eigen::Vector2d(-modes_(1, 0), modes_(0, 0));
        K_ << 1 + r, -r, -r, r;
        const Mat<2> root = (K_ + std::sqrt(r) * Mat<2>::Identity()) / std::sqrt(1 + 2 * r + 2 * std::sqrt(r));
        K_ *= soft;
        C_ = 2 * options_.zeta * omega * root;
    } else {
        rates_.setConstant(omega);
        K_(0, 0) = soft;
        C_(0, 0) = 2 * options_.zeta * omega;
    }
    slow_ = rates_[0], fast_ = rates_[1];
    matrix_ = Eigen::MatrixXd::Ones(size(), size()).sparseView();
    matrix_.makeCompressed();

    const Real total = energy(start_position(), start_velocity());
    if (!linear() && omega > 0) pendulum_.emplace(omega, gravity, options_.start);
    leaves_ = omega == 0 || (pendulum_ && pendulum_->reaches_top());
    if (total > 0) speed_ = std::sqrt(2 * total);
    if (slow_ > 0 && total > 0) scale_ = std::max(speed_ / slow_, std::abs(options_.start.x));
    if (omega == 0 && options_.start.x != 0) scale_ = std::abs(options_.start.x);
}

Real Swinging::potential(ConstDofs x) const {
    if (options_.omega == 0) return 0;
    if (linear()) return 0.5 * x.dot(K_.topLeftCorner(size(), size()) * x);
    const Real s = std::sin(x[0] / (2 * length_));
    return 2 * gravity * length_ * s * s;
}

Real Swinging::dissipation(ConstDofs v) const { return 0.5 * v.dot(C_.topLeftCorner(size(), size()) * v); }

void Swinging::force(ConstDofs x, ConstDofs v, Dofs f) const {
    if (size() == 2) {
        f[0] = -(K_(0, 0) * x[0] + K_(0, 1) * x[1]) - (C_(0, 0) * v[0] + C_(0, 1) * v[1]);
        f[1] = -(K_(1, 0) * x[0] + K_(1, 1) * x[1]) - (C_(1, 0) * v[0] + C_(1, 1) * v[1]);
        return;
    }
    const Real back = linear() || options_.omega == 0 ? K_(0, 0) * x[0] : gravity * std::sin(x[0] / length_);
    f[0] = -back - C_(0, 0) * v[0];
}

const SparseMatrix& Swinging::stiffness(ConstDofs x, Real velocity_rate, Curvature curvature) {
    const Index n = size();
    Mat<2> H = K_;
    if (!linear()) {
        const Real bend = options_.omega == 0 ? 1 : std::cos(x[0] / length_);
        H(0, 0) *= curvature == Curvature::positive ? std::max(bend, Real{0}) : bend;
    }
    H += velocity_rate * C_;
    for (Index k = 0; k < n * n; ++k) matrix_.valuePtr()[k] = H(k % n, k / n);
    return matrix_;
}

Motion Swinging::exact_mode(Index mode, Real t) const {
    const Motion start{modes_.col(mode).sum() * options_.start.x, modes_.col(mode).sum() * options_.start.v};
    return damped_oscillator(rates_[mode], options_.zeta, start, t);
}

std::optional<Motion> Swinging::exact(Index mass, Real t) const {
    if (options_.system == SwingingKind::oscillator) return damped_oscillator(options_.omega, options_.zeta, options_.start, t);
    if (options_.system == SwingingKind::pendulum) {
        if (damped()) return std::nullopt;
        return pendulum_ ? pendulum_->at(t) : damped_oscillator(0, 0, options_.start, t);
    }
    Motion sum;
    for (Index mode = 0; mode < 2; ++mode) {
        const Motion part = exact_mode(mode, t);
        sum.x += modes_(mass, mode) * part.x, sum.v += modes_(mass, mode) * part.v;
    }
    return sum;
}

std::optional<Real> Swinging::exact_energy(Real t) const {
    if (!damped()) return energy(start_position(), start_velocity());
    VecX x(size()), v(size());
    for (Index mass = 0; mass < size(); ++mass) {
        const auto motion = exact(mass, t);
        if (!motion) return std::nullopt;
        x[mass] = motion->x, v[mass] = motion->v;
    }
    return energy(x, v);
}

std::optional<Real> Swinging::pendulum_period() const {
    if (!pendulum_ || damped() || pendulum_->reaches_top()) return std::nullopt;
    return pendulum_->period();
}

}  // namespace pliant
