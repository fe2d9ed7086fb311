// One time step of M a = f(x, v) by any scheme, as a whole or pass by pass.
#pragma once
#include <pliant/time/implicit.h>
#include <pliant/time/scheme.h>

#include <optional>

namespace pliant {

// Runs a step in passes: an explicit scheme evaluates the force once in each pass, an implicit one makes one Newton iteration.
// begin(), pass() while again(), finish(); or step(), which is the same. A step allocates nothing but for the matrix of the
// first implicit one. Fixed degrees of freedom keep their velocity.
class TimeIntegrator {
public:
    // Both must outlive the integrator. The system's pattern must not change: make another integrator then.
    TimeIntegrator(SecondOrderSystem& system, const Mass& mass, Scheme scheme = Scheme::semi_implicit_euler,
                   NewtonOptions options = {});

    // Forgets what lives between steps. Nothing happens when it is the scheme already.
    void set_scheme(Scheme scheme);
    Scheme scheme() const { return scheme_; }
    void set_options(NewtonOptions options);
    // m: where an implicit step must not end below; empty (the default) when there is no bound.
    VecX& lower_bound() { return lower_bound_; }

    // force: at (x, v), N, where the caller has it already. Throws Refused for a dt that is not positive and finite.
    void begin(Real dt, ConstDofs x, ConstDofs v, const VecX* force = nullptr);
    bool again() const;
    void pass();
    // Replaces x and v by those of the end of the step. Throws Diverged when Newton's method has not converged.
    void finish(Dofs x, Dofs v);
    void step(Real dt, Dofs x, Dofs v);

    // The end of the step, once all passes are done; before, the place and velocity that the next pass evaluates the force at, or
    // the latest Newton iterate.
    const VecX& position() const { return implicit() ? solver_->position() : x_; }  // m
    const VecX& velocity() const { return implicit() ? solver_->velocity() : v_; }  // m/s
    // M^-1 f of an explicit pass of this step, m/s^2.
    const VecX& acceleration(Index pass) const { return accelerations_[static_cast<std::size_t>(pass)]; }
    Index passes() const { return passes_; }  // done in this step
    // Of an implicit scheme only.
    const ImplicitSolver& solver() const { return *solver_; }
    ImplicitSolver& solver() { return *solver_; }
    // Of an implicit scheme: the velocity at the end of a step that a force at the place it solves for adds, times mass over
    // force, s. The step's length for implicit Euler and the midpoint rule, half of it for Newmark's scheme, 2/3 for BDF2.
    Real impulse_time() const;

    // Counted since made: by explicit schemes, and for the start of a Newmark step.
    Index force_evaluations() const { return force_evaluations_; }

    // What lives from one step to the next: the state before the start for BDF2, the last force of velocity Verlet where it is
    // the first of the next step. For a lesson to list in its state; empty for the other schemes.
    VecX& memory() { return memory_; }
    // To be called when positions, velocities or forces were changed from outside. BDF2 begins with a step of implicit Euler.
    void forget();

private:
    bool implicit() const { return solver_.has_value(); }
    void begin_explicit(const VecX* force);
    void begin_implicit(const VecX* force);
    void explicit_pass();
    void evaluate(VecX& acceleration);
    bool remembers() const { return memory_.size() > 0 && memory_[0] > 0; }
    void remember();

    SecondOrderSystem& system_;
    const Mass& mass_;
    NewtonOptions options_;
    Scheme scheme_;
    std::optional<ImplicitSolver> solver_;
    Real dt_ = 0;
    Index passes_ = 0, force_evaluations_ = 0;
    bool first_known_ = false;  // is the first acceleration there without an evaluation?
    VecX start_x_, start_v_, x_, v_, force_, lower_bound_, memory_;
    std::array<VecX, 4> accelerations_;
};

}  // namespace pliant
