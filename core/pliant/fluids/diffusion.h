// Diffusion, ∂q/∂t = ν ∇²q, of any quantity on a lattice, and of the velocity: viscosity.
#pragma once
#include <pliant/fluids/box_laplacian.h>
#include <pliant/fluids/staggered_grid.h>

#include <cmath>
#include <optional>

namespace pliant {

struct DiffusionSettings {
    Real tolerance = 1e-8;         // largest error of an implicit step, relative to the quantity and the wall values (2-norm)
    Index max_iterations = 10000;  // of the conjugate gradients
};

// All steps are written with the diffusion number r = ν Δt/Δx². A Fourier mode of wave numbers k_a is multiplied by
// 1 − 4r Σ sin²(k_a Δx/2) in an explicit step and by 1/(1 + 4r Σ sin²(k_a Δx/2)) in an implicit one.
template <int Dim>
class Diffusion {
public:
    // The samples in `held` keep their values.
    explicit Diffusion(const Lattice<Dim>& lattice, std::vector<Index> held = {});

    // Above this diffusion number an explicit step amplifies the checkerboard: 1/(2 Dim).
    static constexpr Real explicit_limit() { return Real(1) / (2 * Dim); }

    // Σ q_neighbour − 2 Dim q_i, which is Δx² ∇²q, one number per sample in the unit of q; 0 at held samples.
    void stencil(const VecX& q, VecX& out) const { rate_of_change(q, 1, out); }

    // q_i += r (Σ q_neighbour − 2 Dim q_i): the explicit stencil, at any r. Beyond explicit_limit() repeated steps explode.
    void explicit_step(VecX& q, Real r);

    // Backward Euler: solves q_i − r (Σ q_neighbour − 2 Dim q_i) = old q_i by conjugate gradients. Returns the iterations.
    // Stable at any r. Throws Diverged, with the residual, at max_iterations.
    Index implicit_step(VecX& q, Real r, const DiffusionSettings& settings = {});

    // The same step, one iteration at a time: begin with the old q, iterate on it until converged. An iteration after that
    // changes nothing.
    void begin_implicit(const VecX& q, Real r, const DiffusionSettings& settings = {});
    void iterate(VecX& q);
    bool converged() const { return residual_norm() <= target_; }
    Index iterations() const { return iterations_; }

    // What the latest implicit step left of its equation: (old q + wall terms) − A q, in the unit of q; 0 at held samples.
    const VecX& residual() const { return residual_; }
    // Its 2-norm, and the one that was asked for.
    Real residual_norm() const { return std::sqrt(square_); }
    Real target() const { return target_; }

private:
    void zero_held(VecX& values) const;
    void rate_of_change(const VecX& q, Real r, VecX& out) const;
    Real magnitude(const VecX& q) const;

    BoxLaplacian<Dim> laplacian_;
    std::vector<Index> held_;
    Real largest_wall_value_ = 0;
    VecX residual_, direction_, product_;
    // Of the implicit step that was begun last.
    Real r_ = 0, square_ = 0, target_ = 0;
    Index iterations_ = 0, max_iterations_ = 0;
};

// The viscous term ν ∇²u of the Navier-Stokes equations with the walls' conditions: the tangential velocity meets the wall's
// where the fluid sticks and has no gradient where it slides; closed faces keep their value.
template <int Dim>
class Viscosity {
public:
    // Keeps a reference to the grid. Nothing is allocated before the first step with a viscosity above 0.
    explicit Viscosity(const StaggeredGrid<Dim>& grid) : grid_(grid) {}

    // The largest time step for which the explicit scheme is stable: Δx²/(2 Dim ν), s; infinite for ν = 0.
    Real explicit_limit(Real viscosity) const;

    // Both take the kinematic viscosity ν in m²/s and Δt in s, do nothing for ν = 0, and throw Refused for a negative or
    // infinite ν; the explicit one throws Refused, naming the limit, for a time step beyond it.
    void diffuse_explicitly(FaceField<Dim>& velocity, Real viscosity, Real dt);
    // Returns the solver's iterations over all components.
    Index diffuse_implicitly(FaceField<Dim>& velocity, Real viscosity, Real dt, const DiffusionSettings& settings = {});
    // What the latest implicit step left of the equations of one component, m/s, one per face; after a step was made.
    const VecX& residual(int axis) const { return components_[axis]->residual(); }

private:
    Diffusion<Dim>& component(int axis);

    const StaggeredGrid<Dim>& grid_;
    std::array<std::optional<Diffusion<Dim>>, Dim> components_;
};

extern template class Diffusion<2>;
extern template class Diffusion<3>;
extern template class Viscosity<2>;
extern template class Viscosity<3>;

}  // namespace pliant
