// Where the values of a number stand along its slider. Places go from 0 at the left end to 1; every value between the ends has
// one, and each pixel stands for the roundest number within it.
#pragma once
#include <pliant/lesson/parameter.h>

namespace pliant::viewer {

class SliderScale {
public:
    // extreme: it spans all that the solver accepts, else what is useful; in any case also `value`. Logarithmic numbers that may
    // be 0 have 0 at their left end. A range that goes far beyond what is useful, or that a logarithm cannot span, is
    // asinh-shaped: linear in the middle of the useful values, logarithmic far from it.
    SliderScale(const Parameter& parameter, bool extreme, Real value);

    Real least() const { return span_.min; }
    Real greatest() const { return span_.max; }

    Real place(Real value) const;
    Real value_at(Real place) const;
    // The value for a pixel of this width (a part of the slider) at this place: an end at an end, the default where the pixel
    // holds it, else the number of fewest digits within the pixel, a whole one where it has to be.
    Real snapped(Real place, Real pixel) const;
    // So many sensible steps on from a value: to the next multiples of 1, 2 or 5 times a power of ten that is about a fiftieth of
    // the slider; fine: a tenth as long. Whole numbers go by 1 at least.
    Real stepped(Real value, int steps, bool fine = false) const;

private:
    enum class Shape { linear, log, asinh };
    Real shaped(Real value) const;  // the coordinate in which the slider is even
    Real unshaped(Real coordinate) const;
    bool zero_on_the_left() const { return left_ > 0; }
    Real one_step(Real value, int direction, bool fine) const;
    Real within(Real value) const;

    Interval span_;
    Real default_;
    bool whole_;
    Shape shape_ = Shape::linear;
    Real least_positive_ = 0;  // the left end of what is logarithmic
    Real linear_to_ = 1;       // asinh: about where it begins to be logarithmic
    Real left_ = 0;            // the part of the slider, at its left end, that is 0
};

// The roundest number from `from` to `to`: the multiple of the largest 1, 2 or 5 times a power of ten that lies there, of several
// the one nearest to the middle.
Real roundest(Real from, Real to);

}  // namespace pliant::viewer
