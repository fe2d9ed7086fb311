// Conjugate gradients for the pressure equation of a grid, one pass at a time, until no cell has more divergence than is asked.
#pragma once
#include <pliant/fluids/preconditioner.h>

namespace pliant {

struct ProjectionSettings {
    Real tolerance = 1e-5;       // of the largest |∇·ũ| that the solver starts from, dimensionless, in (0, 1)
    Index max_iterations = 200;  // at least 1
    PressurePreconditioner preconditioner = PressurePreconditioner::multigrid;
};

// What the conjugate gradients have to know of an equation A p = b, A symmetric and not negative.
class PressureEquation {
public:
    virtual ~PressureEquation() = default;
    virtual Real multiply(const VecX& x, VecX& y) const = 0;      // y = A x. Returns x·y
    virtual void precondition(const VecX& r, VecX& z) const = 0;  // z ≈ A⁻¹ r, symmetric and positive
    virtual void remove_unseen(VecX& p) const = 0;                // subtracts from p what A turns into 0, such as its mean
};

class PressureSolve {
public:
    // For so many cells of the edge dx, in m.
    PressureSolve(Index cells, Real dx);

    // Throws Refused for settings that are out of range.
    void set(const ProjectionSettings& settings);
    const ProjectionSettings& settings() const { return settings_; }
    // The next pass goes straight down, whatever direction the last one had.
    void forget_directions();

    // Starts on b = −(Δx²/Δt) ∇·ũ from the multiple of the last pressure that fits best. residual() holds ∇·ũ on entry, 1/s,
    // which must be in the range of A; what is below `rounding`, 1/s, counts as 0. Throws Refused for a dt that is not positive,
    // Diverged if the divergence is not finite.
    void begin(const PressureEquation& equation, Real dt, Real rounding);

    bool converged() const { return scalars_[remaining] <= scalars_[target]; }

    // One pass. Throws Diverged, with the residual and the divergence left, when max_iterations passes were not enough or
    // rounding leaves no way down.
    void iterate(const PressureEquation& equation);

    Index iterations() const { return static_cast<Index>(scalars_[passes]); }
    Real time_step() const { return scalars_[step]; }                  // s
    Real initial_divergence() const { return scalars_[initial]; }      // largest |∇·ũ|, 1/s
    Real remaining_divergence() const { return scalars_[remaining]; }  // largest |∇·u| that the pressure would leave, 1/s

    // These four arrays are all that lives from one pass to the next.
    VecX& pressure() { return pressure_; }
    const VecX& pressure() const { return pressure_; }
    VecX& residual() { return residual_; }
    const VecX& residual() const { return residual_; }
    VecX& direction() { return direction_; }
    VecX& scalars() { return scalars_; }

private:
    enum Scalar : Index { step, initial, target, remaining, residual_dot_z, passes, scalar_count };

    void start_from_last_pressure(const PressureEquation& equation);
    void measure(Real largest_residual);
    [[noreturn]] void give_up(const char* why) const;

    Real dx_;
    ProjectionSettings settings_;
    VecX pressure_, residual_, direction_, scalars_;
    VecX z_, product_;  // of one pass
};

}  // namespace pliant
