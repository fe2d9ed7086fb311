// Springs that must not be longer than a part more than at rest: set right after a step, spring by spring [Provot1995].
#pragma once
#include <pliant/solids/springs.h>
#include <pliant/time/mass.h>

namespace pliant {

class StrainLimiter {
public:
    // Of the first `count` springs, which must outlive this. Throws Refused when there are fewer.
    StrainLimiter(const Springs& springs, Index count);

    // One pass: every spring longer than (1 + limit) l, in its order or backwards in turns, draws its ends together to that
    // length, each by its share of inverse mass, and their velocities by as much over dt [Bridson2002 §4]: momentum is kept to
    // rounding, and fixed nodes stay. A spring between two fixed nodes is left alone. Neighbours undo a part, hence the passes.
    // Returns the largest excess over the limit that it met, as a strain.
    Real pass(const DiagonalMass& mass, Real limit, Real dt, PointsOut<3> x, PointsOut<3> v);
    void begin() { passes_ = 0; }
    Index passes() const { return passes_; }  // since begin()

    // Of each spring in the latest pass: node i moved by +p / m_i, node j by -p / m_j; p in kg m.
    const Points<3>& corrections() const { return corrections_; }

private:
    const Springs& springs_;
    Index passes_ = 0;
    Points<3> corrections_;
};

// Largest strain (|x_ij| - l) / l of the first `count` springs; 0 when none is stretched.
Real largest_stretch(const Springs& springs, Index count, PointsIn<3> x);

}  // namespace pliant
