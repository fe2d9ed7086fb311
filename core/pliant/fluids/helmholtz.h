// The Helmholtz decomposition of a velocity: a gradient, a part without divergence, and a uniform drift.
#pragma once
#include <pliant/fluids/pressure_solve.h>

namespace pliant {

// velocity = drift + gradient + solenoidal, orthogonal to each other in inner_product() wherever the walls are at rest.
template <int Dim>
struct HelmholtzParts {
    VecX potential;                     // φ, m²/s, one per cell, of mean 0 in every region
    FaceField<Dim> gradient;            // ∇φ, m/s; 0 on closed faces
    FaceField<Dim> solenoidal;          // without divergence, with the walls' velocity on closed faces
    Vec<Dim> drift = Vec<Dim>::Zero();  // m/s: the mean along each periodic axis of a box without solids; it is the harmonic
                                        // part, which is both a gradient and without divergence. 0 along other axes
};

// φ from ∇²φ = ∇·u, on a grid without air. Throws Refused if there is some, Diverged as PressureProjection does.
template <int Dim>
HelmholtzParts<Dim> helmholtz_parts(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity,
                                    const ProjectionSettings& settings = {1e-12, 1000});

// The same with a potential that is known already, such as Δt p of a projection.
template <int Dim>
HelmholtzParts<Dim> helmholtz_parts(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity, VecX potential);

}  // namespace pliant
