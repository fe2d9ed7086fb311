#pragma once
#include <pliant/fluids/staggered_grid.h>

namespace pliant {

// velocity −= scale (p above − p below) / Δx on every open face, where p holds one value per cell [Bridson2007 §4.3.1].
template <int Dim>
void subtract_gradient(const StaggeredGrid<Dim>& grid, const VecX& p, Real scale, FaceField<Dim>& velocity);

// The same at a free surface: where the pressure falls to 0 within the part θ of the way to the next centre, its slope is
// steeper.
template <int Dim>
void subtract_gradient(const StaggeredGrid<Dim>& grid, const VecX& p, const SurfaceFractions<Dim>& fractions, Real scale,
                       FaceField<Dim>& velocity);

}  // namespace pliant
