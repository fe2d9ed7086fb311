#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/incomplete_cholesky.h>
#include <pliant/fluids/jacobi.h>
#include <pliant/fluids/multigrid.h>
#include <pliant/fluids/pressure_gradient.h>
#include <pliant/fluids/projection.h>

#include <limits>

namespace pliant {

template <int Dim>
class PressureProjection<Dim>::Equation final : public PressureEquation {
public:
    explicit Equation(const PressureProjection& projection) : projection_(projection) {}
    Real multiply(const VecX& x, VecX& y) const override { return projection_.laplacian_->apply(x, y); }
    void precondition(const VecX& r, VecX& z) const override { projection_.preconditioner_->precondition(r, z); }
    void remove_unseen(VecX& p) const override { projection_.regions_.remove_means(p); }

private:
    const PressureProjection& projection_;
};

template <int Dim>
PressureProjection<Dim>::PressureProjection(const StaggeredGrid<Dim>& grid, ProjectionSettings settings)
    : grid_(grid), regions_(grid), solve_(grid.cells().size(), grid.dx()) {
    set(settings);
}

template <int Dim>
void PressureProjection<Dim>::domain_changed(const SurfaceFractions<Dim>& fractions) {
    fractions_ = fractions;
    regions_ = FluidRegions<Dim>(grid_);
    own_laplacian_.reset();
    make_preconditioner(solve_.settings().preconditioner);
}

template <int Dim>
void PressureProjection<Dim>::set(ProjectionSettings settings) {
    const bool another = !preconditioner_ || settings.preconditioner != solve_.settings().preconditioner;
    solve_.set(settings);
    if (!another) return;
    make_preconditioner(settings.preconditioner);
    solve_.forget_directions();
}

template <int Dim>
void PressureProjection<Dim>::make_preconditioner(PressurePreconditioner kind) {
    if (kind == PressurePreconditioner::multigrid) {
        auto multigrid = std::make_unique<Multigrid<Dim>>(grid_, fractions_);
        laplacian_ = &multigrid->finest();
        preconditioner_ = std::move(multigrid);
        own_laplacian_.reset();
        return;
    }
    if (!own_laplacian_) own_laplacian_ = pressure_operator(grid_, fractions_);
    laplacian_ = own_laplacian_.get();
    if (kind == PressurePreconditioner::incomplete_cholesky)
        preconditioner_ = std::make_unique<IncompleteCholesky<Dim>>(grid_, fractions_);
    else if (kind == PressurePreconditioner::jacobi)
        preconditioner_ = std::make_unique<Jacobi<Dim>>(grid_, fractions_);
    else
        preconditioner_ = std::make_unique<NoPreconditioner<Dim>>();
}

template <int Dim>
void PressureProjection<Dim>::begin(const FaceField<Dim>& velocity, Real dt) {
    regions_.check_flux(velocity);
    divergence(grid_, velocity, solve_.residual());
    regions_.remove_means(solve_.residual());
    // Below what rounding leaves of a divergence of 0 there is nothing to solve.
    const Real rounding = 8 * Dim * std::numeric_limits<Real>::epsilon() * max_speed(velocity) / grid_.dx();
    VecX& pressure = solve_.pressure();
    for (Index c = 0; grid_.has_gaps() && c < pressure.size(); ++c)
        if (!grid_.is_fluid(c)) pressure[c] = 0;
    solve_.begin(Equation(*this), dt, rounding);
}

template <int Dim>
void PressureProjection<Dim>::iterate() {
    solve_.iterate(Equation(*this));
}

template <int Dim>
void PressureProjection<Dim>::apply(FaceField<Dim>& velocity) const {
    if (grid_.has_air())
        subtract_gradient(grid_, solve_.pressure(), fractions_, solve_.time_step(), velocity);
    else
        subtract_gradient(grid_, solve_.pressure(), solve_.time_step(), velocity);
}

template <int Dim>
Index PressureProjection<Dim>::project(FaceField<Dim>& velocity, Real dt) {
    begin(velocity, dt);
    while (!converged()) iterate();
    apply(velocity);
    return iterations();
}

template class PressureProjection<2>;
template class PressureProjection<3>;

}  // namespace pliant
