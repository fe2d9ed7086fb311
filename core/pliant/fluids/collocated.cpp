#include <pliant/fluids/collocated.h>

#include <limits>

namespace pliant {
namespace {

// Calls body(cell, axis, cell before, is that inside, cell after, is that inside) for every cell and axis. Beyond a wall lies the
// cell itself.
template <int Dim, class Body>
void for_each_pair(const Lattice<Dim>& cells, Body&& body) {
    for_each_row(cells, [&](Index start, Counts<Dim> at) {
        for (Index i = 0; i < cells.count[0]; ++i) {
            at[0] = i;
            const Index c = start + i;
            for (int a = 0; a < Dim; ++a) {
                const Index n = cells.count[a], stride = cells.stride(a), around = cells.periodic(a) ? (n - 1) * stride : 0;
                const bool first = at[a] == 0, last = at[a] == n - 1;
                body(c, a, first ? c + around : c - stride, !first || cells.periodic(a), last ? c - around : c + stride,
                     !last || cells.periodic(a));
            }
        }
    });
}

}  // namespace

template <int Dim>
void central_divergence(const Lattice<Dim>& cells, Real dx, const Points<Dim>& velocity, VecX& out) {
    out.setZero(cells.size());
    for_each_pair(cells, [&](Index c, int a, Index before, bool before_inside, Index after, bool after_inside) {
        const Real low = velocity(a, before), high = velocity(a, after);
        out[c] += (after_inside ? high : -high) - (before_inside ? low : -low);
    });
    out *= 1 / (2 * dx);
}

template <int Dim>
void central_gradient(const Lattice<Dim>& cells, Real dx, const VecX& p, Points<Dim>& out) {
    out.resize(Dim, cells.size());
    for_each_pair(cells,
                  [&](Index c, int a, Index before, bool, Index after, bool) { out(a, c) = (p[after] - p[before]) / (2 * dx); });
}

template <int Dim>
std::vector<VecX> invisible_pressures(const Lattice<Dim>& cells) {
    std::vector<VecX> patterns{VecX::Ones(cells.size())};
    for (int a = 0; a < Dim; ++a) {
        if (!cells.periodic(a) || cells.count[a] % 2 != 0) continue;
        const std::size_t before = patterns.size();
        for (std::size_t k = 0; k < before; ++k) {
            VecX alternating = patterns[k];
            for (Index c = 0; c < alternating.size(); ++c)
                if (cells.coordinates(c)[a] % 2 != 0) alternating[c] = -alternating[c];
            patterns.push_back(std::move(alternating));
        }
    }
    return patterns;
}

template <int Dim>
class CollocatedProjection<Dim>::Equation final : public PressureEquation {
public:
    explicit Equation(const CollocatedProjection& projection) : projection_(projection) {}
    Real multiply(const VecX& x, VecX& y) const override { return projection_.multiply(x, y); }
    void precondition(const VecX& r, VecX& z) const override { z = r; }
    void remove_unseen(VecX& p) const override {
        for (const VecX& pattern : projection_.invisible_) p -= pattern.dot(p) / static_cast<Real>(p.size()) * pattern;
    }

private:
    const CollocatedProjection& projection_;
};

template <int Dim>
CollocatedProjection<Dim>::CollocatedProjection(const Lattice<Dim>& cells, Real dx, ProjectionSettings settings)
    : cells_(cells), dx_(dx), solve_(cells.size(), dx), invisible_(invisible_pressures(cells)) {
    set(settings);
}

template <int Dim>
Real CollocatedProjection<Dim>::multiply(const VecX& x, VecX& y) const {
    central_gradient(cells_, dx_, x, gradient_);
    central_divergence(cells_, dx_, gradient_, y);
    y *= -dx_ * dx_;
    return x.dot(y);
}

template <int Dim>
void CollocatedProjection<Dim>::begin(const Points<Dim>& velocity, Real dt) {
    central_divergence(cells_, dx_, velocity, solve_.residual());
    const Real speed = velocity.size() > 0 ? velocity.cwiseAbs().maxCoeff() : 0;
    const Equation equation(*this);
    equation.remove_unseen(solve_.residual());
    solve_.begin(equation, dt, 8 * Dim * std::numeric_limits<Real>::epsilon() * speed / dx_);
}

template <int Dim>
void CollocatedProjection<Dim>::iterate() {
    solve_.iterate(Equation(*this));
}

template <int Dim>
void CollocatedProjection<Dim>::apply(Points<Dim>& velocity) const {
    central_gradient(cells_, dx_, solve_.pressure(), gradient_);
    velocity -= solve_.time_step() * gradient_;
}

template <int Dim>
Index CollocatedProjection<Dim>::project(Points<Dim>& velocity, Real dt) {
    begin(velocity, dt);
    while (!converged()) iterate();
    apply(velocity);
    return iterations();
}

template void central_divergence(const Lattice<2>&, Real, const Points<2>&, VecX&);
template void central_divergence(const Lattice<3>&, Real, const Points<3>&, VecX&);
template void central_gradient(const Lattice<2>&, Real, const VecX&, Points<2>&);
template void central_gradient(const Lattice<3>&, Real, const VecX&, Points<3>&);
template std::vector<VecX> invisible_pressures(const Lattice<2>&);
template std::vector<VecX> invisible_pressures(const Lattice<3>&);
template class CollocatedProjection<2>;
template class CollocatedProjection<3>;

}  // namespace pliant
