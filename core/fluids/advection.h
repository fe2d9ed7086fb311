// Advection: how a quantity is carried along by the flow, ∂q/∂t + u·∇q = 0.
#pragma once
#include <pliant/fluids/velocity_sampler.h>

namespace pliant {

// Semi-Lagrangian advection [Stam1999 §3.2; Bridson2007 §3]: the new value at a sample is the old value where the particle
// that arrives there was one step ago, found by the midpoint rule and interpolated linearly. Every new value is a weighted
// mean of old values and of wall values, so that the largest magnitude never grows, at any time step; the interpolation
// dissipates. Closed faces keep their value.
template <int Dim>
class SemiLagrangian {
public:
    // Keeps a reference to the grid.
    explicit SemiLagrangian(const StaggeredGrid<Dim>& grid);

    // Carries the velocity along itself for dt seconds.
    void advect(FaceField<Dim>& velocity, Real dt);

    // Carries a cell-centred quantity along `velocity` for dt seconds.
    void advect(VecX& quantity, const FaceField<Dim>& velocity, Real dt);

    // The velocity that carried the latest advection.
    const VelocitySampler<Dim>& flow() const { return flow_; }

private:
    void advect_component(int axis, Real cells_per_speed, VecX& out);
    void velocity_at_faces(int axis, const Counts<Dim>& at);
    void trace_back(const GridPlace<Dim>& first, Index n, Real cells_per_speed);
    void step_back(const GridPlace<Dim>& first, Index n, Real cells_per_speed);

    const StaggeredGrid<Dim>& grid_;
    VelocitySampler<Dim> flow_;
    PaddedField<Dim> quantity_;
    // One row of particles: where they are, in cells, along each axis, and how fast.
    AxisArrays<Dim> place_, speed_;
    VecX ramp_;  // 0, 1, 2, ...
};

extern template class SemiLagrangian<2>;
extern template class SemiLagrangian<3>;

}  // namespace pliant
