// What the velocity of a staggered grid says about the flow.
#pragma once
#include <pliant/fluids/velocity_sampler.h>

namespace pliant {

// ∇·u of every cell, 1/s: the flux through its faces over its volume [Bridson2007 §4.3]. Solid cells get 0.
template <int Dim>
void divergence(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity, VecX& out);

// Largest |∇·u| over the fluid cells, 1/s.
template <int Dim>
Real max_divergence(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity);

// ∫ u·v dV over the fluid, m^(Dim+2)/s². A face belongs half to each of the two cells beside it, so that a face on a wall counts
// half.
template <int Dim>
Real inner_product(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& u, const FaceField<Dim>& v);

// ½ ∫ |u|² dV over the fluid, m^(Dim+2)/s²: times the density it is the kinetic energy.
template <int Dim>
Real kinetic_energy(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity);

// Largest component of the velocity on any face, m/s.
template <int Dim>
Real max_speed(const FaceField<Dim>& velocity);

// Courant number: the number of cells that the fastest face value crosses in one step, max|u| Δt/Δx.
template <int Dim>
Real courant_number(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity, Real dt);

// The velocity at cell centres, the mean of the two faces across each axis, m/s.
template <int Dim>
void cell_velocity(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity, Points<Dim>& out);

// ∂v/∂x − ∂u/∂y of every cell of a plane flow, 1/s: the mean over the cell's corners of the circulation around a corner over
// Δx². `flow` holds the velocity and says how it continues beyond the walls.
void vorticity(const StaggeredGrid<2>& grid, const VelocitySampler<2>& flow, VecX& out);

}  // namespace pliant
