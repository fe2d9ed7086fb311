// Pressure projection: the pressure whose gradient takes the divergence out of a velocity [Chorin1968; Bridson2007 §4.3].
#pragma once
#include <pliant/fluids/fluid_regions.h>
#include <pliant/fluids/pressure_solve.h>

namespace pliant {

// Solves Δt ∇²p = ∇·ũ for the kinematic pressure p = (pressure)/ρ, m²/s², with ∂p/∂n = 0 at walls and solids and p = 0 at
// a free surface, by conjugate gradients with a preconditioner of choice: by default one multigrid V-cycle
// [McAdamsSifakisTeran2010 §3]. One pass at a time:
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

    // Another preconditioner is made at once and starts its directions anew.
    void set(ProjectionSettings settings);
    const ProjectionSettings& settings() const { return solve_.settings(); }

    // Takes the divergence of `velocity` and starts from the multiple of the last pressure that fits best. Throws Refused for
    // a dt that is not positive, Diverged if the walls' velocities admit no incompressible flow or the velocity is not finite.
    void begin(const FaceField<Dim>& velocity, Real dt);

    bool converged() const { return solve_.converged(); }

    // One pass: the preconditioner and a conjugate-gradient step. Throws Diverged, with the divergence left, when max_iterations
    // passes were not enough or rounding leaves no way down.
    void iterate();

    // velocity −= Δt ∇p on the open faces, with p as it stands.
    void apply(FaceField<Dim>& velocity) const;

    // All of the above. Returns the number of passes.
    Index project(FaceField<Dim>& velocity, Real dt);

    Index iterations() const { return solve_.iterations(); }                     // passes since begin()
    Real initial_divergence() const { return solve_.initial_divergence(); }      // largest |∇·ũ|, 1/s
    Real remaining_divergence() const { return solve_.remaining_divergence(); }  // largest |∇·u| that apply() would leave, 1/s

    // A p = b is solved for p in m²/s² with b = −(Δx²/Δt) ∇·ũ. These four arrays are all that lives from one call to the
    // next: whoever copies them and puts them back continues with the same bits.
    VecX& pressure() { return solve_.pressure(); }
    const VecX& pressure() const { return solve_.pressure(); }
    VecX& residual() { return solve_.residual(); }
    VecX& direction() { return solve_.direction(); }
    VecX& scalars() { return solve_.scalars(); }

    const PoissonOperator<Dim>& laplacian() const { return *laplacian_; }
    const FluidRegions<Dim>& regions() const { return regions_; }

private:
    class Equation;

    void make_preconditioner(PressurePreconditioner kind);

    const StaggeredGrid<Dim>& grid_;
    SurfaceFractions<Dim> fractions_;
    FluidRegions<Dim> regions_;
    PressureSolve solve_;
    std::unique_ptr<Preconditioner<Dim>> preconditioner_;
    std::unique_ptr<PoissonOperator<Dim>> own_laplacian_;  // none where the preconditioner has the operator already
    const PoissonOperator<Dim>* laplacian_ = nullptr;
};

extern template class PressureProjection<2>;
extern template class PressureProjection<3>;

}  // namespace pliant
