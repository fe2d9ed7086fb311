// Pressure projection: the pressure whose gradient takes the divergence out of a velocity [Chorin1968; Bridson2007 §4.3].
#pragma once
#include <pliant/fluids/fluid_regions.h>
#include <pliant/fluids/multigrid.h>

namespace pliant {

struct ProjectionSettings {
    Real tolerance = 1e-5;       // of the largest |∇·ũ| that the solver starts from, dimensionless, in (0, 1)
    Index max_iterations = 200;  // at least 1
};

// Solves Δt ∇²p = ∇·ũ for the kinematic pressure p = (pressure)/ρ, m²/s², with ∂p/∂n = 0 at walls and solids and p = 0 at
// a free surface, by conjugate
// gradients preconditioned with one multigrid V-cycle [McAdamsSifakisTeran2010 §3]. One pass at a time:
//
//     projection.begin(velocity, dt);
//     while (!projection.converged()) projection.iterate();
//     projection.apply(velocity);        // u = ũ − Δt ∇p
//
// apply() may follow any pass: the gradient of each iterate is orthogonal to the velocity that it leaves, so that every pass
// takes kinetic energy out and none puts any in. Each closed region of fluid has its own pressure constant; the pressure
// returned has mean 0 in each.
template <int Dim>
class PressureProjection {
public:
    // Keeps a reference to the grid. Throws Refused for settings that are out of range.
    explicit PressureProjection(const StaggeredGrid<Dim>& grid, ProjectionSettings settings = {});

    // The cells of the grid have changed, or where its surface lies. fractions: of the surface faces, if the grid has air.
    void domain_changed(const SurfaceFractions<Dim>& fractions = {});

    void set(ProjectionSettings settings);
    const ProjectionSettings& settings() const { return settings_; }

    // Takes the divergence of `velocity` and starts from the multiple of the last pressure that fits best. Throws Refused for
    // a dt that is not positive, Diverged if the walls' velocities admit no incompressible flow or the velocity is not finite.
    void begin(const FaceField<Dim>& velocity, Real dt);

    bool converged() const;

    // One pass: a V-cycle and a conjugate-gradient step. Throws Diverged, with the divergence left, when max_iterations
    // passes were not enough or rounding leaves no way down.
    void iterate();

    // velocity −= Δt ∇p on the open faces, with p as it stands.
    void apply(FaceField<Dim>& velocity) const;

    // All of the above. Returns the number of passes.
    Index project(FaceField<Dim>& velocity, Real dt);

    Index iterations() const;           // passes since begin()
    Real initial_divergence() const;    // largest |∇·ũ|, 1/s
    Real remaining_divergence() const;  // largest |∇·u| that apply() would leave, 1/s

    // A p = b is solved for p in m²/s² with b = −(Δx²/Δt) ∇·ũ. These four arrays are all that lives from one call to the
    // next: whoever copies them and puts them back continues with the same bits.
    VecX& pressure() { return pressure_; }
    const VecX& pressure() const { return pressure_; }
    VecX& residual() { return residual_; }
    VecX& direction() { return direction_; }
    VecX& scalars() { return scalars_; }

    const PoissonOperator<Dim>& laplacian() const { return multigrid_.finest(); }
    const FluidRegions<Dim>& regions() const { return regions_; }

private:
    enum Scalar : Index { time_step, initial, target, remaining, residual_dot_z, passes, scalar_count };

    void start_from_last_pressure();
    void measure();
    [[noreturn]] void give_up(const char* why) const;

    const StaggeredGrid<Dim>& grid_;
    ProjectionSettings settings_;
    SurfaceFractions<Dim> fractions_;
    FluidRegions<Dim> regions_;
    Multigrid<Dim> multigrid_;
    VecX pressure_, residual_, direction_, scalars_;
    VecX z_, product_;  // of one pass
};

extern template class PressureProjection<2>;
extern template class PressureProjection<3>;

}  // namespace pliant
