#include <pliant/fluids/wave_modes.h>

#include <cmath>
#include <numbers>

namespace pliant {

using std::numbers::pi;

Index WaveModes::greatest() const {
    switch (boundary_) {
        case Boundary::periodic:
            return n_ / 2;
        case Boundary::fixed:
            return n_;
        case Boundary::insulated:
            return n_ - 1;
    }
    return 0;
}

Real WaveModes::phase(Index m) const {
    return (boundary_ == Boundary::periodic ? 2 : 1) * pi * static_cast<Real>(m) / static_cast<Real>(n_);
}

Real WaveModes::shape(Index m, Real s) const {
    switch (boundary_) {
        case Boundary::periodic:
            return std::cos(phase(m) * s);
        case Boundary::fixed:
            return std::sin(phase(m) * (s + 0.5));
        case Boundary::insulated:
            return std::cos(phase(m) * (s + 0.5));
    }
    return 0;
}

VecX WaveModes::along(Index m) const {
    return VecX::NullaryExpr(n_, [&](Index i) { return shape(m, static_cast<Real>(i)); });
}

VecX WaveModes::on_cells(Index m) const {
    const VecX row = along(m);
    if (dimensions_ == 1) return row;
    return (row * row.transpose()).reshaped();
}

Real WaveModes::stencil_factor(Index m) const {
    const Real s = std::sin(phase(m) / 2);
    return 4 * static_cast<Real>(dimensions_) * s * s;
}

bool WaveModes::vanishes(Index m) const { return along(m).squaredNorm() < 1e-20; }

Real WaveModes::amplitude(const VecX& u, Index m) const {
    const VecX row = along(m);
    const Real square = row.squaredNorm();
    if (dimensions_ == 1) return u.dot(row) / square;
    return row.dot(u.reshaped(n_, n_) * row) / (square * square);
}

VecX WaveModes::amplitudes(const VecX& u) const {
    const Index count = greatest() - least() + 1;
    MatX rows(n_, count);
    for (Index k = 0; k < count; ++k) rows.col(k) = along(least() + k);
    const VecX squares = rows.colwise().squaredNorm();
    if (dimensions_ == 1) return (rows.transpose() * u).cwiseQuotient(squares);
    const MatX across = u.reshaped(n_, n_) * rows;
    return rows.cwiseProduct(across).colwise().sum().transpose().cwiseQuotient(squares.cwiseAbs2());
}

}  // namespace pliant
