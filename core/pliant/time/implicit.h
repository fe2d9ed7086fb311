// Newton's method for implicit time steps.
#pragma once
#include <pliant/math/conjugate_gradients.h>
#include <pliant/time/bounded_quadratic.h>
#include <pliant/time/integrators.h>
#include <pliant/time/linearised_system.h>
#include <pliant/time/lu_direction.h>

#include <optional>
#include <string>

namespace pliant {

// What a time step needs to know of a system M a = f(x, v). Most have forces f(x, v) = -grad U(x) - C v with a symmetric,
// positive semidefinite damping matrix C, and with them a potential. Where C depends on the positions, an implicit step takes
// its value at one place for the whole of the step: the damping is then linear in v and the step has a potential. Implicit
// Euler takes the start of the step, at an error of the order of dt; schemes of second order take a prediction
// (ImplicitForm::frozen_at), at an error of the order of dt^2.
//
// Any other f(x, v), say a force across the velocity or one that drives the motion, does without: see has_potential().
class SecondOrderSystem {
public:
    virtual ~SecondOrderSystem() = default;

    // Freezes at x what the step does not solve for, the damping matrix's positions.
    virtual void begin_step(ConstDofs x) = 0;
    // Does the force depend on the velocity?
    virtual bool damped() const { return true; }
    // Where not, potential() and dissipation() are not asked for, stiffness() is -df/dx - velocity_rate df/dv, which need not be
    // symmetric, and Newton's method lowers the square of what is unbalanced.
    virtual bool has_potential() const { return true; }
    virtual Real potential(ConstDofs x) const = 0;                   // U, J
    virtual Real dissipation(ConstDofs v) const = 0;                 // 1/2 v . C v, W
    virtual void force(ConstDofs x, ConstDofs v, Dofs f) const = 0;  // N

    // Second derivatives of the potential: as they are, or made positive semidefinite.
    enum class Curvature { exact, positive };
    // grad grad U(x) + velocity_rate C, N/m, symmetric, both triangles stored. Every call refills the values of one matrix,
    // whose pattern never changes and holds every diagonal entry.
    virtual const SparseMatrix& stiffness(ConstDofs x, Real velocity_rate, Curvature curvature) = 0;

    // The same matrix with positive curvature, and with acceleration_rate M, known by its products; it stays as it is until the
    // next call. Null when the system offers none.
    virtual const LinearisedSystem* linearise(ConstDofs /*x*/, Real /*velocity_rate*/, Real /*acceleration_rate*/,
                                              const Mass& /*mass*/) {
        return nullptr;
    }

    // A length that counts as large for this system, m: Newton's steps are measured against it.
    virtual Real length_scale(ConstDofs x) const = 0;
};

// How the linear system of a Newton iteration is solved.
enum class LinearSolve {
    direct,              // factorised, to rounding; exact second derivatives where they are positive definite
    conjugate_gradients  // of the system's linearise(), from 0 or a warm start on: each iteration lowers the model of the
                         // potential, so that one that is cut off early is a step downhill still [Nocedal2006 §7.1, inexact
                         // Newton]
};

// What happens when the cap on Newton's iterations is reached.
enum class AtCap {
    fail,   // finish() throws Diverged
    accept  // the last iterate is taken, whose potential is lower than that of the start; imbalance() tells what is left. With
            // one iteration: the linearly implicit step [Baraff1998]
};

struct NewtonOptions {
    Real relative_step = 1e-9;  // converged when a full step moves no degree of freedom by more, in length scales
    int max_iterations = 100;
    AtCap at_cap = AtCap::fail;
    LinearSolve linear_solve = LinearSolve::direct;
    Real linear_tolerance = 1e-2;  // of conjugate gradients: |residual| / |gradient|
    // Conjugate gradients of a step's first iteration start with the direction of the step before, times what lowers the model
    // most.
    bool warm_start = false;
    int linear_iterations = 1000;  // their cap in each Newton iteration; Newton's method cannot converge in one that reaches it
    bool operator==(const NewtonOptions&) const = default;
};

// Solves an ImplicitForm by minimising the incremental potential
//   Phi(x) = 1/2 a_rate |x - a_origin|_M^2 + U(x) + 1/2 v . C v / v_rate,
// whose gradient is the residual M a_rate (x - a_origin) - f(x, v), by Newton's method. Each pass factorises the sparse matrix
// anew, whose pattern is analysed once, or runs conjugate gradients; neither allocates after the first step. Passes can be run
// one by one: begin(), iterate() while again(), finish().
//
// Full steps may raise the potential for a few passes, as long as it is then lower than before: turning a stiff spring costs a
// detour over its stretching (the Maratos effect). If it is not, the solver goes back and searches along the line for a step
// that lowers it [Nocedal2006 §15.6, watchdog; §3.1, backtracking].
//
// Without a potential, 1/2 |residual|^2 takes its place, and each pass solves with an LU factorisation.
//
// A form with lower bounds is minimised over the positions that keep them: so is the quadratic model of every iteration.
class ImplicitSolver {
public:
    // Both must outlive the solver.
    ImplicitSolver(SecondOrderSystem& system, const Mass& mass, NewtonOptions options = {});

    void set_options(const NewtonOptions& options);

    // The form to be filled by a scheme before begin().
    ImplicitForm& form() { return form_; }
    const ImplicitForm& form() const { return form_; }

    // Starts at the form's prediction or at x, the positions of the start of the step: where the potential is lower. Throws
    // Refused for lower bounds with conjugate gradients or without a potential, and for conjugate gradients of a system
    // that offers no products.
    void begin(ConstDofs x);
    // One Newton iteration. Throws Diverged when no step along its direction lowers the potential.
    void iterate();
    bool converged() const { return converged_; }
    bool again() const { return !converged_ && iterations_ < options_.max_iterations; }
    // Replaces x and v of the start of the step by the solution; fixed degrees of freedom keep their velocity. Throws Diverged,
    // with iterations and residual, when it has not converged, unless the options accept that.
    void finish(Dofs x, Dofs v) const;

    // What a warm start lives on, from one step to the next: for a lesson to list in its state. Empty before the first step.
    VecX& warm_direction() { return warm_direction_; }

    int iterations() const { return iterations_; }
    int factorisations() const { return model_.factorisations(); }  // since the solver was made
    int linear_iterations() const { return linear_iterations_; }    // of conjugate gradients, in this step
    Real residual() const { return residual_norm_; }                // largest free component before the last iteration, N
    // Force with which its lower bound holds a degree of freedom, N, >= 0.
    Real reaction(Index dof) const { return reaction_[dof]; }
    const VecX& position() const { return x_; }  // the current iterate, m
    const VecX& velocity() const { return v_; }  // its velocity, m/s

    // --- what the last iteration did ---
    // With the gradient g and the matrix H of its model at the iterate before it, the direction d fulfils
    // H d = reaction - g - linear_residual where no degree of freedom is fixed. The iterate after it is from() + fraction() d,
    // cut off at the lower bounds.
    const VecX& gradient() const { return residual_; }                 // M a - f(x, v), N; 0 where fixed
    const SparseMatrix& curvature() const { return model_.matrix(); }  // N/m, of the direct solve
    // Of conjugate gradients: the matrix, and what they have left, N. Null and 0 of the direct solve.
    const LinearisedSystem* linearised() const { return linearised_; }
    Real linear_residual(Index dof) const { return linear_residual_.size() ? linear_residual_[dof] : 0; }
    const VecX& direction() const { return direction_; }        // m
    bool searched() const { return fraction_ < 1; }             // did it go back to an earlier iterate, to search from there?
    Real fraction() const { return fraction_; }                 // of the direction, 1 without a search
    const VecX& search_origin() const { return reference_.x; }  // m, of the search
    const VecX& search_direction() const { return reference_.direction; }
    // Did the step begin at the form's prediction, rather than at the positions of the start?
    bool began_at_prediction() const { return began_at_prediction_; }
    // What the current iterate leaves unbalanced, N: M a - f(x, v) less the reactions; 0 where fixed.
    void imbalance(VecX& r) const;

private:
    Real merit(const VecX& x);
    void evaluate_residual();
    void residual_at(const VecX& x, const VecX& v, VecX& r) const;
    void keep_bounds(VecX& x) const;
    void find_direction();
    void factorise_for_direction();
    void solve_for_direction();
    void iterate_for_direction();
    void start_direction();
    Real diagonal(Index dof) const;
    bool last_before_cap() const { return options_.at_cap == AtCap::accept && iterations_ + 1 >= options_.max_iterations; }
    bool step_is_small() const;
    bool at_rounding_level() const;
    void take_guarded_step();
    void search_from_reference();
    bool lower_than_reference(const VecX& x, Real reached);
    [[noreturn]] void fail(const std::string& what) const;

    // Where the last run of full steps started.
    struct Reference {
        VecX x, direction, residual;
        Real potential = 0;
    };

    SecondOrderSystem& system_;
    const Mass& mass_;
    NewtonOptions options_;
    ImplicitForm form_;
    VecX x_, v_, residual_, reaction_, direction_, room_, trial_, scratch_;
    BoundedQuadratic model_;
    LuDirection lu_;
    std::vector<Index> fixed_;
    const LinearisedSystem* linearised_ = nullptr;
    std::optional<ConjugateGradients> gradients_;
    mutable VecX offset_, inertia_;
    VecX linear_residual_, warm_direction_;
    bool linear_converged_ = true;
    Reference reference_;
    int unproved_ = 0;  // full steps since the reference
    bool converged_ = false, began_at_prediction_ = false;
    Real fraction_ = 1;
    int iterations_ = 0, linear_iterations_ = 0;
    Real first_merit_ = 0;  // where the step began
    Real length_ = 0, residual_norm_ = 0, last_step_ = 0;
};

}  // namespace pliant
