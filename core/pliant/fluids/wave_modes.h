// The Fourier modes of the stencil on a row of cells whose two ends are of one kind, and on a square of such rows, where a mode
// is the product of the same wave along both axes. One step of diffusion multiplies each mode by a factor and mixes none.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

class WaveModes {
public:
    enum class Boundary {
        periodic,  // mode m: m waves over the length, cos(2πm i/n) in cell i
        fixed,     // m half waves that vanish at the walls: sin(πm (i + ½)/n)
        insulated  // m half waves that are level at the walls: cos(πm (i + ½)/n)
    };

    // dimensions: 1 or 2.
    WaveModes(Boundary boundary, Index cells, int dimensions) : boundary_(boundary), n_(cells), dimensions_(dimensions) {}

    // The modes that n cells tell apart: from least() to greatest(). Any other one looks like one of them, or like nothing.
    Index least() const { return boundary_ == Boundary::fixed ? 1 : 0; }
    Index greatest() const;

    // κ = k Δx: by how much the wave advances from one cell to the next, rad.
    Real phase(Index m) const;
    // Its value at s cells from the middle of the first cell, along one axis.
    Real shape(Index m, Real s) const;
    // On all cells, axis 0 fastest.
    VecX on_cells(Index m) const;

    // Λ = 4 sin²(κ/2) per axis: the stencil Σ u_n − 2 Dim u multiplies the mode by −Λ.
    Real stencil_factor(Index m) const;
    // κ² per axis, which Λ tends to for long waves: Δx² ∇² multiplies the mode by −κ².
    Real laplace_factor(Index m) const { return static_cast<Real>(dimensions_) * phase(m) * phase(m); }

    // Is the mode 0 on every cell: none at all (m = 0 between fixed walls), or one that the cells do not see? It has no part in
    // what they hold, and no factor.
    bool vanishes(Index m) const;

    // The part of a quantity that has the shape of the mode: Σ u φ / Σ φ². The mode does not vanish.
    Real amplitude(const VecX& u, Index m) const;
    // Of all modes from least() to greatest().
    VecX amplitudes(const VecX& u) const;

private:
    VecX along(Index m) const;  // on the cells of one axis

    Boundary boundary_;
    Index n_;
    int dimensions_;
};

}  // namespace pliant
