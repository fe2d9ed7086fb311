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

template <int Dim>
Touch touch_of(const Ground& ground, const DiagonalMass& mass, PointsIn<Dim> x, std::span<const Real> arrested, Index node) {
    if (mass.fixed(Dim * node + up)) return Touch::none;
    if (x(up, node) < ground.height) return Touch::below;
    return !arrested.empty() && arrested[static_cast<std::size_t>(node)] > 0 ? Touch::arrested : Touch::none;
}

template <int Dim>
Index resolve_ground_contact(const Ground& ground, const DiagonalMass& mass, Real moved_for, PointsOut<Dim> x, PointsOut<Dim> v,
                             std::span<const Real> arrested) {
    Index touching = 0;
    for (Index n = 0; n < x.cols(); ++n) {
        const Touch touch = touch_of<Dim>(ground, mass, x, arrested, n);
        if (touch == Touch::none) continue;
        const Real already = arrested.empty() ? 0 : arrested[static_cast<std::size_t>(n)];
        const bool below = touch == Touch::below;
        ++touching;
        if (below) x(up, n) = ground.height;
        const Real impact = already + (below ? std::max(-v(up, n), Real(0)) : 0);
        if (impact == 0) continue;
        v(up, n) = std::max(v(up, n), Real(0)) + ground.restitution * impact;

        Vec<Dim> along = v.col(n);
        along[up] = 0;
        const Real speed = along.norm(), most = ground.friction * (1 + ground.restitution) * impact;
        if (speed == 0) continue;
        const Vec<Dim> change = -std::min(Real(1), most / speed) * along;
        v.col(n) += change;
        x.col(n) += moved_for * change;
    }
    return touching;
}

template <int Dim>
void set_ground_bounds(const Ground& ground, PointsIn<Dim> x, VecX& lower_bound) {
    lower_bound.setConstant(x.size(), -std::numeric_limits<Real>::infinity());
    for (Index n = 0; n < x.cols(); ++n) lower_bound[Dim * n + up] = std::min(ground.height, x(up, n));
}

template <int Dim>
void arrested_speeds(const ImplicitSolver& solver, const DiagonalMass& mass, Real dt, std::vector<Real>& arrested) {
    arrested.resize(static_cast<std::size_t>(mass.size() / Dim));
    for (Index n = 0; n < mass.size() / Dim; ++n)
        arrested[static_cast<std::size_t>(n)] = dt * solver.reaction(Dim * n + up) * mass.inverse()[Dim * n + up];
}

#define PLIANT_INSTANTIATE(Dim)                                                                                          \
    template Touch touch_of<Dim>(const Ground&, const DiagonalMass&, PointsIn<Dim>, std::span<const Real>, Index);       \
    template Index resolve_ground_contact<Dim>(const Ground&, const DiagonalMass&, Real, PointsOut<Dim>, PointsOut<Dim>, \
                                               std::span<const Real>);                                                   \
    template void set_ground_bounds<Dim>(const Ground&, PointsIn<Dim>, VecX&);                                           \
    template void arrested_speeds<Dim>(const ImplicitSolver&, const DiagonalMass&, Real, std::vector<Real>&);

PLIANT_INSTANTIATE(2)
PLIANT_INSTANTIATE(3)
#undef PLIANT_INSTANTIATE

}  // namespace pliant
