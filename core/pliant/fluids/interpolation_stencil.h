// Which samples an interpolated value is made of, and how much each of them counts.
#pragma once
#include <pliant/fluids/padded_field.h>

#include <vector>

namespace pliant {

template <int Dim>
struct WeightedSample {
    Counts<Dim> at{};  // coordinates of the sample; a layer beyond the sides of the lattice counts as one
    Real weight = 0;
};

template <int Dim>
struct InterpolationStencil {
    Counts<Dim> corner{};                      // of the cell of samples that the place lies in: the lowest of them
    GridPlace<Dim> fraction{};                 // how far the place is from it, in [0, 1) along each axis
    std::vector<WeightedSample<Dim>> samples;  // 2^Dim or 4^Dim of them
};

// The stencil of `field.interpolated(at)`. The weights add up to 1, and the weighted sum of the samples is that value but for
// rounding. Those of the monotone cubic depend on the samples where a slope is limited, and some may be negative.
template <int Dim>
InterpolationStencil<Dim> interpolation_stencil(const PaddedField<Dim>& field, const GridPlace<Dim>& at);

extern template InterpolationStencil<2> interpolation_stencil<2>(const PaddedField<2>&, const GridPlace<2>&);
extern template InterpolationStencil<3> interpolation_stencil<3>(const PaddedField<3>&, const GridPlace<3>&);

}  // namespace pliant
