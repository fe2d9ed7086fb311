#include <pliant/math/error.h>
#include <pliant/solids/contact.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {

constexpr int up = 1;

void require_valid(const Ground& ground) {
    if (!std::isfinite(ground.height)) throw Refused("ground height", ground.height, "m", "a finite height");
    if (!(ground.restitution >= 0 && ground.restitution <= 1)) throw Refused("restitution", ground.restitution, "", "0 to 1");
    if (!(ground.friction >= 0) || !std::isfinite(ground.friction))
        throw Refused("friction", ground.friction, "", "a finite number >= 0");
}

Real Approach::impact() const {
    const Real u = speed_at_start(), twice = acceleration() + (late ? acceleration_there : acceleration());
    return std::sqrt(std::max(u * u + height * twice, Real(0)));
}

Real Approach::rebound(Real restitution) const {
    const Real w = restitution * impact();
    if (!late) return w;
    return w <= dt * acceleration_there ? 0 : std::max(w + dt / 2 * acceleration_there, Real(0));
}

template <int Dim>
void GroundContact<Dim>::begin(Real dt, PointsIn<Dim> x, PointsIn<Dim> v) {
    dt_ = dt;
    start_x_ = x;
    start_v_ = v;
    arrested_.clear();
    touches_.assign(static_cast<std::size_t>(x.cols()), Touch::none);
    approaches_.assign(touches_.size(), {});
}

template <int Dim>
void GroundContact<Dim>::arrest(const TimeIntegrator& integrator, const DiagonalMass& mass) {
    arrested_.resize(touches_.size());
    for (Index n = 0; n < mass.size() / Dim; ++n)
        arrested_[static_cast<std::size_t>(n)] =
            integrator.impulse_time() * integrator.solver().reaction(Dim * n + up) * mass.inverse()[Dim * n + up];
}

template <int Dim>
Touch GroundContact<Dim>::touch_of(const Ground& ground, const DiagonalMass& mass, PointsIn<Dim> x, Index node) const {
    if (mass.fixed(Dim * node + up)) return Touch::none;
    if (x(up, node) < ground.height) return Touch::below;
    return taken(node) > 0 ? Touch::arrested : Touch::none;
}

template <int Dim>
Index GroundContact<Dim>::resolve(const Ground& ground, const DiagonalMass& mass, Scheme scheme, const ForceAt& force,
                                  PointsOut<Dim> x, PointsOut<Dim> v) {
    const bool late = scheme == Scheme::semi_implicit_euler;
    Index touching = 0;
    for (Index n = 0; n < x.cols(); ++n) {
        Touch& touch = touches_[static_cast<std::size_t>(n)];
        touch = touch_of(ground, mass, x, n);
        touching += touch != Touch::none;
        if (touch == Touch::below) x(up, n) = ground.height;
    }
    if (touching == 0) return 0;
    force_.setZero(x.size());
    if (late) force(flat(x), flat(v), force_);
    for (Index n = 0; n < x.cols(); ++n) {
        if (touch(n) == Touch::none) continue;
        Approach& approach = approaches_[static_cast<std::size_t>(n)];
        approach = {.height = std::max(start_x_(up, n) - ground.height, Real(0)),
                    .speed = -start_v_(up, n),
                    .free_speed = taken(n) - v(up, n),
                    .dt = dt_,
                    .late = late,
                    .acceleration_there = -force_[Dim * n + up] * mass.inverse()[Dim * n + up]};
        v(up, n) = approach.rebound(ground.restitution);

        Vec<Dim> along = v.col(n);
        along[up] = 0;
        const Real speed = along.norm(), most = ground.friction * std::max(v(up, n) + approach.free_speed, Real(0));
        if (speed == 0) continue;
        const Vec<Dim> change = -std::min(Real(1), most / speed) * along;
        v.col(n) += change;
        if (late) x.col(n) += dt_ * change;
    }
    return touching;
}

template <int Dim>
void set_ground_bounds(const Ground& ground, PointsIn<Dim> x, VecX& lower_bound) {
    lower_bound.setConstant(x.size(), -std::numeric_limits<Real>::infinity());
    for (Index n = 0; n < x.cols(); ++n) lower_bound[Dim * n + up] = std::min(ground.height, x(up, n));
}

template class GroundContact<2>;
template class GroundContact<3>;
template void set_ground_bounds<2>(const Ground&, PointsIn<2>, VecX&);
template void set_ground_bounds<3>(const Ground&, PointsIn<3>, VecX&);

}  // namespace pliant
